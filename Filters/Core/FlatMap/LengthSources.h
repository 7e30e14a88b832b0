// SPDX-License-Identifier: GPL-3.0-or-later
/// The source points from which lengths are measured, and the progress of the work on them.
#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace flattening
{

/// Draws vertices by area: of @p count equal shares of the whole, in the order of the vertices, one
/// vertex each. The same areas give the same vertices on all machines.
/// @param areas  of the surface around the vertices (n), not all of them 0
std::vector<int> drawnByArea(const Eigen::VectorXd& areas, int count);

/// Progress and abort of work on sources in several threads, seen from the thread that makes this.
class SourceProgress
{
public:
  SourceProgress(const ProgressCallback& progress, const char* stage, std::size_t sources);

  /// To be called by all threads, now and then; the thread that made this reports. @throws Cancelled
  void check();
  /// To be called when a source is done.
  void finishOne() { ++this->Done; }

private:
  const ProgressCallback& Progress;
  const char* Stage;
  std::size_t Sources;
  std::thread::id Caller = std::this_thread::get_id();
  std::atomic<std::size_t> Done{ 0 };
  std::atomic<bool> Cancelled{ false };
};

} // namespace flattening
