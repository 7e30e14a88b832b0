// SPDX-License-Identifier: GPL-3.0-or-later
#include "IsotropicRemeshing.h"

#include "EditableSurface.h"
#include "SurfaceProjection.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

constexpr double FewestFaces = 20.0;

void requireSensibleLength(const TriangleMesh& mesh, double length)
{
  std::ostringstream message; // lengths of any order of magnitude
  if (!(length > 0.0) || !std::isfinite(length))
  {
    message << "the target edge length is " << length
            << ": set a positive length in the units of the surface";
    throw InvalidInput(message.str());
  }
  const double area = faceAreas(mesh.Vertices, mesh.Faces).sum();
  const double longest = std::sqrt(area / FewestFaces * 4.0 / std::sqrt(3.0)); // of equilateral faces
  if (length > longest)
  {
    message << "the target edge length " << length << " would leave fewer than " << FewestFaces
            << " faces: set it below " << longest;
    throw InvalidInput(message.str());
  }
}

// Traces the new mesh to the nearest places on the old one.
DerivedMesh traced(TriangleMesh remeshed, const TriangleMesh& old, const ProgressCallback& progress)
{
  constexpr int ReportInterval = 1 << 14;
  const SurfaceProjection projection(old);
  std::vector<Eigen::Triplet<double, int>> weights;
  weights.reserve(3 * remeshed.vertexCount());
  const double work = remeshed.vertexCount() + remeshed.faceCount();
  for (int v = 0; v < remeshed.vertexCount(); ++v)
  {
    if (v % ReportInterval == 0)
    {
      report(progress, v / work, "carrying attributes over");
    }
    const SurfacePoint at = projection.closest(remeshed.Vertices.row(v).transpose());
    for (int k = 0; k < 3; ++k)
    {
      if (at.Weights[k] > 0.0)
      {
        weights.emplace_back(v, old.Faces(at.Face, k), at.Weights[k]);
      }
    }
  }
  DerivedMesh result;
  result.Vertices.resize(remeshed.vertexCount(), old.vertexCount());
  result.Vertices.setFromTriplets(weights.begin(), weights.end());
  result.Faces.resize(remeshed.faceCount());
  for (int f = 0; f < remeshed.faceCount(); ++f)
  {
    if (f % ReportInterval == 0)
    {
      report(progress, (remeshed.vertexCount() + f) / work, "carrying attributes over");
    }
    const Eigen::Vector3d centroid =
      (remeshed.Vertices.row(remeshed.Faces(f, 0)) + remeshed.Vertices.row(remeshed.Faces(f, 1)) +
        remeshed.Vertices.row(remeshed.Faces(f, 2)))
        .transpose() /
      3.0;
    result.Faces[f] = projection.closest(centroid).Face;
  }
  result.Mesh = std::move(remeshed);
  return result;
}

} // namespace

double meanEdgeLength(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      sum +=
        (mesh.Vertices.row(mesh.Faces(f, k)) - mesh.Vertices.row(mesh.Faces(f, (k + 1) % 3))).norm();
    }
  }
  return sum / (3.0 * mesh.faceCount());
}

DerivedMesh remeshIsotropically(const TriangleMesh& mesh,
  double targetEdgeLength,
  int iterations,
  const ProgressCallback& progress)
{
  requireSensibleLength(mesh, targetEdgeLength);
  SurfaceMesh surface = toSurfaceMesh(mesh);
  report(progress, 0.0, "remeshing");
  CGAL::Polygon_mesh_processing::isotropic_remeshing(
    surface.faces(), targetEdgeLength, surface, CGAL::parameters::number_of_iterations(iterations));
  report(progress, 0.6, "remeshing");
  return traced(toTriangleMesh(surface), mesh, subrange(progress, 0.6, 1.0));
}

} // namespace flattening
