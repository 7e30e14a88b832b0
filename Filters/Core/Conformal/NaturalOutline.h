// SPDX-License-Identifier: GPL-3.0-or-later
/// The conformal map whose outline is free, and a one-to-one map near it.
#pragma once

#include "Base/Progress.h"
#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/GraphLaplacian.h"
#include "Mesh/TriangleMesh.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace flattening
{

/// The conformal map whose boundary keeps its lengths, which of all conformal maps changes areas least
/// (Sawhney and Crane 2017, "Boundary First Flattening", sections 4 and 5). The outline bends at each
/// boundary vertex by the curvature there and by the curvature of the inside that reaches the vertex: a
/// share of the angle defect of every inner vertex, as large as the share of the boundary vertex in its
/// harmonic measure. The polygon with these angles is closed by the smallest change of lengths; inside,
/// both coordinates are harmonic. The cotangents are those of the intrinsic Delaunay triangulation.
class NaturalOutlineMap
{
public:
  /// @p mesh is a disk with the boundary @p loop (see requireDisk).
  /// @throws ConvergenceError if the Laplacian cannot be factored; Cancelled.
  NaturalOutlineMap(const TriangleMesh& mesh,
    const std::vector<int>& loop,
    const ProgressCallback& progress = {});

  /// The outline: the positions of the loop's vertices (input units). It may cross itself.
  /// @param roundness  in [0, 1]: the share by which its angles are replaced with angles in proportion
  ///                   to the lengths, those of a convex polygon; 0 for the natural outline
  Points2 outline(double roundness = 0.0) const;

  /// The map (n x 2) with this @p outline. It is harmonic inside, with protrusions spread as in a map to
  /// the disk (spreadProtrusions). Faces may be flipped.
  /// @throws ConvergenceError, Cancelled.
  Points2 extended(const Points2& outline, const ProgressCallback& progress = {});

private:
  const std::vector<int>& Loop;
  IntrinsicTriangulation Surface;
  double Area;                                // of the surface
  IntrinsicTriangulation::Factors LogFactors; // of the conformal map with the natural outline
  Eigen::VectorXd Lengths;                    // of the edges that follow the vertices of the loop
  Eigen::VectorXd Angles; // of the natural outline: exterior ones, at the vertices of the loop
  std::optional<WeightedMeans> Means;
};

/// One-to-one maps of a disk near the one with the natural outline. Their outlines are rounder and
/// rounder; flipped faces are untangled and, where that needs it, the outline is moved (makeOneToOne).
class MapsNearNaturalOutline
{
public:
  /// @p mesh is a disk with the boundary @p loop. Both must live as long as this does.
  /// @throws ConvergenceError if the Laplacian cannot be factored; Cancelled.
  MapsNearNaturalOutline(const TriangleMesh& mesh,
    const std::vector<int>& loop,
    const ProgressCallback& progress = {});

  /// The next map, the first one at the first call: that of the next outline that does not cross itself
  /// and whose faces can be untangled. Nothing if there is none.
  /// @throws ConvergenceError, Cancelled.
  std::optional<Points2> next(const ProgressCallback& progress = {});

private:
  const TriangleMesh& Mesh;
  const std::vector<int>& Loop;
  NaturalOutlineMap Natural;
  std::size_t Tried = 0; // outlines
};

} // namespace flattening
