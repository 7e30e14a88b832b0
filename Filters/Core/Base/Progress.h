// SPDX-License-Identifier: GPL-3.0-or-later
/// Progress: how a long computation reports how far it is and learns that it should stop.
#pragma once

#include "Base/Errors.h"

#include <functional>

namespace flattening
{

/// Called from the calling thread only, with a fraction in [0,1] that never decreases and the name of
/// the stage. Returns false to cancel.
using ProgressCallback = std::function<bool(double fraction, const char* stage)>;

/// Reports progress. An empty callback is allowed. @throws Cancelled if the callback returns false.
inline void report(const ProgressCallback& progress, double fraction, const char* stage)
{
  if (progress && !progress(fraction, stage))
  {
    throw Cancelled();
  }
}

/// The callback for a step whose progress from 0 to 1 is the part [begin, end] of a longer job's.
inline ProgressCallback subrange(const ProgressCallback& progress, double begin, double end)
{
  if (!progress)
  {
    return {};
  }
  return [progress, begin, end](double fraction, const char* stage)
  { return progress(begin + (end - begin) * fraction, stage); };
}

/// The callback for a step that is a single point of a longer job's progress: whatever the step reports
/// becomes @p fraction and @p stage.
inline ProgressCallback atFraction(const ProgressCallback& progress, double fraction, const char* stage)
{
  if (!progress)
  {
    return {};
  }
  return [progress, fraction, stage](double, const char*) { return progress(fraction, stage); };
}

} // namespace flattening
