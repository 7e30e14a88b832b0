// SPDX-License-Identifier: GPL-3.0-or-later
/// The lock of libraries that call BLAS.
#pragma once

#include <mutex>

namespace flattening
{

/// A lock that serializes calls of BLAS, because not every BLAS may be called from several threads (the
/// serial build of OpenBLAS returns wrong numbers then). It also keeps OpenMP from starting threads:
/// CHOLMOD would start four, however few cores there are, and have them wait for each other at every
/// supernode; a factorization of a million unknowns takes a third longer on two idle cores and several
/// times as long on busy ones.
class BlasLock
{
public:
  /// @throws std::bad_alloc if there is no memory for the work area of BLAS.
  BlasLock();
  ~BlasLock();
  BlasLock(const BlasLock&) = delete;
  BlasLock& operator=(const BlasLock&) = delete;

private:
  std::unique_lock<std::mutex> Lock;
  int OpenMPLevels = 0; // of nested parallel regions, as it was before; 0 without OpenMP
};

} // namespace flattening
