// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether two data objects are the same, bit for bit.
#pragma once

#include <string>

class vtkDataObject;

namespace fuzz
{

/// A difference between the points, cells, arrays or field data, in words; empty if there is none.
std::string difference(vtkDataObject* a, vtkDataObject* b);

} // namespace fuzz
