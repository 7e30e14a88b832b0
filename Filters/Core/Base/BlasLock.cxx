// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/BlasLock.h"

#ifdef SURFACEFLATTENING_OPENMP
#include <omp.h>
#endif

#include <memory>
#include <new>

namespace flattening
{
namespace
{

std::mutex& blas()
{
  static std::mutex mutex;
  return mutex;
}

// The first call of OpenBLAS takes a work area, and tries again without end where it gets none.
void requireWorkArea()
{
  constexpr std::size_t WorkArea = std::size_t(160) << 20; // OpenBLAS 0.3 takes 129 MiB
  static bool wasFound = false;
  if (!wasFound)
  {
    const std::unique_ptr<char[]> area(
      new (std::nothrow) char[WorkArea]); // not touched: it costs nothing
    if (!area)
    {
      throw std::bad_alloc();
    }
    wasFound = true;
  }
}

} // namespace

BlasLock::BlasLock()
  : Lock(blas())
{
  requireWorkArea();
#ifdef SURFACEFLATTENING_OPENMP
  this->OpenMPLevels = omp_get_max_active_levels();
  omp_set_max_active_levels(0);
#endif
}

BlasLock::~BlasLock()
{
#ifdef SURFACEFLATTENING_OPENMP
  omp_set_max_active_levels(this->OpenMPLevels);
#endif
}

} // namespace flattening
