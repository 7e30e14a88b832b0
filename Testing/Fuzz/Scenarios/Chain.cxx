// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scenarios.h"

#include <vtkConformalDiskFilter.h>
#include <vtkDistortionMetrics.h>
#include <vtkOMTAreaPreservingFilter.h>
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
