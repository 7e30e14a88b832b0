// SPDX-License-Identifier: GPL-3.0-or-later
/// The positions of a transported map's boundary vertices on the boundary of the domain.
#pragma once

#include "Transport/PowerDiagram.h"

#include <vector>

namespace flattening
{

/// The boundary of a mesh, and which of its vertices stay in corners of the domain.
struct BoundaryLoop
{
  std::vector<int> Vertices;            ///< counter-clockwise
  std::vector<int> Corners;             ///< indices into Vertices, ascending; may be empty
  std::vector<double> CornerParameters; ///< where these stay, increasing over less than one turn
};

/// Boundary parameters (ConvexDomain.h) of the vertices of @p boundary, strictly increasing over less
/// than one turn from the first vertex or, if corners are given, from the first corner. A cell's
/// centroid lies inside the domain, but a boundary vertex belongs on the boundary (docs/mathematics.md,
/// "From cells to faces"). The vertex takes the middle of the part of the boundary that lies in its
/// cell or, if the cell does not reach the boundary, the direction in which the centroid of its cell
/// lies. Where the parameters found in this way do not follow the order of the loop,
/// strictlyIncreasingFit() moves them. If there are corners, their vertices stay there, and the other
/// vertices stay between them.
/// @param siteOfVertex  n, the diagram's site of each vertex
std::vector<double> boundaryParameters(const PowerDiagram& diagram,
  const BoundaryLoop& boundary,
  const std::vector<int>& siteOfVertex);

/// For each of @p cornerParameters (increasing over less than one turn) the index in @p loop of the
/// vertex whose cell contains that point of the boundary, or else comes nearest to it. No index occurs
/// twice; they follow the order of the corners, modulo the length of the loop.
/// @throws InvalidInput if there are fewer boundary vertices than corners.
std::vector<int> cornerMembers(const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex,
  const std::vector<double>& cornerParameters);

/// The sequence nearest to @p values in the sense of least squares whose gaps are at least @p leastGap
/// (>= 0; pool adjacent violators, Barlow et al. 1972), made strictly increasing. In the sequence, runs
/// of neighbours, the pools, have the least gap. The members of each pool are spread evenly about its
/// mean, by a part of the smaller gap to the pools beside it.
std::vector<double> strictlyIncreasingFit(const std::vector<double>& values, double leastGap);

} // namespace flattening
