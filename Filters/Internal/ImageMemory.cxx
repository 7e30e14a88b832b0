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

void requireImageMemory(int width, int height, std::size_t bytes, const std::string& remedy)
{
  const std::size_t total = static_cast<std::size_t>(width) * height * bytes;
  try
  {
    ::operator delete(::operator new(total)); // not an expression with new, which may be optimised away
  }
  catch (const std::bad_alloc&)
  {
    throw InvalidInput("an image of " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels takes " + formatted(std::ceil(static_cast<double>(total) / 1e8) / 10.0) +
                       " GB of memory, more than there is: " + remedy);
  }
}

} // namespace flattening
