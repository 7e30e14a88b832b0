// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/BlasLock.h"

#ifdef SURFACEFLATTENING_OPENMP
#include <omp.h>
#endif

namespace flattening
{
namespace
{

std::mutex& blas()
{
  static std::mutex mutex;
  return mutex;
}

} // namespace

BlasLock::BlasLock()
  : Lock(blas())
{
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
