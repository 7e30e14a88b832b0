// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HalfedgeSurface.h"

#include "Base/Errors.h"

#include <algorithm>
#include <map>
#include <string>

namespace flattening
{
namespace
{

std::string nameOfEdge(int a, int b)
{
  return "edge (" + std::to_string(a) + ", " + std::to_string(b) + ")";
}

} // namespace

HalfedgeSurface::HalfedgeSurface(const TriangleMesh& mesh)
  : Points(mesh.vertexCount())
  , Origins(3 * static_cast<std::size_t>(mesh.faceCount()))
  , Twins(this->Origins.size(), -1)
  , Outgoing(mesh.vertexCount(), -1)
{
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    this->Points[v] = mesh.Vertices.row(v).transpose();
  }
  std::copy(mesh.Faces.data(), mesh.Faces.data() + mesh.Faces.size(), this->Origins.begin());

  // Half-edges in buckets of the smaller end of their edge.
  std::vector<int> bucket(mesh.vertexCount() + 1, 0);
  const auto smallerEnd = [this](int h) { return std::min(this->origin(h), this->tip(h)); };
  for (int h = 0; h < this->halfedgeCount(); ++h)
  {
    ++bucket[smallerEnd(h) + 1];
  }
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    bucket[v + 1] += bucket[v];
  }
  std::vector<int> sorted(this->Origins.size());
  std::vector<int> free(bucket.begin(), bucket.end() - 1);
  for (int h = 0; h < this->halfedgeCount(); ++h)
  {
    sorted[free[smallerEnd(h)]++] = h;
  }
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    for (int i = bucket[v]; i < bucket[v + 1]; ++i)
    {
      const int h = sorted[i];
      for (int j = i + 1; j < bucket[v + 1]; ++j)
      {
        const int g = sorted[j];
        const bool opposite = this->origin(g) == this->tip(h) && this->tip(g) == this->origin(h);
        const bool same = this->origin(g) == this->origin(h) && this->tip(g) == this->tip(h);
        if (same || (opposite && (this->Twins[h] >= 0 || this->Twins[g] >= 0)))
        {
          throw TopologyError(nameOfEdge(this->origin(h), this->tip(h)) +
                              " is non-manifold or its faces are oriented against each other: run "
                              "Surface To Disk first");
        }
        if (opposite)
        {
          this->join(h, g);
        }
      }
    }
  }

  std::vector<int> degree(mesh.vertexCount(), 0);
  for (int h = 0; h < this->halfedgeCount(); ++h)
  {
    ++degree[this->origin(h)];
    if (this->Outgoing[this->origin(h)] < 0 || this->Twins[h] < 0)
    {
      this->Outgoing[this->origin(h)] = h;
    }
  }
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    int h = this->Outgoing[v];
    do
    {
      --degree[v];
      h = h < 0 ? -1 : this->rotated(h);
    } while (h >= 0 && h != this->Outgoing[v] && degree[v] > 0);
    if (degree[v] > 0)
    {
      throw TopologyError(
        "vertex " + std::to_string(v) +
        " is non-manifold (parts of the surface meet only there): run Surface To Disk first");
    }
  }
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
  const int first = this->Outgoing[a];
  for (int h = first; h >= 0;)
  {
    if (this->tip(h) == b)
    {
      return h;
    }
    if (this->origin(previous(h)) == b && this->Twins[previous(h)] < 0)
    {
      return previous(h);
    }
    h = this->rotated(h);
    if (h == first)
    {
      break;
    }
  }
  return -1;
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
    for (int w = v; !visited[w]; w = this->tip(this->Outgoing[w]))
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
  std::vector<int> twins(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    twins[i] = this->twin(loop[i]);
  }
  std::vector<int> corners; // of the new vertices, those of each together
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < n; ++i)
  {
    first.push_back(corners.size());
    const int last = loop[(i + n - 1) % n]; // ends here
    int h = loop[i];
    for (; previous(h) != last; h = this->rotated(h))
    {
      corners.push_back(h);
    }
    corners.push_back(h);
  }
  first.push_back(corners.size());
  for (std::size_t i = 0; i < n; ++i)
  {
    const int old = this->origin(loop[i]);
    const Eigen::Vector3d place = this->Points[old];
    const int copy = this->addVertex(place);
    for (std::size_t c = first[i]; c < first[i + 1]; ++c)
    {
      this->Origins[corners[c]] = copy;
    }
    this->Outgoing[copy] = loop[i];
    this->Outgoing[old] = twins[(i + n - 1) % n];
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    this->Twins[loop[i]] = this->Twins[twins[i]] = -1;
  }
  return firstCopy;
}

int HalfedgeSurface::addVertex(const Eigen::Vector3d& point)
{
  this->Points.push_back(point);
  this->Outgoing.push_back(-1);
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
      sides[{ face[k], face[(k + 1) % 3] }] = this->halfedgeCount();
      // The boundary half-edge from the other end: the one that starts there.
      const int boundary = this->Outgoing[face[(k + 1) % 3]];
      if (boundary >= 0 && boundary < begin && this->tip(boundary) == face[k])
      {
        sides[{ face[(k + 1) % 3], face[k] }] = boundary;
      }
      this->Origins.push_back(face[k]);
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
  for (int h = begin; h < this->halfedgeCount(); ++h)
  {
    int& outgoing = this->Outgoing[this->origin(h)];
    if (outgoing < 0 || this->Twins[h] < 0)
    {
      outgoing = h;
    }
  }
}

int HalfedgeSurface::splitEdge(int h)
{
  const int g = this->twin(h);
  const int a = this->origin(h);
  const int c = this->origin(previous(h));
  const int d = this->origin(previous(g));
  const Eigen::Vector3d middle = 0.5 * (this->point(a) + this->point(this->tip(h)));
  const int m = this->addVertex(middle);
  const int beforeH = previous(h); // c -> a, now c -> m
  const int afterG = next(g);      // a -> d, now m -> d
  const int n = this->halfedgeCount();
  this->Origins.insert(this->Origins.end(), { a, m, c, m, a, d });
  this->Twins.insert(this->Twins.end(), 6, -1);
  this->join(n + 2, this->twin(beforeH));
  this->join(n + 4, this->twin(afterG));
  this->Origins[h] = m;
  this->Origins[afterG] = m;
  this->join(n, n + 3);
  this->join(n + 1, beforeH);
  this->join(n + 5, afterG);
  this->Outgoing[m] = h;
  // Whatever left a from the old faces leaves it from the new ones now.
  int& fromA = this->Outgoing[a];
  fromA = fromA == h ? n : fromA == afterG ? n + 4 : fromA;
  int& fromC = this->Outgoing[c];
  fromC = fromC == beforeH ? n + 2 : fromC; // c -> a, which may be on the boundary
  return m;
}

int HalfedgeSurface::eulerCharacteristic() const
{
  const auto used = static_cast<int>(
    std::count_if(this->Outgoing.begin(), this->Outgoing.end(), [](int h) { return h >= 0; }));
  const auto boundary = static_cast<int>(std::count(this->Twins.begin(), this->Twins.end(), -1));
  return used - (this->halfedgeCount() + boundary) / 2 + this->faceCount();
}

TriangleMesh HalfedgeSurface::mesh() const
{
  TriangleMesh mesh;
  mesh.Vertices.resize(this->vertexCount(), 3);
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    mesh.Vertices.row(v) = this->Points[v].transpose();
  }
  mesh.Faces = Eigen::Map<const FaceMatrix>(this->Origins.data(), this->faceCount(), 3);
  return mesh;
}

} // namespace flattening
