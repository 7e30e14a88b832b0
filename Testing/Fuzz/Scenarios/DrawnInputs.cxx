// SPDX-License-Identifier: GPL-3.0-or-later
#include "DrawnShapes.h"
#include "Scenarios.h"

#include <vtkAreaWeights.h>
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

// Chooses a cut of a disk, and what it needs.
void drawCut(Random& random, vtkPolyData* surface, vtkSurfaceToDiskFilter* disk, Findings& findings)
{
  chooseRegions(disk, 0); // of interest
  chooseRegions(disk, 1); // labels to cut off
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

// Runs the preview of a seam between points of the surface.
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
  // Points that are nearest to the same point of the surface have no leg, which is right.
  Findings found;
  runFilter(preview, found);
  for (const Failure& failure : found.Failures)
  {
    findings.require(failure.Kind == "silent-failure", failure.Kind, failure.Detail);
  }
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
  drawCut(random, surface, vtkSurfaceToDiskFilter::SafeDownCast(chain[0]), findings);
  if (!runToConformalMap(chain, surface, findings))
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
  runAreaPreserving(chain, findings, polygon);
}

} // namespace fuzz
