// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Oracles/DiskOracle.h"
#include "../Oracles/FilterRun.h"
#include "../Oracles/MapOracle.h"
#include "../Oracles/Triangles.h"
#include "Scenarios.h"

#include <vtkConformalDiskFilter.h>
#include <vtkDistortionMetrics.h>
#include <vtkNew.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkPolyData.h>
#include <vtkSurfaceToDiskFilter.h>

namespace fuzz
{

namespace
{

// @return whether there is a map to go on with
bool runToMap(const Case& one,
  vtkSurfaceToDiskFilter* disk,
  vtkConformalDiskFilter* conformal,
  Findings& findings)
{
  apply(one.Values, "SurfaceToDisk", disk);
  disk->SetInputData(one.Surface);
  if (!runFilter(disk, findings).HasResult)
  {
    return false;
  }
  ++findings.Disks;
  checkDisk(disk->GetOutput(), one.Surface, findings);
  apply(one.Values, "ConformalDisk", conformal);
  conformal->SetInputConnection(disk->GetOutputPort());
  if (!runFilter(conformal, findings).HasResult)
  {
    return false;
  }
  checkMap(conformal->GetOutput(), conformal->GetNormalizeTo() == 0, findings);
  return true;
}

} // namespace

void runDisk(const Case& one, Findings& findings)
{
  vtkNew<vtkSurfaceToDiskFilter> disk;
  vtkNew<vtkConformalDiskFilter> conformal;
  runToMap(one, disk, conformal, findings);
}

void runPipeline(const Case& one, Findings& findings)
{
  vtkNew<vtkSurfaceToDiskFilter> disk;
  vtkNew<vtkConformalDiskFilter> conformal;
  if (!runToMap(one, disk, conformal, findings))
  {
    return;
  }
  vtkNew<vtkOMTAreaPreservingFilter> flat;
  apply(one.Values, "OMTAreaPreserving", flat);
  flat->SetInputConnection(conformal->GetOutputPort());
  const Outcome outcome = runFilter(flat, findings);
  if (!outcome.HasResult)
  {
    return;
  }
  checkMap(flat->GetOutput(), flat->GetNormalizeTo() == 0, findings);
  findings.require(figure(flat->GetOutput(), "Bijective") == 1.0 || !outcome.Warnings.empty(),
    "no-warning",
    "Bijective is 0, but there was no warning");

  vtkNew<vtkDistortionMetrics> metrics;
  apply(one.Values, "DistortionMetrics", metrics);
  metrics->SetInputConnection(flat->GetOutputPort());
  if (runFilter(metrics, findings).HasResult)
  {
    checkDistortion(metrics->GetOutput(), metrics->GetUseTargetArea(), findings);
    if (one.Values.empty() && outcome.Warnings.empty())
    {
      findings.Within2Percent = figure(metrics->GetOutput(), "FacesWithin2Percent");
    }
  }
}

} // namespace fuzz
