// SPDX-License-Identifier: GPL-3.0-or-later
/// Standard computations whose times are yardsticks for the others.
#pragma once

#include "Base/SparseFactorization.h"
#include "Mesh/TriangleMesh.h"

#include <chrono>
#include <ctime>

namespace flattening::benchmarks
{

class StopWatch
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }
  /// Processor time of all threads together, which depends less on other programs than wall-clock time.
  double processorSeconds() const
  {
    return static_cast<double>(std::clock() - this->ProcessorStart) / CLOCKS_PER_SEC;
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  std::clock_t ProcessorStart = std::clock();
};

/// The mesh's Laplacian with one vertex held, all weights 1: cotangents would be factored in the same
/// time.
SparseMatrix meshLaplacian(const TriangleMesh& mesh);

} // namespace flattening::benchmarks
