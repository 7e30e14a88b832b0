// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether there is memory for something large, before work on it begins.
#pragma once

#include <string>

namespace flattening
{

/// Asks for memory and gives it back.
/// @param what takes the memory, such as "an image"
/// @param remedy what the user can do, such as "set a smaller Size"
/// @throws InvalidInput if there is not as much memory
void requireMemory(const std::string& what, double bytes, const std::string& remedy);

} // namespace flattening
