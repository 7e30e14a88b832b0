// SPDX-License-Identifier: GPL-3.0-or-later
/// Progress of a step that is a single point of the whole's.
#pragma once

#include "Base/Progress.h"

namespace flattening
{

/// Whatever the step reports becomes @p fraction and @p stage.
inline ProgressCallback atFraction(const ProgressCallback& progress, double fraction, const char* stage)
{
  if (!progress)
  {
    return {};
  }
  return [progress, fraction, stage](double, const char*) { return progress(fraction, stage); };
}

} // namespace flattening
