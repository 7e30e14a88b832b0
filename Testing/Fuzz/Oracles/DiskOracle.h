// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether the output of Surface To Disk is what it promises to be.
#pragma once

#include "../Findings.h"

class vtkPolyData;

namespace fuzz
{

/// One connected manifold disk of finite points, consistently oriented, whose arrays and figures are
/// true.
void checkDisk(vtkPolyData* disk, vtkPolyData* input, Findings& findings);

} // namespace fuzz
