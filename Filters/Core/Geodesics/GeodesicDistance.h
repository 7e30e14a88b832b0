// SPDX-License-Identifier: GPL-3.0-or-later
/// Distances along a surface from one vertex or several, and the curve that encloses a given area.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// Smooth geodesic distance of every vertex of a connected manifold from @p source (n, input units): the
/// heat method on the intrinsic Delaunay triangulation (Crane, Weischedel, Wardetzky 2013, "Geodesics in
/// heat"; CGAL Heat_method_3), so that slivers do no harm.
Eigen::VectorXd geodesicDistances(const TriangleMesh& mesh,
  int source,
  const ProgressCallback& progress = {});

/// The same from the nearest of several vertices, at least one; 0 at a distance that rounding makes
/// negative.
Eigen::VectorXd geodesicDistances(const TriangleMesh& mesh,
  const std::vector<int>& sources,
  const ProgressCallback& progress = {});

/// Area of the part of the surface where the function, linear on every face, is below @p level.
double areaBelow(const TriangleMesh& mesh, const Eigen::VectorXd& values, double level);

/// The level below which lies the given area, 0 < area < total.
double levelEnclosingArea(const TriangleMesh& mesh, const Eigen::VectorXd& values, double area);

/// Length of the curve on which the function takes the value @p level.
double levelCurveLength(const TriangleMesh& mesh, const Eigen::VectorXd& values, double level);

} // namespace flattening
