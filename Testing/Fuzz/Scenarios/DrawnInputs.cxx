// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Oracles/DiskOracle.h"
#include "../Oracles/FilterRun.h"
#include "../Oracles/MapOracle.h"
#include "../Oracles/Triangles.h"
#include "DrawnShapes.h"
#include "Scenarios.h"

#include <vtkAreaWeights.h>
#include <vtkConformalDiskFilter.h>
#include <vtkNew.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkPolyData.h>
#include <vtkSeamPreview.h>
#include <vtkSurfaceToDiskFilter.h>

namespace fuzz
{
namespace
{

constexpr const char* RegionArray = "FuzzRegions";

void chooseRegions(vtkAlgorithm* filter, int index)
{
  filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, RegionArray);
}

// The cuts of an automatic opening, as lines that are given again.
vtkSmartPointer<vtkPolyData> cutsOf(vtkPolyData* surface, Findings& findings)
{
  vtkNew<vtkSurfaceToDiskFilter> disk;
  disk->SetInputData(surface);
  runFilter(disk, findings);
  return vtkPolyData::SafeDownCast(disk->GetOutputDataObject(1));
}

void drawCut(Random& random, vtkPolyData* surface, vtkSurfaceToDiskFilter* disk, Findings& findings)
{
  switch (random.integer(0, 3))
  {
    case 0:
      disk->SetCutMode(
        random.chance(0.5) ? vtkSurfaceToDiskFilter::SEAM : vtkSurfaceToDiskFilter::AUTOMATIC);
      disk->SetSeamLinesData(
        random.chance(0.2) ? cutsOf(surface, findings) : drawnLines(random, surface));
      break;
    case 1:
      disk->SetCutMode(vtkSurfaceToDiskFilter::LABEL);
      disk->SetCutLabel(random.integer(1, 3));
      break;
    case 2:
      disk->SetUseRegionOfInterest(true);
      break;
    default:
      break;
  }
}

void runPreview(Random& random, vtkPolyData* surface, Findings& findings)
{
  vtkNew<vtkSeamPreview> preview;
  preview->SetInputData(surface);
  const int count = random.integer(2, 6);
  preview->SetNumberOfSeamPoints(count);
  for (int n = 0; n < count && surface->GetNumberOfPoints() > 0; ++n)
  {
    double point[3];
    surface->GetPoint(random.integer(0, static_cast<int>(surface->GetNumberOfPoints()) - 1), point);
    preview->SetSeamPoint(n, point[0], point[1], point[2]);
  }
  if (random.chance(0.3))
  {
    preview->SetNumberOfSeamPathStarts(1);
    preview->SetSeamPathStart(0, random.integer(-1, count + 1));
  }
  Findings found;
  runFilter(preview, found);
  for (const Failure& failure : found.Failures)
  {
    findings.require(failure.Kind == "silent-failure", failure.Kind, failure.Detail); // no leg is right
  }
}

// @return whether there is a map to go on with
bool runToConformalMap(Random& random, vtkPolyData* surface, const Chain& chain, Findings& findings)
{
  auto* disk = vtkSurfaceToDiskFilter::SafeDownCast(chain[0]);
  auto* conformal = vtkConformalDiskFilter::SafeDownCast(chain[1]);
  disk->SetInputData(surface);
  chooseRegions(disk, 0);
  chooseRegions(disk, 1);
  drawCut(random, surface, disk, findings);
  if (!runFilter(disk, findings).HasResult)
  {
    return false;
  }
  ++findings.Disks;
  checkDisk(disk->GetOutput(), surface, findings);
  if (!runFilter(conformal, findings).HasResult)
  {
    return false;
  }
  checkMap(conformal->GetOutput(), conformal->GetNormalizeTo() == 0, findings);
  return true;
}

// Weights for one region of the conformal map.
void addWeights(Random& random,
  vtkAlgorithm* conformal,
  vtkOMTAreaPreservingFilter* flat,
  Findings& findings)
{
  vtkNew<vtkAreaWeights> weights;
  weights->SetInputConnection(conformal->GetOutputPort());
  chooseRegions(weights, 0);
  weights->SetLabel(random.integer(1, 3));
  weights->SetFactor(random.logUniform(0.01, 100.0));
  if (runFilter(weights, findings).HasResult)
  {
    flat->SetInputConnection(weights->GetOutputPort());
    flat->SetUseAreaWeight(true);
  }
}

} // namespace

void runDrawnInputs(const Case& one, Findings& findings)
{
  Random random = scenarioRandom(one);
  const auto surface = withRegions(random, one.Surface, RegionArray);
  if (random.chance(0.2))
  {
    runPreview(random, surface, findings);
  }
  const Chain chain = newChain(one, true);
  if (!runToConformalMap(random, surface, chain, findings))
  {
    return;
  }
  auto* flat = vtkOMTAreaPreservingFilter::SafeDownCast(chain[2]);
  if (random.chance(0.3))
  {
    addWeights(random, chain[1], flat, findings);
  }
  vtkSmartPointer<vtkPolyData> polygon;
  if (random.chance(0.6))
  {
    polygon = drawnPolygon(random);
    flat->SetDomainData(polygon);
  }
  const Outcome outcome = runFilter(flat, findings);
  if (!outcome.HasResult)
  {
    return;
  }
  checkMap(flat->GetOutput(), flat->GetNormalizeTo() == 0, findings, polygon);
  findings.require(figure(flat->GetOutput(), "Bijective") == 1.0 || !outcome.Warnings.empty(),
    "no-warning",
    "Bijective is 0, but there was no warning");
}

} // namespace fuzz
