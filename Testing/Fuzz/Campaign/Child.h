// SPDX-License-Identifier: GPL-3.0-or-later
/// Work in a child process with limits, so that a crash, a hang or a want of memory ends the child
/// alone.
#pragma once

#include <functional>
#include <string>

namespace fuzz
{

struct Limits
{
  /// Greatest time between two lines of a child: of the processor, and by the clock while the child
  /// sleeps. The clock alone would end a child that waits for a processor which other programs use.
  double Seconds = 60.0;
  long MemoryMegabytes = 4096;
  std::string LogFile; ///< gets what the child prints; empty: the terminal
};

/// Writes a line to the parent; line breaks in it become spaces.
using Tell = std::function<void(const std::string& line)>;

/// Forks a child that does the work, and calls @p hear with each line that it tells.
/// @return how the child ended: empty if it did its work, else "crash-SIGSEGV", "hang", "out-of-memory",
/// "sanitizer" or "exit-N"
std::string runChild(const std::function<void(const Tell&)>& work,
  const Limits& limits,
  const std::function<void(const std::string&)>& hear);

/// Whether the program was built with the address sanitizer.
bool isSanitized();

} // namespace fuzz
