// SPDX-License-Identifier: GPL-3.0-or-later
/// Runs cases in children and collects what they show.
#pragma once

#include "../Findings.h"
#include "Child.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fuzz
{

struct Case;

struct Job
{
  std::string SurfaceClass;
  std::uint64_t Seed = 0;
  std::string Scenario; ///< empty if the seed determines it
};

struct Record
{
  Job Of;
  std::string Scenario;
  std::string Filter; ///< class of the filter that ran last
  Findings Shown;
  double Seconds = 0.0;
  int Faces = 0;
};

/// Sets VTK up: no threads of its own, and no errors on the terminal.
void prepareProcess();

/// Runs the jobs in as few children as possible. A child that ends early fails the case that it was at,
/// and the cases after it get a new child.
void runJobs(const std::vector<Job>& jobs,
  const Limits& limits,
  const std::function<void(const Record&)>& finish);

/// Runs one case in a child.
Record runInChild(const Case& one, const Limits& limits);

} // namespace fuzz
