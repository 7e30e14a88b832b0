// SPDX-License-Identifier: GPL-3.0-or-later
/// Calls of library functions that cannot be interrupted, during which the user may abort all the same.
#pragma once

#include "Base/Progress.h"

#include <functional>

namespace flattening
{

/// Runs @p work in a thread of its own and reports @p fraction and @p stage from the calling thread
/// every tenth of a second until it is done; without @p progress, runs it in the calling thread. When
/// the callback returns false, Cancelled is thrown at once, and the abandoned @p work runs to its end in
/// the background: it must own everything that it uses. At most one abandoned call exists: the next call
/// waits until it has ended, and so does the end of the process.
/// @throws Cancelled; every exception of @p work.
void callInterruptibly(std::function<void()> work,
  const ProgressCallback& progress,
  double fraction,
  const char* stage);

} // namespace flattening
