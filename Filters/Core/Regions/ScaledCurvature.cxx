// SPDX-License-Identifier: GPL-3.0-or-later
#include "Regions/ScaledCurvature.h"

#include "Mesh/CoordinateFrame.h"
#include "Mesh/MeshMeasures.h"
#include "Regions/GaussianMeans.h"
#include "Regions/MeanCurvature.h"
#include "Regions/MeshSaliency.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

// The standard deviation of the mean, as a share of the square root of the area: 1.5 mm on a brain of
// 870 cm^2. A choice by eye, between the steps of the slices of a scan and the furrows of a brain.
constexpr double ShareOfSize = 0.005;
// The same in mean edges, for coarse surfaces. A convention: below one edge a mean has no second vertex.
constexpr double FewestEdges = 1.0;
// Side of the cells whose vertices are taken together, as in MeshSaliencyOptions.
constexpr double Spacing = 1.0 / 3.0;
// The share of the area that is between -1 and 1. A convention: the rest, the sharpest ridges and
// furrows, is black or white.
constexpr double ShareInRange = 0.9;
// A curvature that bends the surface by less over its own size is rounding, not shape.
constexpr double Flattest = 1e-6;

} // namespace

Eigen::VectorXd scaledCurvature(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  const TriangleMesh surface = CoordinateFrame(mesh).normalised(mesh);
  WeightedPoints points;
  points.Positions = surface.Vertices;
  points.Mass = vertexAreas(surface);
  points.Integral = integratedMeanCurvature(surface);
  const double size = std::sqrt(points.Mass.sum());
  const double deviation = std::max(ShareOfSize * size, FewestEdges * meanEdgeLength(surface));
  const Eigen::VectorXd curvature = gaussianMeans(points, deviation, Spacing, progress);
  const double scale = areaPercentile(surface, curvature.cwiseAbs(), ShareInRange);
  if (!(scale * size > Flattest))
  {
    return Eigen::VectorXd::Zero(mesh.vertexCount());
  }
  return curvature / scale;
}

} // namespace flattening
