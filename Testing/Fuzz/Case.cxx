// SPDX-License-Identifier: GPL-3.0-or-later
#include "Case.h"

#include "Scenarios/Scenarios.h"
#include "Surfaces/SurfaceClasses.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace fuzz
{
namespace
{

constexpr const char* CaseArray = "FuzzCase";

struct Scenario
{
  std::string Name;
  double Share; // of all cases
  std::function<void(const Case&, Findings&)> Run;
};

const std::vector<Scenario>& scenarios()
{
  // The maps that keep areas take most of the time, so that most cases go without.
  static const std::vector<Scenario> all = {
    { "pipeline", 0.05, runPipeline },
    { "pipeline-random", 0.03, runPipeline },
    { "pipeline-hostile", 0.02, runPipeline },
    { "disk", 0.27, runDisk },
    { "drawn-inputs-random", 0.08, runDrawnInputs },
    { "disk-random", 0.3, runDisk },
    { "disk-hostile", 0.1, runDisk },
    { "other-filter-random", 0.07, runOtherFilter },
    { "other-filter-hostile", 0.03, runOtherFilter },
    { "lifecycle-random", 0.02, runLifecycle },
    { "threads", 0.005, runThreads },
    { "composite-random", 0.015, runComposite },
    { "time-steps", 0.01, runTimeSteps },
    { "free-outline", 0.0, runFreeOutline }, // with --scenario only, as it takes long
  };
  return all;
}

const Scenario& randomScenario(Random& random)
{
  double share = random.uniform();
  for (const Scenario& scenario : scenarios())
  {
    share -= scenario.Share;
    if (share <= 0.0)
    {
      return scenario;
    }
  }
  return scenarios().front();
}

Extent extentOf(Random& random, vtkPolyData* data)
{
  Extent extent;
  double bounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  const auto points = static_cast<int>(data->GetNumberOfPoints());
  if (points > 0)
  {
    data->GetBounds(bounds);
    extent.Size = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  }
  for (int n = 0; n < 8 && points > 0; ++n)
  {
    Point point;
    data->GetPoint(random.integer(0, points - 1), point.data());
    extent.Points.push_back(point);
  }
  return extent;
}

bool contains(const std::string& text, const char* word)
{
  return text.find(word) != std::string::npos;
}

} // namespace

Case makeCase(const std::string& surfaceClass, std::uint64_t seed, const std::string& scenario)
{
  Random surfaceRandom(surfaceClass, seed);
  Random random(surfaceClass + " settings", seed);
  Case one;
  one.SurfaceClass = surfaceClass;
  one.Seed = seed;
  one.Surface = makeSurface(surfaceClass, surfaceRandom);
  one.Scenario = randomScenario(random).Name;
  if (!scenario.empty())
  {
    one.Scenario = scenario;
  }
  std::vector<std::string> filters = {
    "SurfaceToDisk", "ConformalDisk", "OMTAreaPreserving", "DistortionMetrics"
  };
  if (contains(one.Scenario, "other-filter"))
  {
    filters = otherFilters();
  }
  const Extent extent = extentOf(random, one.Surface);
  if (contains(one.Scenario, "random"))
  {
    const double share = random.logUniform(0.05, 0.5);
    for (const std::string& filter : filters)
    {
      draw(random, filter, share, extent, one.Values);
    }
  }
  if (contains(one.Scenario, "hostile"))
  {
    makeHostile(random, random.pick(filters), one.Values);
  }
  return one;
}

Findings runCase(const Case& one)
{
  Findings findings;
  for (const Scenario& scenario : scenarios())
  {
    if (scenario.Name == one.Scenario)
    {
      scenario.Run(one, findings);
      return findings;
    }
  }
  throw std::invalid_argument("there is no scenario \"" + one.Scenario + "\"");
}

void saveCase(const Case& one, const std::string& path)
{
  vtkNew<vtkStringArray> text;
  text->SetName(CaseArray);
  text->InsertNextValue(one.SurfaceClass);
  text->InsertNextValue(std::to_string(one.Seed));
  text->InsertNextValue(one.Scenario);
  text->InsertNextValue(toText(one.Values));
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(one.Surface);
  data->GetFieldData()->AddArray(text);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(path.c_str());
  writer->SetDataModeToBinary();
  writer->Write();
}

Case loadCase(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  Case one;
  one.Surface = reader->GetOutput();
  auto* text = vtkStringArray::SafeDownCast(one.Surface->GetFieldData()->GetAbstractArray(CaseArray));
  if (!text || text->GetNumberOfValues() != 4)
  {
    one.Scenario = "pipeline";
    return one;
  }
  one.SurfaceClass = text->GetValue(0);
  one.Seed = std::stoull(text->GetValue(1));
  one.Scenario = text->GetValue(2);
  one.Values = settingsFrom(text->GetValue(3));
  one.Surface->GetFieldData()->RemoveArray(CaseArray);
  return one;
}

} // namespace fuzz
