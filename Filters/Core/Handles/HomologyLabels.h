// SPDX-License-Identifier: GPL-3.0-or-later
/// First homology of a surface with coefficients in Z2, written on its edges.
#pragma once

#include "Handles/HalfedgeSurface.h"

#include <cstdint>
#include <vector>

namespace flattening
{

/// Every edge has a label, an element of Z2^(2 g). The sum of the labels along a closed curve of edges
/// is its homology class in the surface whose boundary loops are closed by disks: zero if and only if
/// the curve bounds there. A simple closed curve bounds if and only if it separates.
///
/// From a tree-cotree decomposition (Eppstein 2003, "Dynamic generators of topologically embedded
/// graphs"; Erickson, Whittlesey 2005, "Greedy optimal homotopy and homology generators"): 2 g edges
/// belong neither to a breadth-first tree of the faces nor to one of the vertices. They get the unit
/// vectors, those of the vertex tree zero, and the others what makes the sum around each face zero.
///
/// Few labels differ from each other, so that an edge stores the number of its label.
class HomologyLabels
{
public:
  using Class = std::vector<std::uint64_t>; ///< 2 g bits

  /// Labels of a connected surface, in linear time. @throws TopologyError if it is not connected.
  explicit HomologyLabels(const HalfedgeSurface& surface);

  /// Of the surface after all cuts that were followed.
  int genus() const { return this->Genus; }

  /// A random projection of a half-edge's label to 64 bits, with a fixed seed: sums of labels differ
  /// from zero whenever those of their hashes do, and the converse fails once in 2^64 sums.
  std::uint64_t hash(int halfedge) const { return this->Labels[this->LabelOf[halfedge]].Hash; }

  /// The class of a closed loop of half-edges.
  Class classOf(const std::vector<int>& loop) const;
  static bool isZero(const Class& homologyClass);

  /// Keeps the labels valid after @p surface was cut along a loop that does not bound, and both sides
  /// were closed by disks or left open: the homology of the new surface is the quotient by the loop's
  /// class.
  /// @param vertices origins of the loop's half-edges before the cut.
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
