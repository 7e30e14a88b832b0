// SPDX-License-Identifier: GPL-3.0-or-later
/// A failed case made small.
#pragma once

#include "../Case.h"
#include "Child.h"

#include <string>

namespace fuzz
{

/// Removes cells in chunks, then single cells and settings, as long as a failure of the same kind stays.
/// Each trial is a child. @param seconds time after which the best case so far is good enough
Case shrink(Case one, const std::string& kind, const Limits& limits, double seconds);

} // namespace fuzz
