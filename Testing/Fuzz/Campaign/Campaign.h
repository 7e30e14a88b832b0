// SPDX-License-Identifier: GPL-3.0-or-later
/// A campaign: cases of all classes in turn, a table, and files of the cases that failed.
#pragma once

#include "CaseRuns.h"
#include "Summary.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace fuzz
{

struct CampaignOptions
{
  std::string SurfaceClass = "all";
  std::string Scenario; ///< of all cases; empty if their seeds determine it
  std::uint64_t First = 1;
  int Count = 1000;
  double Minutes = 1e9;
  double ShrinkingSeconds = 60.0; ///< time to make a failed case smaller
  Limits Limit;
  std::filesystem::path Out = "fuzz-output";
};

class Campaign
{
public:
  explicit Campaign(const CampaignOptions& options);

  /// @return the number of failed cases
  int run();

private:
  std::vector<Job> nextJobs(int done, int most) const;
  void finish(const Record& record);
  void keep(const Record& record, const Failure& failure);

  CampaignOptions Options;
  Summary Table;
  std::ofstream Cases; ///< a line for each case, with its processor time
  std::vector<Record> Failed;
  std::map<std::string, int> Kept; ///< files by kind of failure
};

/// Runs a saved case and prints what each filter says.
/// @return the number of failures
int replay(const std::string& file, const Limits& limits);

} // namespace fuzz
