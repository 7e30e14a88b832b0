// SPDX-License-Identifier: GPL-3.0-or-later
/// Places where a surface is folded on itself within an edge or two: spikes, pits and fins of one voxel.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

struct FlattenedFolds
{
  int Spikes = 0;          ///< spikes and pits: a single vertex each
  int Fins = 0;            ///< ridges, sheets and larger spikes: several neighbouring vertices each
  int LeftFolded = 0;      ///< places that are folded still
  double AreaChange = 0.0; ///< of the surface, input units squared; as a rule < 0
};

/// The size of the sum of the area vectors of the faces around a vertex over the sum of their areas: 1
/// where the surface is flat, sin(theta) on a cone that opens by theta from its axis, 0 where two sheets
/// lie on each other.
/// Below 1/3 (a cone of 19 degrees) the surface is folded there.
constexpr double FoldedRatio = 1.0 / 3.0;

/// Moves the vertices of every connected set of at most 20 inner vertices that are folded, or beside
/// such ones and steep (a ratio below 1/2), to where each is the mean of its neighbours, which flattens
/// the fold into its surroundings. That is done only if it unfolds them all, folds no vertex beside them
/// and leads no more faces through others, so that larger sheets, which belong to the object, stay as
/// they are. Vertices and faces keep their numbers.
/// @param mesh an oriented manifold.
FlattenedFolds flattenSpikesAndFins(TriangleMesh& mesh);

} // namespace flattening
