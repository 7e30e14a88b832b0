// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Oracles/FilterRun.h"
#include "../Oracles/MapOracle.h"
#include "../Oracles/SameData.h"
#include "../Oracles/Triangles.h"
#include "Scenarios.h"

#include <vtkOMTAreaPreservingFilter.h>
#include <vtkPolyData.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace fuzz
{
namespace
{

// Surface To Disk and OMT Area Preserving, in every second case with Conformal Disk between.
Chain freeChain(const Case& one)
{
  Chain chain = newChain(one, true);
  chain.pop_back(); // Distortion Metrics
  vtkOMTAreaPreservingFilter::SafeDownCast(chain.back())->SetFreeOutline(true);
  if (one.Seed % 2 != 0)
  {
    chain.erase(chain.begin() + 1);
    chain.back()->SetInputConnection(chain.front()->GetOutputPort());
  }
  return chain;
}

struct FreeMap
{
  vtkSmartPointer<vtkPolyData> Data; // empty if a filter refused its input
  bool HasWarning = false;           // of the map itself
};

FreeMap freeMap(const Case& one, int threads, Findings& findings)
{
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  FreeMap map;
  arena.execute(
    [&]
    {
      const vtkSmartPointer<vtkDataObject> surface = copyOf(one.Surface);
      const Chain chain = freeChain(one);
      chain.front()->SetInputDataObject(surface);
      Outcome outcome;
      for (vtkAlgorithm* filter : chain)
      {
        outcome = runFilter(filter, findings);
        if (!outcome.HasResult)
        {
          return;
        }
      }
      map.Data = vtkPolyData::SafeDownCast(chain.back()->GetOutputDataObject(0));
      map.HasWarning = !outcome.Warnings.empty();
    });
  return map;
}

} // namespace

void runFreeOutline(const Case& one, Findings& findings)
{
  const FreeMap map = freeMap(one, 1, findings);
  if (map.Data)
  {
    ++findings.Disks;
    checkMap(map.Data, true, findings);
    findings.require(figure(map.Data, "Bijective") == 1.0 || map.HasWarning,
      "no-warning",
      "Bijective is 0, but there was no warning");
  }
  for (const int threads : { 2, 4 })
  {
    const FreeMap other = freeMap(one, threads, findings);
    if (!map.Data || !other.Data)
    {
      findings.require(!map.Data && !other.Data,
        "threads",
        "a map or none, by the number of threads, " + std::to_string(threads));
      continue;
    }
    const std::string differs = difference(map.Data, other.Data);
    findings.require(differs.empty(),
      "threads",
      "another result with " + std::to_string(threads) + " threads: " + differs);
  }
}

} // namespace fuzz
