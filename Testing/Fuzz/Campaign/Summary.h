// SPDX-License-Identifier: GPL-3.0-or-later
/// The table of a campaign, one row per class of surfaces.
#pragma once

#include "CaseRuns.h"

#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace fuzz
{

class Summary
{
public:
  void add(const Record& record);
  int failedCases() const;

  /// A table to read.
  void print(std::ostream& out) const;
  /// One line per class for programs; the numbers of several campaigns can be added.
  void writeCsv(std::ostream& out) const;

private:
  struct Row
  {
    int Cases = 0;
    int Disks = 0;
    int CasesWithErrors = 0;
    int FailedCases = 0;
    int GreatestFaces = 0;
    std::map<std::string, int> Kinds; ///< failed cases by kind
    double Seconds = 0.0;             ///< of all cases together
    double WorstSeconds = 0.0;
    std::uint64_t FirstSeed = 0;
    std::uint64_t LastSeed = 0;
    std::uint64_t WorstSeed = 0;
    std::vector<double> Within;
    double medianWithin() const;
    std::string kinds() const;
  };
  std::map<std::string, Row> Rows;
};

} // namespace fuzz
