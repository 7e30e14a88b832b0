// SPDX-License-Identifier: GPL-3.0-or-later
/// Where the boundary vertices of a transported map lie on the boundary of the domain.
#pragma once

#include "Transport/PowerDiagram.h"

#include <vector>

namespace flattening
{

/// Places on the domain's boundary (ConvexDomain.h) for the vertices of @p loop (counter-clockwise),
/// strictly increasing over less than a full turn from the first one. A cell's centroid lies inside the
/// domain, but a boundary vertex belongs on the boundary (mathematics.md, "From exact cells to exact
/// faces"): it takes the middle of the part of the boundary that its cell has, or its centroid's
/// direction if it has none. Where this breaks the order of the loop, neighbours are moved by the
/// least-squares monotone fit.
/// @p siteOfVertex gives the diagram's site of each vertex.
std::vector<double> boundaryParameters(const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex);

/// The same where some vertices, members @p corners of the loop in its order, belong at @p cornerPlaces,
/// which increase over less than a full turn. The places of the other vertices lie between theirs.
std::vector<double> boundaryParameters(const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex,
  const std::vector<int>& corners,
  const std::vector<double>& cornerPlaces);

/// For each of @p cornerPlaces, which grow over less than a full turn, the member of the loop whose cell
/// has that place, or the part of the boundary nearest to it: no member twice, in the order of the
/// corners, modulo the loop.
/// @throws InvalidInput if there are fewer members than corners.
std::vector<int> cornerMembers(const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex,
  const std::vector<double>& cornerPlaces);

/// The non-decreasing sequence nearest to @p values in the sense of least squares (pool adjacent
/// violators), with the members of each pool spread evenly over a part of the gaps beside it so that the
/// result increases strictly.
std::vector<double> strictlyIncreasingFit(const std::vector<double>& values);

} // namespace flattening
