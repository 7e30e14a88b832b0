// SPDX-License-Identifier: GPL-3.0-or-later
/// Distances along a surface from one vertex or several, and level curves of functions such as
/// distances.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// The smooth geodesic distance of every vertex of a connected manifold, in which every vertex has a
/// face, from vertex @p source (n, input units), by the heat method on the intrinsic Delaunay
/// triangulation (Crane, Weischedel, Wardetzky 2013, "Geodesics in heat"), on which slivers do no harm.
///
/// The heat method is the project's own, because that of CGAL (Heat_method_3) cannot be aborted while it
/// factors and takes faces without area as they are: here the intrinsic triangulation lengthens their
/// edges, and both systems share one order of elimination.
/// @throws ConvergenceError if a system cannot be factored; Cancelled.
Eigen::VectorXd geodesicDistances(const TriangleMesh& mesh,
  int source,
  const ProgressCallback& progress = {});

/// The distance of every vertex from the nearest of several vertices, at least one. Distances that
/// rounding makes negative are 0.
Eigen::VectorXd geodesicDistances(const TriangleMesh& mesh,
  const std::vector<int>& sources,
  const ProgressCallback& progress = {});

/// The level below which a function, given by its values at the vertices (n) and linear on every face,
/// encloses the given area (0 < area < area of the surface).
double levelEnclosingArea(const TriangleMesh& mesh, const Eigen::VectorXd& values, double area);

/// The length of the curve on which such a function takes the value @p level, input units.
double levelCurveLength(const TriangleMesh& mesh, const Eigen::VectorXd& values, double level);

} // namespace flattening
