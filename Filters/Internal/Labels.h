// SPDX-License-Identifier: GPL-3.0-or-later
/// Labels of regions: arrays of whole numbers on points or cells.
#pragma once

#include "Internal/ChosenArray.h"

#include <string>
#include <vector>

namespace flattening
{

/// The values of an array of one number each.
/// @param what names the array in the message, such as "the region array".
/// @throws InvalidInput if one is no number, no whole number or too large to be told from the next.
std::vector<long long> labelsOf(const ChosenArray& chosen, const std::string& what = "the label array");

/// The different labels, ascending, as a text: at most twenty of them.
std::string listed(const std::vector<long long>& labels);

} // namespace flattening
