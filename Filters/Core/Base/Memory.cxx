// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Memory.h"

#include "Base/Errors.h"

#include <cmath>
#include <new>

namespace flattening
{

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

} // namespace flattening
