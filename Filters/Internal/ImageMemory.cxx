// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/ImageMemory.h"

#include "Core/Base/Memory.h"

#include <vtkAbstractArray.h>
#include <vtkDataSetAttributes.h>

namespace flattening
{

std::size_t bytesPerTuple(vtkDataSetAttributes* attributes)
{
  std::size_t bytes = 0;
  for (int a = 0; a < attributes->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(a);
    bytes += static_cast<std::size_t>(array->GetNumberOfComponents()) * array->GetDataTypeSize();
  }
  return bytes;
}

void requireImageMemory(int width, int height, std::size_t bytes, const std::string& remedy)
{
  requireMemory("an image of " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
    static_cast<double>(width) * height * static_cast<double>(bytes),
    remedy);
}

} // namespace flattening
