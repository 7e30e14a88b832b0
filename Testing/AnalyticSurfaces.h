// SPDX-License-Identifier: GPL-3.0-or-later
/// Surfaces of revolution, whose conformal and whose area-preserving map to the disk are known exactly.
///
/// About the axis both maps are radial: a point with meridian parameter t at angle phi goes to
/// rho(t) e^(i phi). With s the arc length of the meridian and r the distance from the axis, the
/// conformal map has rho = exp(-integral_t^end ds / r), the area-preserving (Brenier) map
/// rho = sqrt(area within t / whole area).
#pragma once

#include "Mesh/TriangleMesh.h"

#include <functional>

namespace flattening::analytic
{

struct SurfaceOfRevolution
{
  using Function = std::function<double(double)>;

  double End = 1.0;         ///< the meridian parameter runs from 0, on the axis, to End, the boundary
  Function Radius;          ///< distance from the axis
  Function Height;          ///< along the axis, z; falls from the pole to the boundary
  Function ConformalRadius; ///< in [0, 1]
  Function AreaShare;       ///< area within t over whole area, in [0, 1]
  double Area = 0.0;        ///< whole area

  double brenierRadius(double t) const;
};

/// The flat unit disk: both maps are the identity.
SurfaceOfRevolution flatDisk();
/// The part of the unit sphere within @p angle (radians, below pi) of the pole; pi / 2 gives the
/// hemisphere.
SurfaceOfRevolution sphericalCap(double angle);
/// The surface z = -@p steepness r^2 over the unit disk.
SurfaceOfRevolution paraboloid(double steepness);
/// The surface z = @p height exp(-r^2 / (2 @p width^2)) over the unit disk. Its integrals are computed
/// numerically, to 1e-12.
SurfaceOfRevolution gaussianBump(double height, double width);
/// A hemisphere of radius 1 on an open cylinder of length @p length.
SurfaceOfRevolution capsule(double length);

struct RevolutionMesh
{
  TriangleMesh Mesh;         ///< vertex 0 is the pole; seen from outside counter-clockwise
  Eigen::VectorXd Parameter; ///< t of every vertex
  Eigen::VectorXd Angle;     ///< phi of every vertex, radians
  int FirstBoundaryVertex;   ///< it and all after it are on the boundary, in order of their angles
};

/// A mesh of rings at equal steps of t, with about @p vertexCount vertices. Ring i has 6 i vertices
/// until the circles stop growing, so that nearly all vertices have degree 6.
RevolutionMesh ringMesh(const SurfaceOfRevolution& surface, int vertexCount);

/// A mesh without any symmetry: about @p vertexCount vertices on Vogel's sunflower spiral, evenly spread
/// by area, with the Delaunay triangles of their conformal image.
RevolutionMesh sunflowerMesh(const SurfaceOfRevolution& surface, int vertexCount);

/// Root mean square over the vertices of |@p positions| - @p radius(t).
double radialError(const RevolutionMesh& mesh,
  const Points2& positions,
  const SurfaceOfRevolution::Function& radius);

/// Greatest distance of a vertex of @p positions from the point that @p radius and its angle give, after
/// the rotation about the origin that fits best.
double largestError(const RevolutionMesh& mesh,
  const Points2& positions,
  const SurfaceOfRevolution::Function& radius);

} // namespace flattening::analytic
