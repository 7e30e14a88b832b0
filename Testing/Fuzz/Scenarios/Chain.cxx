// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Oracles/DiskOracle.h"
#include "../Oracles/MapOracle.h"
#include "../Oracles/Triangles.h"
#include "Scenarios.h"

#include <vtkConformalDiskFilter.h>
#include <vtkDistortionMetrics.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkPolyData.h>
#include <vtkSurfaceToDiskFilter.h>

namespace fuzz
{
namespace
{

template <typename Filter>
void add(Chain& chain, const Case& one, const char* name)
{
  const auto filter = vtkSmartPointer<Filter>::New();
  apply(one.Values, name, filter);
  if (!chain.empty())
  {
    filter->SetInputConnection(chain.back()->GetOutputPort());
  }
  chain.push_back(filter);
}

} // namespace

Chain newChain(const Case& one, bool isLong)
{
  Chain chain;
  add<vtkSurfaceToDiskFilter>(chain, one, "SurfaceToDisk");
  add<vtkConformalDiskFilter>(chain, one, "ConformalDisk");
  if (isLong)
  {
    add<vtkOMTAreaPreservingFilter>(chain, one, "OMTAreaPreserving");
    add<vtkDistortionMetrics>(chain, one, "DistortionMetrics");
  }
  return chain;
}

bool runToConformalMap(const Chain& chain, vtkPolyData* surface, Findings& findings)
{
  auto* disk = vtkSurfaceToDiskFilter::SafeDownCast(chain.at(0));
  auto* conformal = vtkConformalDiskFilter::SafeDownCast(chain.at(1));
  disk->SetInputData(surface);
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

Outcome runAreaPreserving(const Chain& chain, Findings& findings, vtkPolyData* polygon)
{
  auto* flat = vtkOMTAreaPreservingFilter::SafeDownCast(chain.at(2));
  Outcome outcome = runFilter(flat, findings);
  if (outcome.HasResult)
  {
    checkMap(flat->GetOutput(), flat->GetNormalizeTo() == 0, findings, polygon);
    findings.require(figure(flat->GetOutput(), "Bijective") == 1.0 || !outcome.Warnings.empty(),
      "no-warning",
      "Bijective is 0, but there was no warning");
  }
  return outcome;
}

vtkSmartPointer<vtkDataObject> copyOf(vtkDataObject* data)
{
  const auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  copy->DeepCopy(data);
  return copy;
}

Random scenarioRandom(const Case& one)
{
  return Random(one.SurfaceClass + " " + one.Scenario, one.Seed);
}

} // namespace fuzz
