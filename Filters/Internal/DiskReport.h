// SPDX-License-Identifier: GPL-3.0-or-later
/// What Surface To Disk tells about its changes: a table that can be read, and warnings.
#pragma once

#include "Core/Disk/SurfaceToDiskOptions.h"

#include <string>
#include <vector>

class vtkTable;

namespace flattening
{

/// Fills the table with a row for each change, in the order of the steps: how much, what, and the label
/// of the parameter in ParaView that decides it. Rows of nothing are left out, but those that tell how
/// the disk was opened and its measures are always there.
void setReportTable(vtkTable* table, const SurfaceToDiskReport& report);

/// Sentences about changes that are no noise: parts of the surface that are lost, and holes and seams
/// that a flat map or a region of interest does not go well with.
std::vector<std::string> warningsOf(const SurfaceToDiskReport& report);

} // namespace flattening
