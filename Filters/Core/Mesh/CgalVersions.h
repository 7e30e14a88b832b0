// SPDX-License-Identifier: GPL-3.0-or-later
/// What CGAL 5 and CGAL 6 name differently. All guards for CGAL's versions are here.
#pragma once

#include <CGAL/version.h>

#include <CGAL/AABB_tree.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

namespace flattening
{

#if CGAL_VERSION_MAJOR >= 6
template <typename Kernel, typename Iterator>
using TriangleTree =
  CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, CGAL::AABB_triangle_primitive_3<Kernel, Iterator>>>;
#else
template <typename Kernel, typename Iterator>
using TriangleTree =
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Iterator>>>;
#endif

/// CGAL's triangulate_hole() with an output iterator for the new faces.
template <typename Mesh, typename Halfedge, typename Output, typename Parameters>
void triangulateHoleInto(Mesh& mesh, Halfedge border, Output faces, const Parameters& parameters)
{
#if CGAL_VERSION_MAJOR >= 6
  CGAL::Polygon_mesh_processing::triangulate_hole(mesh, border, parameters.face_output_iterator(faces));
#else
  CGAL::Polygon_mesh_processing::triangulate_hole(mesh, border, faces, parameters);
#endif
}

} // namespace flattening
