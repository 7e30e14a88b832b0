// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/SurfaceRepair.h"

#include "Base/Errors.h"
#include "Repair/CoincidentPoints.h"
#include "Repair/ConsistentOrientation.h"
#include "Repair/NeedlesAndCaps.h"
#include "Repair/TJunctions.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

// Of the faces with the same three vertices, the first one stays.
int dropDuplicates(FaceList& list)
{
  std::vector<std::pair<Triangle, int>> sorted; // by the vertices, then by the index of the face
  sorted.reserve(list.Faces.size());
  for (Triangle face : list.Faces)
  {
    std::sort(face.begin(), face.end());
    sorted.emplace_back(face, static_cast<int>(sorted.size()));
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<char> duplicate(sorted.size(), 0);
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    duplicate[sorted[i].second] = sorted[i].first == sorted[i - 1].first;
  }
  return list.dropIf([&duplicate](std::size_t f) { return duplicate[f] != 0; });
}

// The faces between representatives of coincident points; counts the points merged and unused.
FaceList mergedFaces(const TriangleMesh& soup,
  double tolerance,
  const std::vector<char>& keptApart,
  RepairReport& report)
{
  std::vector<int> representative = coincidentPoints(soup.Vertices, tolerance);
  for (std::size_t v = 0; v < keptApart.size(); ++v)
  {
    if (keptApart[v] || keptApart[representative[v]])
    {
      representative[v] = static_cast<int>(v);
    }
  }
  std::vector<char> used(soup.vertexCount(), 0);
  FaceList list;
  list.Faces.resize(soup.faceCount());
  list.Origins.resize(soup.faceCount());
  for (int f = 0; f < soup.faceCount(); ++f)
  {
    list.Origins[f] = f;
    for (int k = 0; k < 3; ++k)
    {
      used[soup.Faces(f, k)] = 1;
      list.Faces[f][k] = representative[soup.Faces(f, k)];
    }
  }
  for (int v = 0; v < soup.vertexCount(); ++v)
  {
    report.UnusedPoints += !used[v];
    report.MergedPoints += used[v] && representative[v] != v;
  }
  return list;
}

// The faces with only the vertices that they use.
DerivedMesh withoutUnusedVertices(const Points3& vertices, const FaceList& list)
{
  TriangleMesh mesh;
  mesh.Vertices = vertices;
  mesh.Faces.resize(static_cast<Eigen::Index>(list.Faces.size()), 3);
  for (std::size_t f = 0; f < list.Faces.size(); ++f)
  {
    std::copy(list.Faces[f].begin(), list.Faces[f].end(), mesh.Faces.row(f).begin());
  }
  std::vector<int> all(list.Faces.size());
  std::iota(all.begin(), all.end(), 0);
  return extractFaces(mesh, all);
}

} // namespace

void requireUsableFaces(const TriangleMesh& soup)
{
  if (soup.faceCount() == 0)
  {
    throw InvalidInput("the surface has no triangles: pass a surface, e.g. from Contour");
  }
  for (int f = 0; f < soup.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = soup.Faces(f, k);
      if (v < 0 || v >= soup.vertexCount())
      {
        throw InvalidInput("face " + std::to_string(f) + " names vertex " + std::to_string(v) +
                           ", but there are " + std::to_string(soup.vertexCount()) +
                           " vertices: the data set is damaged");
      }
      if (!soup.Vertices.row(v).allFinite())
      {
        throw InvalidInput("point " + std::to_string(v) + " of face " + std::to_string(f) +
                           " has a coordinate that is not finite: remove such points first, e.g. with "
                           "Threshold or Extract Selection");
      }
    }
  }
}

RepairedSurface repairTriangleSoup(const TriangleMesh& soup,
  double tolerance,
  const std::vector<char>& keptApart)
{
  requireUsableFaces(soup);
  RepairedSurface repaired;
  RepairReport& report = repaired.Report;
  FaceList list = mergedFaces(soup, tolerance, keptApart, report);
  report.DegenerateFaces = list.dropIf([&list](std::size_t f) { return repeatsVertex(list.Faces[f]); });
  const RemovedSlivers removed = removeNeedlesAndCaps(soup.Vertices, list);
  report.MergedPoints += removed.JoinedVertices;
  report.DegenerateFaces += removed.Faces;
  report.DuplicateFaces = dropDuplicates(list);
  if (list.Faces.empty())
  {
    throw InvalidInput("the surface has zero area: all of its " + std::to_string(soup.faceCount()) +
                       " triangles are degenerate; check the coordinates and the merge tolerance");
  }
  if (keptApart.empty() || std::count(keptApart.begin(), keptApart.end(), 0) > 0)
  {
    report.ClosedTJunctions = closeTJunctions(soup.Vertices, list, tolerance);
    report.DuplicateFaces += report.ClosedTJunctions > 0 ? dropDuplicates(list) : 0;
  }

  repaired.Surface = withoutUnusedVertices(soup.Vertices, list);
  OrientedMesh oriented = orientConsistently(repaired.Surface.Mesh);
  const int used = repaired.Surface.Mesh.vertexCount();
  report.SplitPoints = oriented.Mesh.vertexCount() - used;
  follow(repaired.Surface,
    { std::move(oriented.Mesh), keptVertices(oriented.CopyOf, used), repaired.Surface.Faces });
  repaired.Surface.Faces = std::move(list.Origins);
  repaired.Reversed = std::move(oriented.Reversed);
  repaired.OneSided = std::move(oriented.OneSided);
  return repaired;
}

} // namespace flattening
