// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Oracles/FilterRun.h"
#include "../Oracles/SameData.h"
#include "Scenarios.h"

#include <vtkAlgorithm.h>
#include <vtkPolyData.h>

#include <array>
#include <thread>

namespace fuzz
{
namespace
{

struct Run
{
  Chain Filters;
  vtkSmartPointer<vtkDataObject> Surface;
  Findings Shown;

  void operator()()
  {
    for (vtkAlgorithm* filter : this->Filters)
    {
      runFilter(filter, this->Shown);
    }
  }
};

Run newRun(const Case& one)
{
  Run run{ newChain(one, true), copyOf(one.Surface), {} };
  run.Filters.front()->SetInputDataObject(run.Surface);
  return run;
}

} // namespace

void runThreads(const Case& one, Findings& findings)
{
  Run alone = newRun(one);
  alone();
  std::array<Run, 2> runs = { newRun(one), newRun(one) };
  std::thread other([&] { runs[1](); });
  runs[0]();
  other.join();
  for (const Run& run : runs)
  {
    for (const Failure& failure : run.Shown.Failures)
    {
      findings.fail(failure.Kind, failure.Detail);
    }
    const std::string differs = difference(
      alone.Filters.back()->GetOutputDataObject(0), run.Filters.back()->GetOutputDataObject(0));
    findings.require(differs.empty(), "threads", "another result beside a second pipeline: " + differs);
  }
}

} // namespace fuzz
