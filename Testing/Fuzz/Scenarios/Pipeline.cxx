// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Oracles/MapOracle.h"
#include "../Oracles/Triangles.h"
#include "Scenarios.h"

#include <vtkDistortionMetrics.h>
#include <vtkPolyData.h>

namespace fuzz
{

void runDisk(const Case& one, Findings& findings)
{
  runToConformalMap(newChain(one, false), one.Surface, findings);
}

void runPipeline(const Case& one, Findings& findings)
{
  const Chain chain = newChain(one, true);
  if (!runToConformalMap(chain, one.Surface, findings))
  {
    return;
  }
  const Outcome outcome = runAreaPreserving(chain, findings);
  auto* metrics = vtkDistortionMetrics::SafeDownCast(chain.at(3));
  if (outcome.HasResult && runFilter(metrics, findings).HasResult)
  {
    checkDistortion(metrics->GetOutput(), metrics->GetUseTargetArea(), findings);
    if (one.Values.empty() && outcome.Warnings.empty())
    {
      findings.Within2Percent = figure(metrics->GetOutput(), "FacesWithin2Percent");
    }
  }
}

} // namespace fuzz
