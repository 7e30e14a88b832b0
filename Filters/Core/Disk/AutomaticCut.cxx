// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/AutomaticCut.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

// The least gain and the greatest length of a relief that Automatic cuts for a disk, which presses a
// long boundary together. Measured without slack: 18.5, 20.6 degrees of error in the disk for a brain,
// raw and remeshed, and 18.7, 22.6 with a gain of 0.2. After a relief twice as long, a brain of a
// million points had no map in an hour and a half.
constexpr double DiskGain = 0.07;
const double DiskLongest = 1.5 * std::sqrt(EIGEN_PI);
// The slack of that relief. Two coarse copies of one surface differ by a percent or two in strain, by
// which a relief need not be a third longer: on another coarse copy of the same brain one of 620 mm was
// the best, with 21.1 degrees in the disk; with this slack it is one of 410 mm, with 18.6.
constexpr double DiskSlack = 0.02;
// The least strain for which Automatic cuts a surface that has a boundary, for a disk. Measured without
// and with a relief: the skin of a head that ends at the neck, with a strain of 8.9, has 0.1 and 93 % of
// its faces within 2 %; brains that a plane opens have 27.3 and 21.4 degrees of mean angle error with a
// strain of 0.99, 25.0 and 23.1 with 0.70, and 23.8 and 27.4 with 0.66.
constexpr double DiskLeastStrain = 0.7;
// The same for a free outline. A compromise between cuts and errors: half brains that keep their
// boundary have 8 degrees of error with a strain of 0.26, which a relief lowers to 5, and 14 with 0.79.
constexpr double FreeLeastStrain = 0.3;

CutChoice openSurfaceCut(const SurfaceToDiskOptions& options, const CutSituation& situation)
{
  const bool wasCut = !options.Banks.empty();
  const bool wasChosen = options.Boundary.By == BoundaryChoice::Rule::ClosestToPoint;
  if (wasCut || wasChosen || options.Hole.Centre || situation.CutsHandles ||
      situation.RegionIsEverywhere)
  {
    return { CutMode::Hole, KeptBoundary };
  }
  return { CutMode::Relief, "the surface has a boundary, but much curvature far from it" };
}

} // namespace

const char* const KeptBoundary = "the surface has a boundary, which is kept";

CutChoice automaticCut(const SurfaceToDiskOptions& options, const CutSituation& situation)
{
  if (!options.SeamPoints.empty())
  {
    return { CutMode::Seam, "the points of a seam are given" };
  }
  if (!situation.IsClosed)
  {
    return openSurfaceCut(options, situation);
  }
  if (options.Hole.Centre)
  {
    return { CutMode::Hole, "the point of a hole is given" };
  }
  if (situation.CutsHandles)
  {
    return { CutMode::Hole, "the cuts of the handles open the surface" };
  }
  return { CutMode::Relief, "a closed surface mostly has the smallest errors after a relief" };
}

ReliefOptions automaticRelief(const ReliefOptions& asked, bool freeOutline)
{
  ReliefOptions relief = asked;
  if (freeOutline)
  {
    relief.LeastStrain = FreeLeastStrain;
    return relief;
  }
  relief.Gain = std::max(relief.Gain, DiskGain);
  relief.Longest = std::min(relief.Longest, DiskLongest);
  relief.Slack = DiskSlack;
  relief.LeastStrain = DiskLeastStrain;
  return relief;
}

} // namespace flattening
