// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/ImageMemory.h"

#include "Core/Base/Errors.h"

#include <vtkAbstractArray.h>
#include <vtkDataSetAttributes.h>

#include <cmath>
#include <new>

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

void requireMemory(const std::string& what, double bytes, const std::string& remedy)
{
  // Not an expression with new, which may be optimised away. More than what fits in a std::size_t is
  // never there.
  void* const memory =
    bytes < 0x1p63 ? ::operator new(static_cast<std::size_t>(bytes), std::nothrow) : nullptr;
  ::operator delete(memory);
  if (memory == nullptr)
  {
    throw InvalidInput(what + " takes " + formatted(std::ceil(bytes / 1e8) / 10.0) +
                       " GB of memory, more than there is: " + remedy);
  }
}

void requireImageMemory(int width, int height, std::size_t bytes, const std::string& remedy)
{
  requireMemory("an image of " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
    static_cast<double>(width) * height * static_cast<double>(bytes),
    remedy);
}

} // namespace flattening
