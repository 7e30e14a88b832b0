// SPDX-License-Identifier: GPL-3.0-or-later
/// What a case shows: failed checks, and figures for the table.
#pragma once

#include <string>
#include <vector>

namespace fuzz
{

struct Failure
{
  std::string Kind; ///< the same word for the same fault, such as "bijective"
  std::string Detail;
};

struct Findings
{
  std::vector<Failure> Failures;
  int Disks = 0;              ///< outputs of Surface To Disk that are not empty
  int Errors = 0;             ///< errors of filters
  double Within2Percent = -1; ///< share of the faces of the default pipeline; negative if there is none

  void fail(const std::string& kind, const std::string& detail);
  /// Fails unless @p holds.
  void require(bool holds, const std::string& kind, const std::string& detail);
};

} // namespace fuzz
