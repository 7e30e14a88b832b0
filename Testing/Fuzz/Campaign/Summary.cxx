// SPDX-License-Identifier: GPL-3.0-or-later
#include "Summary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fuzz
{

double Summary::Row::medianWithin() const
{
  if (this->Within.empty())
  {
    return std::nan("");
  }
  std::vector<double> sorted = this->Within;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

std::string Summary::Row::kinds() const
{
  std::string text;
  for (const auto& [kind, count] : this->Kinds)
  {
    text += (text.empty() ? "" : ";") + kind + ":" + std::to_string(count);
  }
  return text;
}

void Summary::add(const Record& record)
{
  Row& row = this->Rows[record.Of.SurfaceClass];
  row.FirstSeed = row.Cases == 0 ? record.Of.Seed : std::min(row.FirstSeed, record.Of.Seed);
  row.LastSeed = std::max(row.LastSeed, record.Of.Seed);
  ++row.Cases;
  row.Disks += record.Shown.Disks;
  row.CasesWithErrors += record.Shown.Errors > 0 ? 1 : 0;
  row.FailedCases += record.Shown.Failures.empty() ? 0 : 1;
  row.GreatestFaces = std::max(row.GreatestFaces, record.Faces);
  for (const Failure& failure : record.Shown.Failures)
  {
    ++row.Kinds[failure.Kind];
  }
  row.Seconds += record.Seconds;
  if (record.Seconds > row.WorstSeconds)
  {
    row.WorstSeconds = record.Seconds;
    row.WorstSeed = record.Of.Seed;
  }
  if (record.Shown.Within2Percent >= 0.0)
  {
    row.Within.push_back(record.Shown.Within2Percent);
  }
}

int Summary::failedCases() const
{
  int failed = 0;
  for (const auto& [name, row] : this->Rows)
  {
    failed += row.FailedCases;
  }
  return failed;
}

void Summary::print(std::ostream& out) const
{
  char line[400];
  std::snprintf(line,
    sizeof(line),
    "%-17s %7s %7s %7s %7s %8s %9s %8s  %s\n",
    "class",
    "cases",
    "disks",
    "errors",
    "failed",
    "mean (s)",
    "worst (s)",
    "within",
    "failures by kind");
  out << line;
  for (const auto& [name, row] : this->Rows)
  {
    char within[16] = "-";
    if (!row.Within.empty())
    {
      std::snprintf(within, sizeof(within), "%.1f%%", row.medianWithin());
    }
    std::snprintf(line,
      sizeof(line),
      "%-17s %7d %7d %7d %7d %8.3f %9.2f %8s  %s\n",
      name.c_str(),
      row.Cases,
      row.Disks,
      row.CasesWithErrors,
      row.FailedCases,
      row.Seconds / row.Cases,
      row.WorstSeconds,
      within,
      row.kinds().c_str());
    out << line;
  }
}

void Summary::writeCsv(std::ostream& out) const
{
  out << "class,first_seed,last_seed,cases,disks,cases_with_errors,failed_cases,greatest_faces,"
         "seconds,worst_seconds,worst_seed,mapped_cases,median_within_2_percent,failures\n";
  for (const auto& [name, row] : this->Rows)
  {
    out << name << ',' << row.FirstSeed << ',' << row.LastSeed << ',' << row.Cases << ',' << row.Disks
        << ',' << row.CasesWithErrors << ',' << row.FailedCases << ',' << row.GreatestFaces << ','
        << row.Seconds << ',' << row.WorstSeconds << ',' << row.WorstSeed << ',' << row.Within.size()
        << ',' << row.medianWithin() << ',' << row.kinds() << '\n';
  }
}

} // namespace fuzz
