// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HomologyLabels.h"

#include "Base/Errors.h"

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

namespace flattening
{
namespace
{

// The i-th number of a sequence of random numbers (Steele, Lea, Flood 2014, "Fast splittable
// pseudorandom number generators").
std::uint64_t splitMix(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Sets a value that the half-edges of an edge share.
template <typename Values, typename Value>
void setEdge(const HalfedgeSurface& surface, Values& values, int h, Value value)
{
  values[h] = value;
  if (surface.twin(h) >= 0)
  {
    values[surface.twin(h)] = value;
  }
}

// A breadth-first tree of the faces. Boundary loops count as faces; their numbers follow those of the
// faces.
class FaceTree
{
public:
  explicit FaceTree(const HalfedgeSurface& surface)
    : Surface(surface)
  {
    for (const std::vector<int>& vertices : surface.boundaryLoops())
    {
      const int node = this->nodeCount();
      this->Loops.emplace_back();
      for (const int v : vertices)
      {
        this->Loops.back().push_back(surface.outgoing(v));
        this->LoopAt[surface.outgoing(v)] = node;
      }
    }
    this->grow();
  }

  bool reachesAll() const { return static_cast<int>(this->Order.size()) == this->nodeCount(); }
  const std::vector<int>& order() const { return this->Order; }
  /// The half-edge between a node and its parent, seen from the parent unless that is a boundary loop;
  /// negative at the root.
  int parentEdge(int node) const { return this->Parent[node]; }

  bool isTreeEdge(int h) const
  {
    const int face = HalfedgeSurface::face(h);
    const int fromOutside = this->Surface.twin(h) >= 0 ? this->Surface.twin(h) : h;
    return this->Parent[this->across(face, h)] == h || this->Parent[face] == fromOutside;
  }

  /// Flags, per node, those beside the half-edges and the nodes from there to the root.
  std::vector<char> pathsToRoot(const std::vector<int>& halfedges) const
  {
    std::vector<char> onPath(this->nodeCount(), 0);
    for (const int h : halfedges)
    {
      for (int node : { HalfedgeSurface::face(h), this->across(HalfedgeSurface::face(h), h) })
      {
        for (; !onPath[node]; node = this->parent(node))
        {
          onPath[node] = 1;
        }
      }
    }
    return onPath;
  }

  template <typename Visit>
  void visitSides(int node, const Visit& visit) const
  {
    if (!this->isLoop(node))
    {
      visit(3 * node);
      visit(3 * node + 1);
      visit(3 * node + 2);
      return;
    }
    for (const int h : this->Loops[node - this->Surface.faceCount()])
    {
      visit(h);
    }
  }

private:
  static constexpr int NoParent = -1;
  static constexpr int Unreached = -2;

  int nodeCount() const { return this->Surface.faceCount() + static_cast<int>(this->Loops.size()); }
  bool isLoop(int node) const { return node >= this->Surface.faceCount(); }

  int across(int node, int h) const
  {
    if (this->isLoop(node))
    {
      return HalfedgeSurface::face(h);
    }
    const int twin = this->Surface.twin(h);
    return twin >= 0 ? HalfedgeSurface::face(twin) : this->LoopAt.at(h);
  }

  // The root is its own parent.
  int parent(int node) const
  {
    const int h = this->Parent[node];
    return h == NoParent                      ? node
           : HalfedgeSurface::face(h) == node ? this->LoopAt.at(h)
                                              : HalfedgeSurface::face(h);
  }

  void grow()
  {
    this->Parent.assign(this->nodeCount(), Unreached);
    this->Order.reserve(this->nodeCount());
    this->Parent[0] = NoParent;
    this->Order.push_back(0);
    for (std::size_t i = 0; i < this->Order.size(); ++i)
    {
      const int node = this->Order[i];
      this->visitSides(node,
        [&](int h)
        {
          const int neighbour = this->across(node, h);
          if (this->Parent[neighbour] == Unreached)
          {
            this->Parent[neighbour] = h;
            this->Order.push_back(neighbour);
          }
        });
    }
  }

  const HalfedgeSurface& Surface;
  std::vector<std::vector<int>> Loops; // half-edges of each boundary loop
  std::unordered_map<int, int> LoopAt; // the boundary loop's node, by half-edge on the boundary
  std::vector<int> Parent;             // per node, see parentEdge
  std::vector<int> Order;              // nodes in breadth-first order
};

// The cut graph: the edges that the face tree does not cross, one half-edge of each.
std::vector<int> cutGraphOf(const HalfedgeSurface& surface, const FaceTree& faces)
{
  std::vector<int> edges;
  for (int h = 0; h < surface.halfedgeCount(); ++h)
  {
    if (h > surface.twin(h) && !faces.isTreeEdge(h))
    {
      edges.push_back(h);
    }
  }
  return edges;
}

// Flags the vertices of the reduced cut graph: those that remain when its dead ends are taken away, but
// for the one that ends at the root.
std::vector<char> withoutDeadEnds(const HalfedgeSurface& surface,
  const std::vector<int>& edges,
  int root)
{
  // A vertex with a single edge knows which one it is by the exclusive or of its edges.
  std::vector<int> degree(surface.vertexCount(), 0);
  std::vector<int> edgesAt(surface.vertexCount(), 0);
  const auto toggle = [&](int v, int h, int change)
  {
    degree[v] += change;
    edgesAt[v] ^= h;
  };
  for (const int h : edges)
  {
    toggle(surface.source(h), h, 1);
    toggle(surface.target(h), h, 1);
  }
  for (int end = 0; end < surface.vertexCount(); ++end)
  {
    for (int v = end; degree[v] == 1 && v != root;)
    {
      const int h = edgesAt[v];
      toggle(surface.source(h), h, -1);
      toggle(surface.target(h), h, -1);
      v = surface.source(h) == v ? surface.target(h) : surface.source(h);
    }
  }
  std::vector<char> remains(degree.size());
  std::transform(
    degree.begin(), degree.end(), remains.begin(), [](int edgesLeft) { return edgesLeft > 0; });
  return remains;
}

// Marks the half-edges of a breadth-first tree of the reduced cut graph.
std::vector<char> vertexTree(const HalfedgeSurface& surface,
  const FaceTree& faces,
  std::vector<char> unreached,
  int root)
{
  std::vector<char> inTree(surface.halfedgeCount(), 0);
  std::vector<int> queue{ root };
  unreached[root] = 0;
  const auto step = [&](int to, int h)
  {
    if (unreached[to] && !faces.isTreeEdge(h))
    {
      unreached[to] = 0;
      setEdge(surface, inTree, h, 1);
      queue.push_back(to);
    }
  };
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    surface.visitOutgoing(queue[i],
      [&](int h)
      {
        step(surface.target(h), h);
        if (surface.rotated(h) < 0)
        {
          const int incoming = HalfedgeSurface::previous(h);
          step(surface.source(incoming), incoming);
        }
      });
  }
  return inTree;
}

// One half-edge of each edge that belongs to neither tree. Dead ends of the cut graph belong to every
// tree of the vertices, so that only the reduced cut graph is searched.
std::vector<int> generatorsOf(const HalfedgeSurface& surface, const FaceTree& faces)
{
  const int root = surface.source(0);
  std::vector<int> edges = cutGraphOf(surface, faces);
  const std::vector<char> remain = withoutDeadEnds(surface, edges, root);
  const std::vector<char> inTree = vertexTree(surface, faces, remain, root);
  const auto isNoGenerator = [&](int h)
  { return inTree[h] || !remain[surface.source(h)] || !remain[surface.target(h)]; };
  edges.erase(std::remove_if(edges.begin(), edges.end(), isNoGenerator), edges.end());
  return edges;
}

} // namespace

HomologyLabels::HomologyLabels(const HalfedgeSurface& surface)
  : LabelOf(surface.halfedgeCount(), 0)
{
  const FaceTree faces(surface);
  if (!faces.reachesAll())
  {
    throw TopologyError("the surface is not connected, at face " + std::to_string(surface.faceCount()) +
                        ": choose one component with Connectivity first");
  }
  const std::vector<int> generators = generatorsOf(surface, faces);
  this->Genus = static_cast<int>(generators.size()) / 2;
  this->Labels.push_back({ Class(generators.size()), 0 });
  for (std::size_t i = 0; i < generators.size(); ++i)
  {
    this->Labels.push_back({ Class(generators.size()), splitMix(i) });
    this->Labels.back().Bits.set(i);
    setEdge(surface, this->LabelOf, generators[i], static_cast<int>(i) + 1);
  }
  // From the leaves of the face tree to its root, only one side of each face has no label yet. Off the
  // paths from the generators to the root, it is zero.
  const std::vector<char> onPath = faces.pathsToRoot(generators);
  for (std::size_t i = faces.order().size(); i-- > 1;)
  {
    const int node = faces.order()[i];
    if (!onPath[node])
    {
      continue;
    }
    const int parent = faces.parentEdge(node);
    int label = 0;
    faces.visitSides(node,
      [&](int h)
      {
        if (h != parent && h != surface.twin(parent))
        {
          label = this->sum(label, this->LabelOf[h]);
        }
      });
    setEdge(surface, this->LabelOf, parent, label);
  }
}

int HomologyLabels::sum(int a, int b)
{
  if (a == 0 || b == 0)
  {
    return a + b;
  }
  if (this->Labels[a].Hash == this->Labels[b].Hash)
  {
    return 0;
  }
  Label label = this->Labels[a];
  label.Bits ^= this->Labels[b].Bits;
  label.Hash ^= this->Labels[b].Hash;
  this->Labels.push_back(std::move(label));
  return static_cast<int>(this->Labels.size()) - 1;
}

HomologyLabels::Class HomologyLabels::classOf(const std::vector<int>& loop) const
{
  Class result(this->Labels[0].Bits.size());
  for (const int h : loop)
  {
    result ^= this->Labels[this->LabelOf[h]].Bits;
  }
  return result;
}

void HomologyLabels::divideBy(const std::vector<int>& loop)
{
  const Class divisor = this->classOf(loop);
  std::uint64_t hash = 0;
  for (const int h : loop)
  {
    hash ^= this->hash(h);
  }
  const std::size_t pivot = divisor.find_first();
  for (Label& label : this->Labels)
  {
    if (label.Bits.test(pivot))
    {
      label.Bits ^= divisor;
      label.Hash ^= hash;
    }
  }
  --this->Genus;
}

void HomologyLabels::followCut(const HalfedgeSurface& surface,
  const std::vector<int>& loop,
  const std::vector<int>& vertices,
  int firstCopy)
{
  this->divideBy(loop);
  // The sum of the labels along the loop is zero now, so they are the differences of a potential. The
  // potential is zero at the other vertices of the caps, and its differences label the edges there.
  std::map<int, int> potential;
  int label = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    potential[vertices[i]] = potential[firstCopy + static_cast<int>(i)] = label;
    label = this->sum(label, this->LabelOf[loop[i]]);
  }
  const auto potentialAt = [&potential](int v)
  {
    const auto at = potential.find(v);
    return at == potential.end() ? 0 : at->second;
  };
  const int begin = static_cast<int>(this->LabelOf.size());
  this->LabelOf.resize(surface.halfedgeCount(), 0);
  for (int h = begin; h < surface.halfedgeCount(); ++h)
  {
    const int twin = surface.twin(h);
    this->LabelOf[h] = twin < h
                         ? this->LabelOf[twin]
                         : this->sum(potentialAt(surface.source(h)), potentialAt(surface.target(h)));
  }
}

void HomologyLabels::followSplit(const HalfedgeSurface& surface, int h)
{
  // The half at the source of h gets zero, the other half keeps the label. The labels of the other new
  // edges follow because the labels around a face sum to zero.
  const int beforeH = this->LabelOf[HalfedgeSurface::previous(h)];
  const int afterG = this->LabelOf[HalfedgeSurface::next(surface.twin(h))];
  this->LabelOf.insert(this->LabelOf.end(), { 0, beforeH, beforeH, 0, afterG, afterG });
}

} // namespace flattening
