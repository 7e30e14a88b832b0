// SPDX-License-Identifier: GPL-3.0-or-later
/// First homology of a surface with coefficients in Z2, written on its edges.
#pragma once

#include "Handles/HalfedgeSurface.h"

#include <boost/dynamic_bitset.hpp>

#include <cstdint>
#include <vector>

namespace flattening
{

/// Every edge has a label, an element of Z2^(2 g). The sum of the labels along a closed curve of edges
/// is its homology class in the surface whose boundary loops are closed by disks: zero if and only if
/// the curve bounds there. A simple closed curve bounds if and only if it separates the surface.
///
/// The labels come from a tree-cotree decomposition (Eppstein 2003, "Dynamic generators of topologically
/// embedded graphs"; Erickson, Whittlesey 2005, "Greedy optimal homotopy and homology generators"): 2 g
/// edges belong neither to a breadth-first tree of the faces nor to one of the vertices. These edges get
/// the unit vectors, the edges of the vertex tree get zero, and the label of every other edge follows
/// because the labels around a face sum to zero.
///
/// Many edges share a label, so that an edge stores the number of its label.
class HomologyLabels
{
public:
  using Class = boost::dynamic_bitset<std::uint64_t>; ///< 2 g bits

  /// Labels a connected surface in linear time. @throws TopologyError if it is not connected.
  explicit HomologyLabels(const HalfedgeSurface& surface);

  /// The genus of the surface after all cuts that were followed.
  int genus() const { return this->Genus; }

  /// A random projection of a half-edge's label to 64 bits, with a fixed seed. It is linear: the hash of
  /// a sum of labels is the exclusive or of their hashes. A sum other than zero has hash zero with a
  /// probability of 2^-64.
  std::uint64_t hash(int halfedge) const { return this->Labels[this->LabelOf[halfedge]].Hash; }

  /// The class of a closed loop of half-edges.
  Class classOf(const std::vector<int>& loop) const;

  /// Keeps the labels valid after @p surface was cut along a loop that does not bound, and both sides
  /// were closed by disks or left open: the homology of the new surface is the quotient by the loop's
  /// class.
  /// @param vertices sources of the loop's half-edges before the cut.
  /// @param firstCopy number of the first of their copies.
  void followCut(const HalfedgeSurface& surface,
    const std::vector<int>& loop,
    const std::vector<int>& vertices,
    int firstCopy);

  /// Keeps the labels valid after HalfedgeSurface::splitEdge.
  void followSplit(const HalfedgeSurface& surface, int h);

private:
  struct Label
  {
    Class Bits;
    std::uint64_t Hash;
  };

  int sum(int a, int b);
  void divideBy(const std::vector<int>& loop);

  int Genus = 0;
  std::vector<Label> Labels; // number 0 is zero
  std::vector<int> LabelOf;  // per half-edge
};

} // namespace flattening
