// SPDX-License-Identifier: GPL-3.0-or-later
/// Sets of faces of a mesh: their area, pieces and holes, and whether they form a disk.
#pragma once

#include "Triangles.h"

#include <vector>

namespace fuzz
{

/// The rounding of a sum of areas or lengths, as a share of the sum.
constexpr long double SumRounding = 1e-9L;
/// The rounding of the area of a face, as a share of its squared greatest side. It matters for needles.
constexpr long double NeedleRounding = 1e-14L;

/// For each face of a mesh, whether it belongs to the set.
using FaceSet = std::vector<bool>;

/// An area or a length, and by how much rounding may change it.
struct Measure
{
  long double Value = 0.0L;
  long double Rounding = 0.0L;
};

Measure areaWhere(const Triangles& mesh, const FaceSet& faces);

/// The mesh with only the faces of a set.
Triangles partOf(const Triangles& mesh, const FaceSet& faces);

/// Whether every face of one set belongs to the other.
bool isIn(const FaceSet& part, const FaceSet& whole);

/// The faces that belong to at least one of the sets.
FaceSet joined(FaceSet faces, const std::vector<FaceSet>& others);

/// The largest subsets whose faces are connected by common points.
std::vector<FaceSet> piecesOf(const Triangles& mesh, const FaceSet& faces);

/// The pieces of the other faces of a surface that reach no boundary of it; on a closed surface, all of
/// them but the largest.
std::vector<FaceSet> holesIn(const Triangles& surface, const FaceSet& faces);

/// Whether the boundary passes through a point more than once.
bool touchesItself(const Triangles& mesh);

bool isDisk(const Triangles& mesh);

} // namespace fuzz
