// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/SurfaceToDiskOptions.h"

#include "Base/Errors.h"

#include <cmath>
#include <string>

namespace flattening
{

void requireValid(const SurfaceToDiskOptions& options, const TriangleMesh& soup)
{
  if (!(options.MergeTolerance >= 0.0) || !std::isfinite(options.MergeTolerance))
  {
    throw InvalidInput("the merge tolerance is " + formatted(options.MergeTolerance) +
                       ": set it to 0 or a small length in the units of the surface");
  }
  if (!(options.FillLengthLimit >= 0.0) || !std::isfinite(options.FillLengthLimit))
  {
    throw InvalidInput("the longest boundary to be filled is " + formatted(options.FillLengthLimit) +
                       ": set it to 0 or a length in the units of the surface");
  }
  if (options.Remesh && options.TargetEdgeLength == 0.0 &&
      (!(options.RelativeEdgeLength > 0.0) || !std::isfinite(options.RelativeEdgeLength)))
  {
    throw InvalidInput("the relative edge length is " + formatted(options.RelativeEdgeLength) +
                       ": set it above 0, in mean edge lengths of the surface");
  }
  if (!(options.SmallestAngle >= 0.0 && options.SmallestAngle <= 15.0))
  {
    throw InvalidInput(
      "the smallest angle is " + formatted(options.SmallestAngle) + " degrees: set it between 0 and 15");
  }
  if (!options.RegionOfInterest.empty() &&
      options.RegionOfInterest.size() != static_cast<std::size_t>(soup.vertexCount()))
  {
    throw InvalidInput("the region of interest has " + std::to_string(options.RegionOfInterest.size()) +
                       " values for " + std::to_string(soup.vertexCount()) + " points");
  }
  if (!options.Banks.empty() && options.Banks.size() != static_cast<std::size_t>(soup.vertexCount()))
  {
    throw InvalidInput("the banks of seams have " + std::to_string(options.Banks.size()) +
                       " flags for " + std::to_string(soup.vertexCount()) +
                       " points: pass one flag per point");
  }
  if (options.Cut == CutMode::Label &&
      options.Labelled.size() != static_cast<std::size_t>(soup.faceCount()))
  {
    throw InvalidInput("the label has " + std::to_string(options.Labelled.size()) + " flags for " +
                       std::to_string(soup.faceCount()) + " faces: pass one flag per face");
  }
}

} // namespace flattening
