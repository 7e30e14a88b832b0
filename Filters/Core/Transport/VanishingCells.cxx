// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/VanishingCells.h"

namespace flattening
{
namespace
{

constexpr int LargestRounds = 8;
constexpr double FirstGain = 10.0; // of area, in units of the least, were there no other change
constexpr double Growth = 4.0;
constexpr double LargestShare = 0.02;
// Rounds that may leave no fewer cells starved than the one before; of more, feeding does not end.
constexpr int LargestSetbacks = 1;

} // namespace

int largestVanishing(int sites)
{
  return static_cast<int>(LargestShare * sites);
}

bool feedVanishingCells(PowerDiagram& diagram,
  PowerDiagram::Weights& weights,
  const Eigen::VectorXd& least,
  const Eigen::VectorXd& slopes,
  const ProgressCallback& progress)
{
  const int largest = largestVanishing(diagram.siteCount());
  int before = diagram.siteCount();
  int setbacks = 0;
  Eigen::VectorXd raises = FirstGain * least.array() / slopes.array();
  for (int round = 0;; ++round)
  {
    for (const PowerDiagram::HiddenSite& hidden : diagram.hiddenSites())
    {
      weights[hidden.Site] += hidden.Lacking;
    }
    int starved = 0;
    for (int i = 0; i < diagram.siteCount(); ++i)
    {
      if (!(diagram.areas()[i] >= least[i]))
      {
        ++starved;
        weights[i] += raises[i];
        raises[i] *= Growth;
      }
    }
    if (starved == 0)
    {
      return true;
    }
    setbacks += starved >= before;
    before = starved;
    if (starved > largest || setbacks > LargestSetbacks || round == LargestRounds)
    {
      return false;
    }
    report(progress, 0.0, "Feeding starved cells");
    if (!diagram.update(weights, largest))
    {
      return false;
    }
  }
}

Eigen::VectorXd ownSlopes(const PowerDiagram& diagram)
{
  Eigen::VectorXd slopes = Eigen::VectorXd::Zero(diagram.siteCount());
  for (const PowerDiagram::CommonSide& side : diagram.commonSides())
  {
    const double slope = side.slope();
    slopes[side.First] += slope;
    slopes[side.Second] += slope;
  }
  return slopes;
}

} // namespace flattening
