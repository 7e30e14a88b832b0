// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/IntersectionQueries.h"

#include "Mesh/EditableSurface.h"

#include <CGAL/boost/graph/selection.h>
#include <CGAL/property_map.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <set>

namespace flattening
{
namespace
{

using Vertex = MeshOnSurface::Vertex;
using Face = MeshOnSurface::Face;

// The greatest number of entries of all lists of faces near groups: a guard. Each change and each count
// looks at all faces of a list, some hundred times for each list, so that a million entries take seconds
// and the time for larger surfaces grows with their faces alone.
constexpr std::size_t MostNear = 1000000;
constexpr std::size_t MostNearPerFace = 2;

std::vector<PlacedTriangle> placed(const MeshOnSurface& surface, const std::vector<Face>& faces)
{
  std::vector<PlacedTriangle> result;
  result.reserve(faces.size());
  for (const Face f : faces)
  {
    result.push_back(flattening::placed(surface.triangle(f)));
  }
  return result;
}

std::vector<Face> allFaces(const MeshOnSurface& surface)
{
  return { surface.mesh().faces().begin(), surface.mesh().faces().end() };
}

} // namespace

PlacedTriangle placed(const CornerTriangle& triangle)
{
  PlacedTriangle result;
  for (int k = 0; k < 3; ++k)
  {
    result.Vertices[k] = triangle[k].Vertex;
    result.Points[k] = *triangle[k].Position;
  }
  return result;
}

bool intersect(const MeshOnSurface& surface, const FacePair& pair)
{
  return intersect(placed(surface.triangle(pair.first)), placed(surface.triangle(pair.second)));
}

std::optional<FacePairs> intersectingFaces(const MeshOnSurface& surface,
  TrackedIntersections& known,
  const ProgressCallback& progress)
{
  known.update(toTriangleMesh(surface.mesh()), progress);
  if (!known.pairs())
  {
    return std::nullopt;
  }
  const std::vector<Face> faces = allFaces(surface); // in the order of that mesh
  FacePairs pairs;
  for (const auto& [i, j] : *known.pairs())
  {
    pairs.emplace_back(faces[i], faces[j]);
  }
  return pairs;
}

FacePairs intersectingFaces(const MeshOnSurface& surface,
  const std::vector<Face>& faces,
  const ProgressCallback& progress)
{
  FacePairs pairs;
  for (const auto& [i, j] : intersectingPairs(placed(surface, faces), progress))
  {
    pairs.emplace_back(faces[i], faces[j]);
  }
  return pairs;
}

int countIntersections(const MeshOnSurface& surface,
  const std::vector<Face>& some,
  const std::vector<Face>& near)
{
  const std::vector<PlacedTriangle> first = placed(surface, some);
  const std::vector<PlacedTriangle> second = placed(surface, near);
  const auto counts = [&](int i, int j)
  {
    const bool again = near[j] <= some[i] && std::binary_search(some.begin(), some.end(), near[j]);
    return !again && intersect(first[i], second[j]);
  };
  return static_cast<int>(countOverlappingBoxes(first, second, counts));
}

std::vector<Vertex> verticesAround(const MeshOnSurface& surface, const FacePair& pair, int edges)
{
  const MeshOnSurface::Mesh& mesh = surface.mesh();
  std::set<Vertex> around;
  for (const Face f : { pair.first, pair.second })
  {
    const auto corners = mesh.vertices_around_face(mesh.halfedge(f));
    around.insert(corners.begin(), corners.end());
  }
  CGAL::expand_vertex_selection(std::vector<Vertex>(around.begin(), around.end()),
    mesh,
    edges,
    CGAL::make_boolean_property_map(around),
    CGAL::Emptyset_iterator());
  return { around.begin(), around.end() };
}

std::vector<Face> unitedFaces(const std::vector<std::vector<Face>>& lists)
{
  std::vector<Face> all;
  for (const std::vector<Face>& faces : lists)
  {
    all.insert(all.end(), faces.begin(), faces.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::optional<std::vector<std::vector<Face>>> facesNear(const MeshOnSurface& surface,
  const std::vector<std::vector<Vertex>>& groups)
{
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const std::vector<Vertex>& group : groups)
  {
    Eigen::AlignedBox3d box;
    for (const Vertex v : group)
    {
      box.extend(surface.mesh().point(v));
    }
    const Eigen::Vector3d margin = 0.25 * box.sizes();
    boxes.emplace_back(box.min() - margin, box.max() + margin);
  }
  const std::vector<Face> faces = allFaces(surface);
  const auto pairs = fewOverlappingBoxes(
    boxes,
    static_cast<int>(faces.size()),
    [&](int f) { return flattening::placed(surface.triangle(faces[f])).box(); },
    std::max(MostNear, MostNearPerFace * faces.size()));
  if (!pairs)
  {
    return std::nullopt;
  }
  std::vector<std::vector<Face>> near(groups.size());
  for (const auto& [group, face] : *pairs)
  {
    near[group].push_back(faces[face]);
  }
  return near;
}

} // namespace flattening
