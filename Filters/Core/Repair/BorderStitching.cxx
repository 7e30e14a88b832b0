// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/BorderStitching.h"

#include "Mesh/EditableSurface.h"

#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

namespace flattening
{

DerivedMesh stitchCoincidentBorders(const TriangleMesh& mesh)
{
  EditableSurface surface(mesh);
  CGAL::Polygon_mesh_processing::stitch_borders(surface.mesh());
  return surface.derived();
}

} // namespace flattening
