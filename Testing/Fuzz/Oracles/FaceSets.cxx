// SPDX-License-Identifier: GPL-3.0-or-later
#include "FaceSets.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace fuzz
{
namespace
{

using Edge = std::pair<vtkIdType, vtkIdType>;

// The sides of all faces, each from its first point to its second in the direction of the face.
std::set<Edge> directedEdges(const Triangles& mesh)
{
  std::set<Edge> edges;
  for (const Triangle& face : mesh.Faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert({ face[k], face[(k + 1) % 3] });
    }
  }
  return edges;
}

} // namespace

Measure areaWhere(const Triangles& mesh, const FaceSet& faces)
{
  Measure area;
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    if (faces[f])
    {
      const long double one = areaOf(mesh, mesh.Faces[f]);
      area.Value += one;
      area.Rounding += SumRounding * one + NeedleRounding * greatestSquaredSide(mesh, mesh.Faces[f]);
    }
  }
  return area;
}

Triangles partOf(const Triangles& mesh, const FaceSet& faces)
{
  Triangles part{ mesh.Points, {} };
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    if (faces[f])
    {
      part.Faces.push_back(mesh.Faces[f]);
    }
  }
  return part;
}

bool isIn(const FaceSet& part, const FaceSet& whole)
{
  for (std::size_t f = 0; f < part.size(); ++f)
  {
    if (part[f] && !whole[f])
    {
      return false;
    }
  }
  return true;
}

FaceSet joined(FaceSet faces, const std::vector<FaceSet>& others)
{
  for (const FaceSet& other : others)
  {
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      faces[f] = faces[f] || other[f];
    }
  }
  return faces;
}

std::vector<FaceSet> piecesOf(const Triangles& mesh, const FaceSet& faces)
{
  std::vector<std::vector<std::size_t>> around(mesh.Points.size());
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    for (int k = 0; faces[f] && k < 3; ++k)
    {
      around[mesh.Faces[f][k]].push_back(f);
    }
  }
  std::vector<FaceSet> pieces;
  FaceSet rest = faces;
  for (std::size_t first = 0; first < rest.size(); ++first)
  {
    if (!rest[first])
    {
      continue;
    }
    FaceSet piece(rest.size());
    std::vector<std::size_t> queue{ first };
    rest[first] = false;
    while (!queue.empty())
    {
      const std::size_t f = queue.back();
      queue.pop_back();
      piece[f] = true;
      for (const vtkIdType p : mesh.Faces[f])
      {
        for (const std::size_t g : around[p])
        {
          if (rest[g])
          {
            rest[g] = false;
            queue.push_back(g);
          }
        }
      }
    }
    pieces.push_back(piece);
  }
  return pieces;
}

std::vector<FaceSet> holesIn(const Triangles& surface, const FaceSet& faces)
{
  FaceSet others = faces;
  others.flip();
  std::set<vtkIdType> boundary;
  for (const std::vector<vtkIdType>& loop : boundaryLoops(surface))
  {
    boundary.insert(loop.begin(), loop.end());
  }
  std::vector<FaceSet> holes;
  const std::vector<FaceSet> parts = piecesOf(surface, others);
  for (const FaceSet& part : parts)
  {
    bool isOpen = false;
    for (std::size_t f = 0; f < part.size(); ++f)
    {
      for (const vtkIdType p : surface.Faces[f])
      {
        isOpen = isOpen || (part[f] && boundary.count(p) == 1);
      }
    }
    if (!isOpen)
    {
      holes.push_back(part);
    }
  }
  if (!holes.empty() && holes.size() == parts.size())
  {
    holes.erase(std::max_element(holes.begin(),
      holes.end(),
      [&](const FaceSet& a, const FaceSet& b)
      { return areaWhere(surface, a).Value < areaWhere(surface, b).Value; }));
  }
  return holes;
}

bool touchesItself(const Triangles& mesh)
{
  std::set<vtkIdType> ends;
  const std::set<Edge> edges = directedEdges(mesh);
  return std::any_of(edges.begin(),
    edges.end(),
    [&](const Edge& edge) {
      return edges.count({ edge.second, edge.first }) == 0 && !ends.insert(edge.first).second;
    });
}

// The faces must be connected by edges, and have a boundary and the Euler number 1. No other surface
// has: if fans of faces met in a point, separating them would give a surface of an even greater Euler
// number.
bool isDisk(const Triangles& mesh)
{
  const std::set<Edge> directed = directedEdges(mesh);
  std::map<Edge, std::vector<std::size_t>> facesOf;
  std::set<vtkIdType> points;
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType a = mesh.Faces[f][k];
      const vtkIdType b = mesh.Faces[f][(k + 1) % 3];
      points.insert(a);
      facesOf[{ std::min(a, b), std::max(a, b) }].push_back(f);
    }
  }
  // Faces that share an edge are joined to trees; the root of a tree stands for its faces.
  std::vector<std::size_t> parent(mesh.Faces.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::size_t f)
  {
    while (parent[f] != f)
    {
      f = parent[f] = parent[parent[f]];
    }
    return f;
  };
  std::size_t parts = parent.size();
  bool hasBoundary = false;
  for (const auto& [edge, faces] : facesOf)
  {
    hasBoundary = hasBoundary || faces.size() == 1;
    for (const std::size_t f : faces)
    {
      parts -= root(f) != root(faces.front());
      parent[root(f)] = root(faces.front());
    }
  }
  return parts == 1 && hasBoundary && directed.size() == 3 * mesh.Faces.size() &&
         points.size() + mesh.Faces.size() == facesOf.size() + 1;
}

} // namespace fuzz
