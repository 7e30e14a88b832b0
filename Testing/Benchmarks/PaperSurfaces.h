// SPDX-License-Identifier: GPL-3.0-or-later
/// Surfaces of the kinds and sizes in Tables 1 and 2 of the paper, whose own surfaces are not public.
#pragma once

#include "BenchmarkSurfaces.h"

#include <functional>
#include <string>
#include <vector>

namespace flattening::benchmarks
{

/// A row of the paper's tables. Seconds are those of its "AP", on a Core 2 Duo of 2.2 GHz.
struct PaperSurface
{
  std::string Name;
  std::function<BenchmarkSurface()> Load;
  int Vertices; ///< in the paper
  double Seconds;
  double MinimalFlowSeconds = 0.0;  ///< Table 1, Dominitz and Tannenbaum; 0: not given
  double LieAdvectionSeconds = 0.0; ///< Table 1, Zou et al.; 0: not given
};

/// The rows of the tables; rows that share a mesh in the paper (hemisphere, square, Gaussian) are one.
/// @p scan is the file of the brain.
std::vector<PaperSurface> paperSurfaces(const std::string& scan);

} // namespace flattening::benchmarks
