// SPDX-License-Identifier: GPL-3.0-or-later
/// The removal of folds no wider than an edge or two: spikes, pits, and fins of one voxel.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

struct FlattenedFolds
{
  int Spikes = 0;          ///< flattened spikes and pits: a single vertex each
  int Fins = 0;            ///< flattened ridges, sheets and larger spikes: several vertices each
  int LeftFolded = 0;      ///< places that are still folded
  double AreaChange = 0.0; ///< change of the surface's area, input units squared; usually < 0
};

/// Flattens folds. The flatness of a vertex is the length of the sum of the area vectors of the faces
/// around it over the sum of their areas: 1 where the surface is flat, sin(theta) on a cone that opens
/// by theta from its axis, 0 where two sheets lie on each other. Below 1/3 (a cone of 19 degrees) the
/// vertex is folded, below 1/2 it is steep.
///
/// Moves the vertices of every connected set of at most 20 steep inner vertices, of which at least one
/// is folded, to the means of their neighbours. A move is kept only if it unfolds the set, folds no
/// vertex beside it and makes no more faces intersect, so that larger sheets, which belong to the
/// object, stay as they are. Nothing is moved if less than a percent of the area would be left. Vertices
/// and faces keep their numbers.
/// @param mesh an oriented manifold.
FlattenedFolds flattenSpikesAndFins(TriangleMesh& mesh);

} // namespace flattening
