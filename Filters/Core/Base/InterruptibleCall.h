// SPDX-License-Identifier: GPL-3.0-or-later
/// Lets a user abort while a library's call runs that cannot be interrupted.
#pragma once

#include "Base/Progress.h"

#include <functional>

namespace flattening
{

/// Runs @p work in a thread of its own and reports @p fraction and @p stage from the calling thread
/// every tenth of a second until it is done; without @p progress, runs it in the calling thread. When
/// the callback says stop, Cancelled is thrown at once and @p work runs to its end unseen: it must own
/// everything that it uses. At most one such call runs on: the next one waits for it, and so does the
/// end of the process.
/// @throws what @p work throws; Cancelled.
void callInterruptibly(std::function<void()> work,
  const ProgressCallback& progress,
  double fraction,
  const char* stage);

} // namespace flattening
