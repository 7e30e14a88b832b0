// SPDX-License-Identifier: GPL-3.0-or-later
/// Labels of regions: arrays of whole numbers on points or cells.
#pragma once

#include "Internal/ChosenArray.h"

#include <string>
#include <vector>

namespace flattening
{

/// The labels in an array of one component.
/// @param what name of the array in messages, such as "the label array".
/// @throws InvalidInput if a value is not a whole number of less than 2^53 in magnitude.
std::vector<long long> labelsOf(const ChosenArray& chosen, const std::string& what = "the label array");

/// The distinct labels as text in ascending order, at most twenty of them.
std::string listed(const std::vector<long long>& labels);

} // namespace flattening
