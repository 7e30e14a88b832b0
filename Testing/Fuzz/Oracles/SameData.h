// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether two data objects are the same, bit for bit.
#pragma once

#include <string>

class vtkDataObject;

namespace fuzz
{

/// What differs between the points, cells, arrays and field data; empty if nothing does.
std::string difference(vtkDataObject* a, vtkDataObject* b);

} // namespace fuzz
