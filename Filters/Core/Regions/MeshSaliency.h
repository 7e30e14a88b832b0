// SPDX-License-Identifier: GPL-3.0-or-later
/// Saliency: how much each point of a surface stands out from its surroundings on several scales, and
/// the regions of high saliency.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

struct MeshSaliencyOptions
{
  /// The unit of the scales (input units, > 0); 0: 0.3 % of the diagonal of the bounding box.
  double Unit = 0.0;
  /// Number of scales, 1 to 20; they have the standard deviations 2, 3, ... units.
  int Scales = 5;
  /// Whether vertices are weighted by the area around them. If not, all weigh the same, as in the paper,
  /// so that parts with finer triangles weigh more.
  bool AreaWeighted = true;
  /// Side of the cells whose vertices are taken together, in standard deviations, in [0, 1]. 0 takes
  /// each vertex by itself, which is exact but slow on large surfaces.
  double SampleSpacing = 1.0 / 3.0;
};

struct MeshSaliency
{
  Eigen::VectorXd Saliency;              ///< n, >= 0, dimensionless
  std::vector<Eigen::VectorXd> PerScale; ///< n each: S_i before normalisation (one over input units)
  Eigen::VectorXd MeanCurvature;         ///< n (one over input units)
  double Unit = 0.0;                     ///< the unit that was used, input units
};

/// Lee, Varshney, Jacobs, "Mesh saliency", SIGGRAPH 2005. With G(s) the Gaussian-weighted mean of the
/// mean curvature over the ball of radius 2 s: S_i = |G(s_i) - G(2 s_i)|; each S_i is divided by its
/// maximum and multiplied by (1 - m)^2, where m is the mean of its other local maxima (over the edges),
/// so that a scale with a few high peaks counts more than one with many alike; the sum is the saliency.
/// A scale on which all points are alike up to rounding is 0.
/// @throws InvalidInput for options out of range, coordinates that are not finite, a surface without
/// area, or scales larger than the surface: the radius of the largest ball, 4 (Scales + 1) units, must
/// not exceed the diagonal of the bounding box.
MeshSaliency meshSaliency(const TriangleMesh& mesh,
  const MeshSaliencyOptions& options = {},
  const ProgressCallback& progress = {});

/// The value that is exceeded on a share 1 - @p fraction of the area.
/// @param fraction in [0, 1].
double areaPercentile(const TriangleMesh& mesh, const Eigen::VectorXd& values, double fraction);

/// Finds regions of interest: sets of vertices with values of at least @p threshold that are connected
/// by edges, and whose area (a third of the area of the triangles around each vertex) is from @p
/// smallest to
/// @p largest (input units squared).
/// @return the number of the region of each vertex (n), 1 for the region of the largest area; 0 for
/// none.
std::vector<int> salientRegions(const TriangleMesh& mesh,
  const Eigen::VectorXd& values,
  double threshold,
  double smallest,
  double largest);

} // namespace flattening
