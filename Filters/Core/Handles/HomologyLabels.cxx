// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HomologyLabels.h"

#include "Base/Errors.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

// Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators".
std::uint64_t splitMix(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// A breadth-first tree of the faces, boundary loops counting as faces with numbers above theirs.
class FaceTree
{
public:
  explicit FaceTree(const HalfedgeSurface& surface)
    : Surface(surface)
    , LoopOf(surface.halfedgeCount(), -1)
    , Parent(0)
  {
    for (const std::vector<int>& vertices : surface.boundaryLoops())
    {
      this->Loops.emplace_back();
      for (const int v : vertices)
      {
        this->Loops.back().push_back(surface.outgoing(v));
        this->LoopOf[surface.outgoing(v)] = static_cast<int>(this->Loops.size()) - 1;
      }
    }
    this->grow();
  }

  int nodeCount() const { return this->Surface.faceCount() + static_cast<int>(this->Loops.size()); }
  const std::vector<int>& order() const { return this->Order; }
  /// The half-edge of a face's side to its parent, seen from the parent's or, if that is missing on the
  /// boundary, from the face's side; -1 at the root.
  int parentEdge(int node) const { return this->Parent[node]; }
  bool isTreeEdge(int h) const
  {
    const int twin = this->Surface.twin(h);
    return this->InTree[h] || (twin >= 0 && this->InTree[twin]);
  }

  template <typename Visit>
  void visitSides(int node, const Visit& visit) const
  {
    if (node < this->Surface.faceCount())
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
  int across(int node, int h) const
  {
    if (node >= this->Surface.faceCount())
    {
      return HalfedgeSurface::face(h);
    }
    const int twin = this->Surface.twin(h);
    return twin >= 0 ? HalfedgeSurface::face(twin) : this->Surface.faceCount() + this->LoopOf[h];
  }

  void grow()
  {
    std::vector<char> reached(this->nodeCount(), 0);
    this->Parent.assign(this->nodeCount(), -1);
    this->InTree.assign(this->Surface.halfedgeCount(), 0);
    this->Order.reserve(this->nodeCount());
    this->Order.push_back(0);
    reached[0] = 1;
    for (std::size_t i = 0; i < this->Order.size(); ++i)
    {
      const int node = this->Order[i];
      this->visitSides(node,
        [&](int h)
        {
          const int neighbour = this->across(node, h);
          if (!reached[neighbour])
          {
            reached[neighbour] = 1;
            this->Parent[neighbour] = h;
            this->InTree[h] = 1;
            this->Order.push_back(neighbour);
          }
        });
    }
  }

  const HalfedgeSurface& Surface;
  std::vector<std::vector<int>> Loops;
  std::vector<int> LoopOf;
  std::vector<int> Parent;
  std::vector<int> Order;
  std::vector<char> InTree;
};

// Marks the half-edges of a breadth-first tree of the vertices that crosses no edge of the face tree.
std::vector<char> vertexTree(const HalfedgeSurface& surface, const FaceTree& faces)
{
  std::vector<char> inTree(surface.halfedgeCount(), 0);
  std::vector<char> reached(surface.vertexCount(), 0);
  std::vector<int> queue{ surface.origin(0) };
  reached[queue[0]] = 1;
  const auto step = [&](int to, int h)
  {
    if (!reached[to] && !faces.isTreeEdge(h))
    {
      reached[to] = 1;
      inTree[h] = 1;
      if (surface.twin(h) >= 0)
      {
        inTree[surface.twin(h)] = 1;
      }
      queue.push_back(to);
    }
  };
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const int first = surface.outgoing(queue[i]);
    for (int h = first; h >= 0;)
    {
      step(surface.tip(h), h);
      const int incoming = HalfedgeSurface::previous(h);
      h = surface.rotated(h);
      if (h < 0)
      {
        step(surface.origin(incoming), incoming);
      }
      if (h == first)
      {
        break;
      }
    }
  }
  return inTree;
}

} // namespace

HomologyLabels::HomologyLabels(const HalfedgeSurface& surface)
  : LabelOf(surface.halfedgeCount(), 0)
{
  const FaceTree faces(surface);
  if (static_cast<int>(faces.order().size()) != faces.nodeCount())
  {
    throw TopologyError("the surface is not connected, at face " + std::to_string(surface.faceCount()) +
                        ": choose one component with Connectivity first");
  }
  std::vector<int> generators;
  {
    const std::vector<char> inVertexTree = vertexTree(surface, faces);
    for (int h = 0; h < surface.halfedgeCount(); ++h)
    {
      if (h > surface.twin(h) && !inVertexTree[h] && !faces.isTreeEdge(h))
      {
        generators.push_back(h);
      }
    }
  }
  this->Genus = static_cast<int>(generators.size()) / 2;
  const std::size_t words = (generators.size() + 63) / 64;
  this->Labels.push_back({ Class(words, 0), 0 });
  const auto setLabel = [&](int h, int label)
  {
    this->LabelOf[h] = label;
    if (surface.twin(h) >= 0)
    {
      this->LabelOf[surface.twin(h)] = label;
    }
  };
  for (std::size_t i = 0; i < generators.size(); ++i)
  {
    this->Labels.push_back({ Class(words, 0), splitMix(i) });
    this->Labels.back().Bits[i / 64] |= std::uint64_t(1) << (i % 64);
    setLabel(generators[i], static_cast<int>(i) + 1);
  }
  for (std::size_t i = faces.order().size(); i-- > 1;)
  {
    const int node = faces.order()[i];
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
    setLabel(parent, label);
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
  for (std::size_t w = 0; w < label.Bits.size(); ++w)
  {
    label.Bits[w] ^= this->Labels[b].Bits[w];
  }
  label.Hash ^= this->Labels[b].Hash;
  this->Labels.push_back(std::move(label));
  return static_cast<int>(this->Labels.size()) - 1;
}

HomologyLabels::Class HomologyLabels::classOf(const std::vector<int>& loop) const
{
  Class result(this->Labels[0].Bits.size(), 0);
  for (const int h : loop)
  {
    const Class& bits = this->Labels[this->LabelOf[h]].Bits;
    for (std::size_t w = 0; w < result.size(); ++w)
    {
      result[w] ^= bits[w];
    }
  }
  return result;
}

bool HomologyLabels::isZero(const Class& homologyClass)
{
  return std::all_of(homologyClass.begin(), homologyClass.end(), [](std::uint64_t w) { return w == 0; });
}

void HomologyLabels::divideBy(const std::vector<int>& loop)
{
  const Class divisor = this->classOf(loop);
  std::uint64_t hash = 0;
  for (const int h : loop)
  {
    hash ^= this->hash(h);
  }
  const auto word = std::find_if(divisor.begin(), divisor.end(), [](std::uint64_t w) { return w != 0; });
  const std::uint64_t pivot = *word & (~*word + 1); // its lowest bit
  for (Label& label : this->Labels)
  {
    if (label.Bits[word - divisor.begin()] & pivot)
    {
      for (std::size_t w = 0; w < divisor.size(); ++w)
      {
        label.Bits[w] ^= divisor[w];
      }
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
  // Along the loop the labels are differences of a potential, as their sum is zero now. Extended by zero
  // to the new vertices, it gives labels to the edges of the caps.
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
    this->LabelOf[h] = twin < h ? this->LabelOf[twin]
                                : this->sum(potentialAt(surface.origin(h)), potentialAt(surface.tip(h)));
  }
}

void HomologyLabels::followSplit(const HalfedgeSurface& surface, int h)
{
  // The first half gets zero, the second keeps the label; the rest follows from the faces.
  const int beforeH = this->LabelOf[HalfedgeSurface::previous(h)];
  const int afterG = this->LabelOf[HalfedgeSurface::next(surface.twin(h))];
  this->LabelOf.insert(this->LabelOf.end(), { 0, beforeH, beforeH, 0, afterG, afterG });
}

} // namespace flattening
