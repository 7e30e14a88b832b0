// SPDX-License-Identifier: GPL-3.0-or-later
/// How well a flat map keeps lengths.
///
/// Lengths on the surface are those of shortest paths over its faces. A length is measured for pairs of
/// a source point and another point; all points are vertices. Sources are drawn so that equal areas of
/// the surface have equal chances, from a fixed seed, and the pairs of a source count by the areas of
/// the surface around the other points, so that the errors do not depend on how dense the vertices are.
#pragma once

#include "Base/Progress.h"
#include "FlatMap/LengthErrors.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{

struct LengthOptions
{
  /// Points no farther apart on the surface are local, input units. Finite and > 0.
  double Radius = 30.0;
  /// Number of source points, at least 2, but no more than the surface has vertices. Local lengths have
  /// fewer where the radius reaches over much of the surface, as LengthPairs::local() says. Global
  /// lengths have a twentieth as many, but at least 2.
  int Samples = 300;
};

struct LengthDistortion
{
  /// Pairs no farther apart than the radius on the surface whose seams are closed, against the straight
  /// line on the map.
  LengthErrors Local;
  /// Pairs no farther apart than the radius on the surface as the map opened it, against the shortest
  /// path within the map.
  LengthErrors WithinMap;
  /// All pairs, on the surface whose seams are closed, against the straight line on the map.
  LengthErrors Global;
  /// Pairs within seven rings of edges, on the surface as the map opened it, against the straight line
  /// on the map: percent, every pair the same. Of a source with more than 1000 vertices in its rings, as
  /// around a vertex of hundreds of edges, only pairs no farther apart than the radius.
  double RingDistanceError = 0.0;
  /// For each vertex (n) the mean error of its local pairs with sources, percent; -1 if it has none.
  Eigen::VectorXd VertexErrors;
};

/// Measures the lengths on the map from @p surface to the positions @p flat (n x 2). The result does not
/// depend on the number of threads.
///
/// Ju, Hurdal, Stern, Rehm, Schaper, Rottenberg, "Quantitative evaluation of three cortical surface
/// flattening methods", NeuroImage 28 (2005) compare geodesic with flat distances so; the ring distances
/// are those of Fischl, Sereno, Dale, "Cortical surface-based analysis II", NeuroImage 9 (1999), with
/// the seven rings of mris_flatten.
/// @throws InvalidInput if an option is out of its range, a coordinate is not finite, or no pair is
/// local; Cancelled.
LengthDistortion measureLengths(const TriangleMesh& surface,
  const Points2& flat,
  const LengthOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
