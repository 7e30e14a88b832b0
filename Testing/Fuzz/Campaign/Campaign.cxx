// SPDX-License-Identifier: GPL-3.0-or-later
#include "Campaign.h"

#include "../Case.h"
#include "../Oracles/FilterRun.h"
#include "../Surfaces/SurfaceClasses.h"
#include "Shrinking.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>

namespace fuzz
{
namespace
{

constexpr int BatchSize = 50;   // cases per child: starting a child takes longer than a small case
constexpr int FilesPerKind = 5; // of failed cases, as the same fault tends to show often

void print(const Record& record, const Failure& failure)
{
  std::cout << record.Of.SurfaceClass << ' ' << record.Of.Seed << " (" << record.Scenario
            << "): " << failure.Kind << ": " << failure.Detail.substr(0, 400) << std::endl;
}

} // namespace

Campaign::Campaign(const CampaignOptions& options)
  : Options(options)
{
  std::filesystem::create_directories(options.Out);
  this->Options.Limit.LogFile = options.Out / "child.log";
  this->Cases.open(options.Out / "cases.csv");
  this->Cases << "class,seed,scenario,faces,seconds,failures\n";
}

int Campaign::run()
{
  const auto start = std::chrono::steady_clock::now();
  for (int done = 0; done < this->Options.Count; done += BatchSize)
  {
    this->Failed.clear();
    runJobs(this->nextJobs(done, BatchSize),
      this->Options.Limit,
      [this](const Record& record) { this->finish(record); });
    for (const Record& record : this->Failed)
    {
      for (const Failure& failure : record.Shown.Failures)
      {
        this->keep(record, failure);
      }
    }
    this->Cases.flush();
    std::ofstream table(this->Options.Out / "summary.csv");
    this->Table.writeCsv(table);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (elapsed.count() > 60.0 * this->Options.Minutes)
    {
      break;
    }
  }
  this->Table.print(std::cout);
  return this->Table.failedCases();
}

// The classes in turn, each with the next seed.
std::vector<Job> Campaign::nextJobs(int done, int most) const
{
  const std::vector<std::string> classes = this->Options.SurfaceClass == "all"
                                             ? surfaceClasses()
                                             : std::vector<std::string>{ this->Options.SurfaceClass };
  std::vector<Job> jobs;
  for (int i = done; i < std::min(done + most, this->Options.Count); ++i)
  {
    jobs.push_back(
      { classes[i % classes.size()], this->Options.First + i / classes.size(), this->Options.Scenario });
  }
  return jobs;
}

void Campaign::finish(const Record& record)
{
  this->Table.add(record);
  this->Cases << record.Of.SurfaceClass << ',' << record.Of.Seed << ',' << record.Scenario << ','
              << record.Faces << ',' << record.Seconds << ',' << record.Shown.Failures.size() << '\n';
  if (!record.Shown.Failures.empty())
  {
    this->Failed.push_back(record);
  }
}

// Writes the case, small if it can be made so, and says how to run it again. VTK's work is done in a
// child, as this process must not start threads.
void Campaign::keep(const Record& record, const Failure& failure)
{
  print(record, failure);
  if (++this->Kept[failure.Kind] > FilesPerKind)
  {
    return;
  }
  const std::filesystem::path file =
    this->Options.Out /
    (failure.Kind + "-" + record.Of.SurfaceClass + "-" + std::to_string(record.Of.Seed) + ".vtp");
  Limits limits;
  limits.Seconds = 3600.0; // of all trials
  limits.MemoryMegabytes = this->Options.Limit.MemoryMegabytes;
  limits.LogFile = this->Options.Out / "shrinking.log";
  const std::string end = runChild(
    [&](const Tell& tell)
    {
      prepareProcess();
      const Case whole = makeCase(record.Of.SurfaceClass, record.Of.Seed, record.Of.Scenario);
      saveCase(whole, file);
      const Case small =
        shrink(whole, failure.Kind, this->Options.Limit, this->Options.ShrinkingSeconds);
      saveCase(small, file);
      tell(std::to_string(whole.Surface->GetNumberOfCells()) + " to " +
           std::to_string(small.Surface->GetNumberOfCells()) + " cells");
    },
    limits,
    [](const std::string& line) { std::cout << "  made smaller: " << line << std::endl; });
  std::cout << "  again: FuzzFilters --replay " << file.string()
            << (end.empty() ? "" : " (not made smaller: " + end + ")") << std::endl;
}

int replay(const std::string& file, const Limits& limits)
{
  int failures = 0;
  const std::string end = runChild(
    [&](const Tell& tell)
    {
      prepareProcess();
      printRuns();
      const Case one = loadCase(file);
      std::cout << one.SurfaceClass << ' ' << one.Seed << ", " << one.Scenario << ", "
                << one.Surface->GetNumberOfCells() << " cells\n"
                << toText(one.Values) << std::flush;
      for (const Failure& failure : runCase(one).Failures)
      {
        tell(failure.Kind + ": " + failure.Detail);
      }
    },
    limits,
    [&](const std::string& line)
    {
      ++failures;
      std::cout << line << std::endl;
    });
  if (!end.empty())
  {
    std::cout << end << std::endl;
  }
  return failures + (end.empty() ? 0 : 1);
}

} // namespace fuzz
