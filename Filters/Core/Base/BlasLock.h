// SPDX-License-Identifier: GPL-3.0-or-later
/// What everything that may call BLAS holds meanwhile.
#pragma once

#include <mutex>

namespace flattening
{

/// Lets one thread at a time call BLAS, because not every BLAS bears more (OpenBLAS's serial build then
/// answers nonsense), and keeps OpenMP from starting threads meanwhile. CHOLMOD would start four,
/// however few cores there are, and have them wait for each other at every supernode: a factorization of
/// a million unknowns takes a third longer on two idle cores and several times as long on busy ones.
class BlasLock
{
public:
  BlasLock();
  ~BlasLock();
  BlasLock(const BlasLock&) = delete;
  BlasLock& operator=(const BlasLock&) = delete;

private:
  std::unique_lock<std::mutex> Lock;
  int OpenMPLevels = 0; // of parallel regions, as it was
};

} // namespace flattening
