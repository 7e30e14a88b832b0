// SPDX-License-Identifier: GPL-3.0-or-later
#include "GeodesicDistance.h"

#include "EditableSurface.h"

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace flattening
{
namespace
{

// Corners of a face in ascending order of their values.
std::array<int, 3> ascending(const FaceMatrix& faces, Eigen::Index f, const Eigen::VectorXd& values)
{
  std::array<int, 3> corners{ faces(f, 0), faces(f, 1), faces(f, 2) };
  std::sort(corners.begin(), corners.end(), [&values](int a, int b) { return values[a] < values[b]; });
  return corners;
}

} // namespace

Eigen::VectorXd geodesicDistances(const TriangleMesh& mesh, int source)
{
  SurfaceMesh surface = toSurfaceMesh(mesh);
  auto distance = surface.add_property_map<SurfaceMesh::Vertex_index, double>("v:distance", 0.0).first;
  CGAL::Heat_method_3::estimate_geodesic_distances(surface, distance, SurfaceMesh::Vertex_index(source));
  Eigen::VectorXd result(mesh.vertexCount());
  for (const auto v : surface.vertices())
  {
    result[v] = distance[v];
  }
  return result;
}

double areaBelow(const TriangleMesh& mesh, const Eigen::VectorXd& values, double level)
{
  const Eigen::VectorXd areas = faceAreas(mesh.Vertices, mesh.Faces);
  double sum = 0.0;
  for (Eigen::Index f = 0; f < mesh.Faces.rows(); ++f)
  {
    const auto [low, middle, high] = ascending(mesh.Faces, f, values);
    const double a = values[low];
    const double b = values[middle];
    const double c = values[high];
    if (level >= c)
    {
      sum += areas[f];
    }
    else if (level > b)
    {
      sum += areas[f] * (1.0 - (c - level) * (c - level) / ((c - a) * (c - b)));
    }
    else if (level > a)
    {
      sum += areas[f] * (level - a) * (level - a) / ((b - a) * (c - a));
    }
  }
  return sum;
}

double levelEnclosingArea(const TriangleMesh& mesh, const Eigen::VectorXd& values, double area)
{
  double low = values.minCoeff();
  double high = values.maxCoeff();
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high))
  {
    (areaBelow(mesh, values, middle) < area ? low : high) = middle;
  }
  return high;
}

double levelCurveLength(const TriangleMesh& mesh, const Eigen::VectorXd& values, double level)
{
  const auto crossing = [&](int from, int to) -> Eigen::RowVector3d
  {
    const double t = (level - values[from]) / (values[to] - values[from]);
    return (1.0 - t) * mesh.Vertices.row(from) + t * mesh.Vertices.row(to);
  };
  double length = 0.0;
  for (Eigen::Index f = 0; f < mesh.Faces.rows(); ++f)
  {
    const auto [low, middle, high] = ascending(mesh.Faces, f, values);
    if (values[low] < level && level <= values[high])
    {
      const Eigen::RowVector3d other =
        values[middle] < level ? crossing(middle, high) : crossing(low, middle);
      length += (crossing(low, high) - other).norm();
    }
  }
  return length;
}

} // namespace flattening
