// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseRuns.h"

#include "../Case.h"
#include "../Oracles/FilterRun.h"

#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sstream>

extern "C" {
// A function of the leak sanitizer; null if the program was built without it.
int __lsan_do_recoverable_leak_check() __attribute__((weak));
}

namespace fuzz
{
namespace
{

constexpr char Separator = '\t';

bool hasLeak()
{
  return __lsan_do_recoverable_leak_check && __lsan_do_recoverable_leak_check() != 0;
}

// The lines that a child tells: "start <scenario> <faces>", "run <filter>", "fail <kind> <detail>" and
// "end <figures>". The limit of time is that between two of them, so that it holds for each run of a
// filter.
void tellCase(const Case& one, const Tell& tell)
{
  tell("start" + std::string(1, Separator) + one.Scenario + Separator +
       std::to_string(one.Surface->GetNumberOfCells()));
  const std::clock_t start = std::clock(); // of the processor, as other programs may run beside
  announceRuns([&tell](const std::string& filter) { tell("run" + std::string(1, Separator) + filter); });
  const Findings findings = runCase(one);
  announceRuns({});
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  for (const Failure& failure : findings.Failures)
  {
    tell("fail" + std::string(1, Separator) + failure.Kind + Separator + failure.Detail);
  }
  char figures[160];
  std::snprintf(figures,
    sizeof(figures),
    "end\t%d\t%d\t%.17g\t%.6f",
    findings.Disks,
    findings.Errors,
    findings.Within2Percent,
    seconds);
  tell(figures);
}

std::vector<std::string> split(const std::string& line)
{
  std::vector<std::string> parts;
  std::istringstream stream(line);
  for (std::string part; std::getline(stream, part, Separator);)
  {
    parts.push_back(part);
  }
  parts.resize(std::max<std::size_t>(parts.size(), 5));
  return parts;
}

// Takes up a line of a child.
// @return whether the case is at its end
bool hearLine(const std::string& line, Record& record)
{
  const std::vector<std::string> parts = split(line);
  if (parts[0] == "start")
  {
    record.Scenario = parts[1];
    record.Faces = std::atoi(parts[2].c_str());
  }
  else if (parts[0] == "run")
  {
    record.Filter = parts[1];
  }
  else if (parts[0] == "fail")
  {
    record.Shown.fail(parts[1], parts[2]);
  }
  else if (parts[0] == "end")
  {
    record.Shown.Disks = std::atoi(parts[1].c_str());
    record.Shown.Errors = std::atoi(parts[2].c_str());
    record.Shown.Within2Percent = std::atof(parts[3].c_str());
    record.Seconds = std::atof(parts[4].c_str());
    return true;
  }
  return false;
}

std::string lastLines(const std::string& file)
{
  std::string text;
  if (std::FILE* stream = std::fopen(file.c_str(), "r"))
  {
    char bytes[600];
    const std::size_t count = std::fread(bytes, 1, sizeof(bytes), stream);
    text.assign(bytes, count);
    std::fclose(stream);
  }
  return text;
}

} // namespace

void prepareProcess()
{
  catchStrayErrors();
  vtkSMPTools::SetBackend("Sequential"); // a process that forks has no threads
}

void runJobs(const std::vector<Job>& jobs,
  const Limits& limits,
  const std::function<void(const Record&)>& finish)
{
  std::vector<Record> finished;
  std::size_t next = 0;
  bool leaked = false;
  while (next < jobs.size())
  {
    Record record;
    const std::size_t first = next;
    const std::string end = runChild(
      [&](const Tell& tell)
      {
        prepareProcess();
        for (std::size_t j = first; j < jobs.size(); ++j)
        {
          tellCase(makeCase(jobs[j].SurfaceClass, jobs[j].Seed, jobs[j].Scenario), tell);
        }
        if (hasLeak())
        {
          tell("leak");
        }
      },
      limits,
      [&](const std::string& line)
      {
        leaked = leaked || line == "leak";
        record.Of = jobs[std::min(next, jobs.size() - 1)];
        if (hearLine(line, record))
        {
          finished.push_back(record);
          record = {};
          ++next;
        }
      });
    if (!end.empty() && next < jobs.size())
    {
      record.Of = jobs[next];
      record.Shown.fail(end, record.Filter + ": " + lastLines(limits.LogFile));
      record.Seconds = end == "hang" ? limits.Seconds : 0.0;
      finished.push_back(record);
      ++next;
    }
  }
  if (leaked && jobs.size() > 1) // which of them?
  {
    for (const Job& job : jobs)
    {
      runJobs({ job }, limits, finish);
    }
    return;
  }
  for (Record& record : finished)
  {
    if (leaked)
    {
      record.Shown.fail("leak", lastLines(limits.LogFile));
    }
    finish(record);
  }
}

Record runInChild(const Case& one, const Limits& limits)
{
  Record record;
  record.Of = { one.SurfaceClass, one.Seed, {} };
  const std::string end = runChild(
    [&](const Tell& tell)
    {
      prepareProcess();
      tellCase(one, tell);
      if (hasLeak())
      {
        tell(std::string("fail\tleak\t"));
      }
    },
    limits,
    [&](const std::string& line) { hearLine(line, record); });
  if (!end.empty())
  {
    record.Shown.fail(end, record.Filter + ": " + lastLines(limits.LogFile));
  }
  return record;
}

} // namespace fuzz
