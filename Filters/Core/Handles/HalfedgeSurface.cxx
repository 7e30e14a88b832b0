// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HalfedgeSurface.h"

#include "Mesh/FaceSides.h"

#include <boost/range/irange.hpp>

#include <algorithm>
#include <map>
#include <numeric>

namespace flattening
{

HalfedgeSurface::HalfedgeSurface(const TriangleMesh& mesh)
  : Points(mesh.vertexCount())
  , Sources(mesh.Faces.data(), mesh.Faces.data() + mesh.Faces.size())
  , Twins(oppositeHalfedges(mesh.Faces))
  , Outgoing(mesh.vertexCount(), -1)
  , OriginalVertices(mesh.vertexCount())
  , FaceOrigins(mesh.faceCount())
{
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    this->Points[v] = mesh.Vertices.row(v).transpose();
  }
  std::iota(this->FaceOrigins.begin(), this->FaceOrigins.end(), 0);
  this->findOutgoing(0);
}

// Half-edges of the boundary are preferred.
void HalfedgeSurface::findOutgoing(int firstHalfedge)
{
  for (int h = firstHalfedge; h < this->halfedgeCount(); ++h)
  {
    int& outgoing = this->Outgoing[this->source(h)];
    if (outgoing < 0 || this->Twins[h] < 0)
    {
      outgoing = h;
    }
  }
}

Origin HalfedgeSurface::origin(int v) const
{
  return v < this->OriginalVertices ? Origin{ { v, 1.0 } }
                                    : this->NewOrigins[v - this->OriginalVertices];
}

void HalfedgeSurface::join(int h, int g)
{
  this->Twins[h] = g;
  if (g >= 0)
  {
    this->Twins[g] = h;
  }
}

int HalfedgeSurface::edgeBetween(int a, int b) const
{
  int found = -1;
  this->visitOutgoing(a,
    [&](int h)
    {
      const int incoming = previous(h);
      const bool isReverse = this->source(incoming) == b && this->Twins[incoming] < 0;
      found = this->target(h) == b ? h : isReverse ? incoming : found;
    });
  return found;
}

std::vector<std::vector<int>> HalfedgeSurface::boundaryLoops() const
{
  std::vector<std::vector<int>> loops;
  std::vector<char> visited(this->Points.size(), 0);
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    if (visited[v] || this->Outgoing[v] < 0 || !this->onBoundary(v))
    {
      continue;
    }
    std::vector<int> loop;
    for (int w = v; !visited[w]; w = this->target(this->Outgoing[w]))
    {
      visited[w] = 1;
      loop.push_back(w);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

int HalfedgeSurface::cut(const std::vector<int>& loop)
{
  const int firstCopy = this->vertexCount();
  const std::size_t n = loop.size();
  std::vector<std::vector<int>> onLeft(n); // half-edges that leave each vertex of the loop
  for (std::size_t i = 0; i < n; ++i)
  {
    const int last = loop[(i + n - 1) % n];
    int h = loop[i];
    for (; previous(h) != last; h = this->rotated(h))
    {
      onLeft[i].push_back(h);
    }
    onLeft[i].push_back(h);
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const int old = this->source(loop[i]);
    const int copy = this->addVertex(Eigen::Vector3d(this->point(old)), this->origin(old));
    for (const int h : onLeft[i])
    {
      this->Sources[h] = copy;
    }
    this->Outgoing[copy] = loop[i];
    this->Outgoing[old] = this->twin(loop[(i + n - 1) % n]);
  }
  for (const int h : loop)
  {
    this->Twins[this->twin(h)] = -1;
    this->Twins[h] = -1;
  }
  return firstCopy;
}

int HalfedgeSurface::addVertex(const Eigen::Vector3d& point, Origin origin)
{
  this->Points.push_back(point);
  this->Outgoing.push_back(-1);
  this->NewOrigins.push_back(std::move(origin));
  return this->vertexCount() - 1;
}

void HalfedgeSurface::addFaces(const std::vector<std::array<int, 3>>& faces)
{
  const int begin = this->halfedgeCount();
  std::map<std::pair<int, int>, int> sides;
  for (const auto& face : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = face[k];
      const int to = face[(k + 1) % 3];
      sides[{ from, to }] = this->halfedgeCount();
      const int boundary = this->Outgoing[to];
      if (boundary >= 0 && boundary < begin && this->target(boundary) == from)
      {
        sides[{ to, from }] = boundary;
      }
      this->Sources.push_back(from);
      this->Twins.push_back(-1);
    }
  }
  for (const auto& [ends, h] : sides)
  {
    const auto opposite = sides.find({ ends.second, ends.first });
    if (opposite != sides.end())
    {
      this->join(h, opposite->second);
    }
  }
  this->findOutgoing(begin);
  this->FaceOrigins.resize(this->faceCount(), -1);
}

int HalfedgeSurface::splitEdge(int h)
{
  const int g = this->twin(h);
  const int a = this->source(h);
  const int b = this->target(h);
  const int c = this->source(previous(h));
  const int d = this->source(previous(g));
  const Eigen::Vector3d middle = 0.5 * (this->point(a) + this->point(b));
  const int m =
    this->addVertex(middle, combined({ { this->origin(a), 0.5 }, { this->origin(b), 0.5 } }));
  this->FaceOrigins.push_back(this->FaceOrigins[face(h)]);
  this->FaceOrigins.push_back(this->FaceOrigins[face(g)]);

  const int beforeH = previous(h); // from c to a, now from c to m
  const int afterG = next(g);      // from a to d, now from m to d
  const int n = this->halfedgeCount();
  this->Sources.insert(this->Sources.end(), { a, m, c, m, a, d });
  this->Twins.insert(this->Twins.end(), 6, -1);
  this->join(n + 2, this->twin(beforeH));
  this->join(n + 4, this->twin(afterG));
  this->Sources[h] = m;
  this->Sources[afterG] = m;
  this->join(n, n + 3);
  this->join(n + 1, beforeH);
  this->join(n + 5, afterG);
  this->Outgoing[m] = h;
  // The new faces have the half-edges that started at a, and perhaps the one from c to the boundary.
  int& fromA = this->Outgoing[a];
  fromA = fromA == h ? n : fromA == afterG ? n + 4 : fromA;
  int& fromC = this->Outgoing[c];
  fromC = fromC == beforeH ? n + 2 : fromC;
  return m;
}

TriangleMesh HalfedgeSurface::mesh() const
{
  TriangleMesh mesh;
  mesh.Vertices.resize(this->vertexCount(), 3);
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    mesh.Vertices.row(v) = this->Points[v].transpose();
  }
  mesh.Faces = Eigen::Map<const FaceMatrix>(this->Sources.data(), this->faceCount(), 3);
  return mesh;
}

DerivedMesh HalfedgeSurface::derived() const
{
  DerivedMesh result;
  result.Mesh = this->mesh();
  result.Faces = this->FaceOrigins;
  result.Vertices = originMatrix(boost::irange(this->vertexCount()),
    this->OriginalVertices,
    [this](int v) { return this->origin(v); });
  return result;
}

} // namespace flattening
