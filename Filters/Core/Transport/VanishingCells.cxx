// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/VanishingCells.h"

namespace flattening
{
namespace
{

// Rounds of raising weights. A choice: each costs a power diagram, and shorter steps cost no more.
constexpr int LargestRounds = 8;
// The first raise gains so many least areas in the linear model, and each further raise is so many times
// as large: a raise that is too small costs a round, one that is too large takes area from neighbours.
constexpr double FirstGain = 10.0;
constexpr double Growth = 4.0;
// The largest share of cells that may vanish. A choice: with more, the raised cells change the others.
constexpr double LargestShare = 0.02;
// Rounds that leave no fewer vanishing cells than the one before. A guard: after two, raising does not
// end.
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
    int vanishing = 0;
    for (int i = 0; i < diagram.siteCount(); ++i)
    {
      if (!(diagram.areas()[i] >= least[i]))
      {
        ++vanishing;
        weights[i] += raises[i];
        raises[i] *= Growth;
      }
    }
    if (vanishing == 0)
    {
      return true;
    }
    setbacks += vanishing >= before;
    before = vanishing;
    if (vanishing > largest || setbacks > LargestSetbacks || round == LargestRounds)
    {
      return false;
    }
    report(progress, 0.0, "Raising the weights of vanishing cells");
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
