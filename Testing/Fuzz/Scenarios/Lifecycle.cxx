// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Oracles/FilterRun.h"
#include "../Oracles/SameData.h"
#include "../Surfaces/SurfaceClasses.h"
#include "Scenarios.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkPolyData.h>

#include <vector>

namespace fuzz
{
namespace
{

/// Asks the filter that reports progress to stop, at the report with a given number.
class Stop : public vtkCommand
{
public:
  int Report = 0;
  bool Asked = false;
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    // VTK itself reports 1 once the filter has put its result out: too late for an abort.
    auto* filter = static_cast<vtkAlgorithm*>(caller);
    const bool ended = filter->GetProgress() >= 1.0 && !hasNothing(filter->GetOutputDataObject(0));
    if (this->Report-- == 0 && !ended)
    {
      this->Asked = true;
      filter->SetAbortExecute(1);
    }
  }
};

// The output of new filters.
vtkSmartPointer<vtkDataObject> freshResult(const Case& one,
  vtkPolyData* surface,
  bool isLong,
  Findings& findings)
{
  const Chain chain = newChain(one, isLong);
  chain.front()->SetInputDataObject(surface);
  for (vtkAlgorithm* filter : chain)
  {
    runFilter(filter, findings);
  }
  return copyOf(chain.back()->GetOutputDataObject(0));
}

// Runs the chain and asks one of its filters to stop.
void runAborted(const Chain& chain, Random& random, Findings& findings)
{
  vtkAlgorithm* aborted = random.pick(chain);
  const auto stop = vtkSmartPointer<Stop>::Take(new Stop);
  stop->Report = random.integer(0, 15);
  const unsigned long tag = aborted->AddObserver(vtkCommand::ProgressEvent, stop);
  for (vtkAlgorithm* filter : chain)
  {
    filter->Modified();
  }
  try
  {
    chain.back()->Update();
  }
  catch (const std::exception& error)
  {
    findings.fail("exception", std::string("after an abort: ") + error.what());
  }
  aborted->RemoveObserver(tag);
  findings.require(!stop->Asked || hasNothing(aborted->GetOutputDataObject(0)) || stop->Report < -1,
    "abort",
    std::string(aborted->GetClassName()) + " has a result after an abort");
  aborted->SetAbortExecute(0);
  aborted->Modified();
}

} // namespace

void runLifecycle(const Case& given, Findings& findings)
{
  Random random = scenarioRandom(given);
  Case one = given;
  one.Values.emplace(
    "DistortionMetrics.LengthSamples", std::vector<double>{ 20.0 }); // they are measured often
  const bool isLong = random.chance(0.3) && one.Surface->GetNumberOfCells() < 500; // it runs many times
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces = { one.Surface };
  surfaces.push_back(makeSurface("tiny", random));
  surfaces.push_back(makeSurface("spheres", random));
  std::vector<vtkSmartPointer<vtkDataObject>> expected;
  for (vtkPolyData* surface : surfaces)
  {
    expected.push_back(freshResult(one, surface, isLong, findings));
  }
  const Chain chain = newChain(one, isLong);
  chain.front()->SetInputDataObject(surfaces.front());
  std::size_t current = 0;
  std::string story;
  for (int step = 0; step < 5; ++step)
  {
    switch (random.integer(0, 2))
    {
      case 0:
        current = random.integer(0, static_cast<int>(surfaces.size()) - 1);
        chain.front()->SetInputDataObject(surfaces[current]);
        story += " input " + std::to_string(current);
        break;
      case 1:
        random.pick(chain)->Modified();
        story += " modify";
        break;
      default:
        story += " abort";
        runAborted(chain, random, findings);
        break;
    }
    Findings ignored; // of a filter that has nothing to do
    for (vtkAlgorithm* filter : chain)
    {
      runFilter(filter, ignored);
    }
    const std::string differs = difference(expected[current], chain.back()->GetOutputDataObject(0));
    findings.require(differs.empty(), "not-repeatable", "another result after" + story + ": " + differs);
  }
}

} // namespace fuzz
