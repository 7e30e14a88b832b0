// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether an error message or a warning reads like one sentence for a user.
#pragma once

#include <cstddef>
#include <string>

namespace fuzz
{

/// The message in the text of an error event of VTK.
std::string messageOf(const std::string& eventText);

/// The fault of a message, in words; empty if it has none.
std::string faultOf(const std::string& message, std::size_t greatestLength);

} // namespace fuzz
