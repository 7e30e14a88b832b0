// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/SeamFlags.h"

#include <cstddef>

namespace flattening
{

std::vector<char> flagsOf(const VertexOrigins& origins, const std::vector<char>& flags, bool all)
{
  std::vector<char> result(origins.rows(), all);
  for (int v = 0; v < origins.rows(); ++v)
  {
    for (VertexOrigins::InnerIterator origin(origins, v); origin; ++origin)
    {
      result[v] = all ? result[v] && flags[origin.col()] : result[v] || flags[origin.col()];
    }
  }
  return result;
}

int countOnSeam(const std::vector<char>& flags, const CutSurface& cut)
{
  int count = 0;
  for (std::size_t v = 0; v < flags.size(); ++v)
  {
    count += flags[v] && cut.OnSeam[v] ? 1 : 0;
  }
  return count;
}

} // namespace flattening
