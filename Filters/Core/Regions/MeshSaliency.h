// SPDX-License-Identifier: GPL-3.0-or-later
/// How much each place of a surface stands out from its surroundings, on several scales, and the regions
/// that do.
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
  /// Number of scales, 1 to 20: of standard deviations 2, 3, ... units.
  int Scales = 5;
  /// Whether vertices count by the area around them. If not, each counts the same, as in the paper, and
  /// where the triangles are finer counts more.
  bool AreaWeighted = true;
  /// The cells, in standard deviations, whose vertices count together; 0: each vertex by itself, exact
  /// but slow on large surfaces. In [0, 1].
  double SampleSpacing = 1.0 / 3.0;
};

struct MeshSaliency
{
  Eigen::VectorXd Saliency;              ///< n, >= 0, dimensionless
  std::vector<Eigen::VectorXd> PerScale; ///< n each: S_i before normalisation (one over input units)
  Eigen::VectorXd MeanCurvature;         ///< n (one over input units)
  double Unit = 0.0;                     ///< that was used
};

/// Lee, Varshney, Jacobs, "Mesh saliency", SIGGRAPH 2005. With G(s) the Gaussian-weighted mean of the
/// mean curvature over the ball of radius 2 s: S_i = |G(s_i) - G(2 s_i)|; each S_i is divided by its
/// maximum and multiplied by (1 - m)^2, where m is the mean of its other local maxima (over the edges),
/// so that a scale with a few high peaks counts more than one with many alike; the sum is the saliency.
/// A scale on which nothing stands out, to rounding, is 0.
/// @throws InvalidInput for options out of range, coordinates that are not finite, a surface without
/// area, or scales larger than the surface: 24 units (4 (Scales + 1) in general) beyond the diagonal.
MeshSaliency meshSaliency(const TriangleMesh& mesh,
  const MeshSaliencyOptions& options = {},
  const ProgressCallback& progress = {});

/// The value that is exceeded on a share 1 - @p fraction of the area, @p fraction in [0, 1].
double areaPercentile(const TriangleMesh& mesh, const Eigen::VectorXd& values, double fraction);

/// Regions of interest: sets of vertices with values of at least @p threshold that edges connect, of an
/// area (a third of that of the triangles around each vertex) from @p smallest to @p largest.
/// Of each vertex (n) the number of its region, 1 for that of the largest area; 0: in none.
std::vector<int> salientRegions(const TriangleMesh& mesh,
  const Eigen::VectorXd& values,
  double threshold,
  double smallest,
  double largest);

} // namespace flattening
