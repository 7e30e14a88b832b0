// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Oracles/FilterRun.h"
#include "../Oracles/SameData.h"
#include "../Surfaces/SurfaceClasses.h"
#include "Scenarios.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkStreamingDemandDrivenPipeline.h>

namespace fuzz
{
namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

// One surface per time step: 0, 1, ...
class TimeSource : public vtkPolyDataAlgorithm
{
public:
  static TimeSource* New();
  vtkTypeMacro(TimeSource, vtkPolyDataAlgorithm);
  std::vector<vtkSmartPointer<vtkPolyData>> Steps;

protected:
  TimeSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* output = outputs->GetInformationObject(0);
    std::vector<double> times;
    for (std::size_t step = 0; step < this->Steps.size(); ++step)
    {
      times.push_back(static_cast<double>(step));
    }
    const double range[2] = { times.front(), times.back() };
    output->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    output->Set(Pipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* output = outputs->GetInformationObject(0);
    const double time =
      output->Has(Pipeline::UPDATE_TIME_STEP()) ? output->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
    vtkPolyData::GetData(outputs)->ShallowCopy(this->Steps.at(static_cast<std::size_t>(time)));
    return 1;
  }
};
vtkStandardNewMacro(TimeSource);

} // namespace

void runTimeSteps(const Case& one, Findings& findings)
{
  Random random = scenarioRandom(one);
  const auto source = vtkSmartPointer<TimeSource>::New();
  source->Steps = { one.Surface, makeSurface("tiny", random), makeSurface("spheres", random) };
  const Chain chain = newChain(one, false);
  chain.front()->SetInputConnection(source->GetOutputPort());
  for (int n = 0; n < 4; ++n)
  {
    const int step = random.integer(0, 2);
    Findings ignored; // the checks of the filters alone are enough
    for (vtkAlgorithm* filter : chain)
    {
      filter->UpdateInformation();
      filter->GetOutputInformation(0)->Set(Pipeline::UPDATE_TIME_STEP(), static_cast<double>(step));
      runFilter(filter, ignored);
    }
    const Chain alone = newChain(one, false);
    alone.front()->SetInputDataObject(source->Steps[step]);
    for (vtkAlgorithm* filter : alone)
    {
      runFilter(filter, findings);
    }
    const std::string differs =
      difference(alone.back()->GetOutputDataObject(0), chain.back()->GetOutputDataObject(0));
    findings.require(differs.empty(),
      "time-steps",
      "time step " + std::to_string(step) + " is not as alone: " + differs);
  }
}

} // namespace fuzz
