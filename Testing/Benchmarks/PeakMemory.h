// SPDX-License-Identifier: GPL-3.0-or-later
/// The greatest amount of memory that a part of the program uses.
#pragma once

namespace flattening::benchmarks
{

/// Begins to watch the resident memory of the process (Linux).
void resetPeakMemory();

/// The greatest resident memory since then, in 1e9 bytes, including the memory that the process held
/// before; 0 where the system does not report it.
double peakMemory();

} // namespace flattening::benchmarks
