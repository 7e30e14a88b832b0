// SPDX-License-Identifier: GPL-3.0-or-later
/// How much memory a part of the program takes at most.
#pragma once

namespace flattening::benchmarks
{

/// Begins to watch the resident memory of the process (Linux).
void resetPeakMemory();

/// The most that was resident since, in 1e9 bytes, all that the process held before included; 0 where
/// the system does not tell.
double peakMemory();

} // namespace flattening::benchmarks
