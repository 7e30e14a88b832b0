// SPDX-License-Identifier: GPL-3.0-or-later
/// A part of a colon as in virtual colonoscopy, with polyps of known positions and sizes.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening::phantom
{

struct Polyp
{
  Eigen::RowVector3d Centre; ///< on the wall; the polyp is a ball around a point near it (mm)
  double Diameter;           ///< mm
};

struct Colon
{
  TriangleMesh Mesh; ///< the lumen's surface, normals out of the lumen, open at both ends
  std::vector<Polyp> Polyps;
};

/// A curved tube 300 mm long, of radius 20 mm, with haustral folds 25 mm apart that rise 7 mm into the
/// lumen between three taeniae, as an isosurface with grid points @p spacing (mm) apart. Polyps: balls
/// on the wall, half in it, three each of diameters 4, 6, 8, 10 and 12 mm, on folds and between them, at
/// random positions (@p seed) at least 18 mm apart. The corner between ball and wall is rounded by
/// 1 mm.
Colon generateColon(double spacing = 1.0, unsigned seed = 1);

} // namespace flattening::phantom
