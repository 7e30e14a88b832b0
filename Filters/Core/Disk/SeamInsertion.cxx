// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/SeamInsertion.h"

#include "Disk/PathInsertion.h"
#include "Remeshing/EdgeFlips.h"

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

using Vertex = SeamInsertion::Vertex;
using Halfedge = EditableSurface::Halfedge;

std::pair<Vertex, Vertex> sortedEnds(Vertex a, Vertex b)
{
  return { std::min(a, b), std::max(a, b) };
}

} // namespace

SeamInsertion::SeamInsertion(const TriangleMesh& mesh, const MeshTopology& topology)
  : Surface(mesh)
  , LabelOf(mesh.vertexCount(), -1)
{
  for (const std::vector<int>& loop : topology.BoundaryLoops)
  {
    const int part = static_cast<int>(this->PartOfLabel.size());
    this->PartOfLabel.push_back(part);
    ++this->Parts;
    for (const int v : loop)
    {
      this->LabelOf[v] = part;
    }
  }
}

bool SeamInsertion::isOnBoundary(const PathPoint& point) const
{
  return point.isVertex() ? this->mesh().is_border(point.Vertex)
                          : this->mesh().is_border(this->mesh().edge(point.Edge));
}

bool SeamInsertion::isOnSeam(const PathPoint& point) const
{
  if (point.isVertex())
  {
    return this->isTaken(point.Vertex) && !this->mesh().is_border(point.Vertex);
  }
  return this->Edges.count(
           sortedEnds(this->mesh().source(point.Edge), this->mesh().target(point.Edge))) > 0;
}

bool SeamInsertion::areJoined(Vertex a, Vertex b) const
{
  return this->isTaken(a) && this->partOf(a) == this->partOf(b);
}

void SeamInsertion::take(Vertex v)
{
  if (!this->isTaken(v))
  {
    const int part = static_cast<int>(this->PartOfLabel.size());
    this->PartOfLabel.push_back(part);
    ++this->Parts;
    this->join(v, part);
  }
}

std::vector<Vertex> SeamInsertion::insert(const std::vector<PathPoint>& path)
{
  std::vector<Vertex> seam = insertPath(this->Surface, path);
  this->take(seam.front());
  const int part = this->partOf(seam.front());
  for (std::size_t i = 0; i + 1 < seam.size(); ++i)
  {
    this->Edges.insert(sortedEnds(seam[i], seam[i + 1]));
    this->join(seam[i + 1], part);
  }
  return seam;
}

SeamOpenedSurface SeamInsertion::cut()
{
  std::vector<Vertex> vertices;
  for (const auto& [from, to] : this->Edges)
  {
    vertices.insert(vertices.end(), { from, to });
  }
  flipInsideOriginalFaces(this->Surface, vertices);
  this->splitChords();

  SeamOpenedSurface opened;
  std::vector<MeshEdge> edges;
  for (const auto& [from, to] : this->Edges)
  {
    edges.push_back({ static_cast<int>(from.idx()), static_cast<int>(to.idx()) });
    opened.Length += std::sqrt(this->Surface.squaredLength(this->mesh().halfedge(from, to)));
  }
  DerivedMesh whole = this->Surface.derived();
  opened.Cut = cutAlongEdges(whole.Mesh, edges);
  follow(whole, std::move(opened.Cut.Surface));
  opened.Cut.Surface = std::move(whole);
  return opened;
}

// A face with all of its corners on the boundary has no area where the map presses the boundary onto so
// short an arc that rounding makes it straight.
void SeamInsertion::splitChords()
{
  const auto isOnEdges = [this](Vertex v) { return this->isTaken(v) && !this->mesh().is_border(v); };
  std::vector<Halfedge> chords;
  for (const auto edge : this->mesh().edges())
  {
    const Halfedge h = this->mesh().halfedge(edge);
    const Vertex from = this->mesh().source(h);
    const Vertex to = this->mesh().target(h);
    if (this->isTaken(from) && this->isTaken(to) && (isOnEdges(from) || isOnEdges(to)) &&
        this->Edges.count(sortedEnds(from, to)) == 0)
    {
      chords.push_back(h);
    }
  }
  for (const Halfedge h : chords)
  {
    this->Surface.splitEdge(h, 0.5);
  }
}

int SeamInsertion::partOf(Vertex v) const
{
  const auto label = [this](Vertex w) { return w.idx() < this->LabelOf.size() ? this->LabelOf[w] : -1; };
  if (label(v) < 0 && this->Surface.isNew(v))
  {
    // A new vertex of the boundary: the vertices of the original are labelled, so that the loop has one.
    auto border = CGAL::is_border(v, this->mesh());
    while (border && label(v) < 0)
    {
      border = this->mesh().next(*border);
      v = this->mesh().target(*border);
    }
  }
  return label(v) < 0 ? -1 : this->PartOfLabel[label(v)];
}

void SeamInsertion::join(Vertex v, int part)
{
  const int before = this->partOf(v);
  if (before < 0)
  {
    this->LabelOf.resize(this->mesh().num_vertices(), -1);
    this->LabelOf[v] = part;
  }
  else if (before != part)
  {
    std::replace(this->PartOfLabel.begin(), this->PartOfLabel.end(), before, part);
    --this->Parts;
  }
}

} // namespace flattening
