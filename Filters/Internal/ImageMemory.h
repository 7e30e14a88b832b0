// SPDX-License-Identifier: GPL-3.0-or-later
/// The memory of an image whose size the user sets.
#pragma once

#include <cstddef>
#include <string>

class vtkDataSetAttributes;

namespace flattening
{

/// Bytes of one tuple of all arrays together.
std::size_t bytesPerTuple(vtkDataSetAttributes* attributes);

/// Asks for the memory of an image. VTK ends the program where memory for one of its arrays cannot be
/// had, so that this must be known before.
/// @param bytes of each of the @p width x @p height pixels, those of intermediate results too
/// @param remedy what the user can do, such as "set a smaller Size"
/// @throws InvalidInput if there is not as much memory
void requireImageMemory(int width, int height, std::size_t bytes, const std::string& remedy);

} // namespace flattening
