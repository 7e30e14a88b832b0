// SPDX-License-Identifier: GPL-3.0-or-later
/// The area-preserving map of a surface to the unit disk, a rectangle or a convex polygon, from its
/// conformal map (paper, section 4).
#pragma once

#include "Areas/DomainTarget.h"
#include "Areas/FaceRefinement.h"
#include "Areas/TargetAreas.h"
#include "Areas/WarmStart.h"
#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"
#include "Transport/PowerDiagram.h"
#include "Transport/Transport.h"

#include <vector>

namespace flattening
{

/// How an area-preserving map is found.
struct AreaPreservingOptions
{
  TransportOptions Transport;
  WarmStart Start;         ///< an earlier result to begin with, or nothing
  bool RefineFaces = true; ///< whether faces are refined from exact cells to exact areas (refineFaces)
  FaceRefinementOptions Refinement;
  /// Whether the outline of the map is free (freeOutlineMap); needs RefineFaces.
  bool FreeOutline = false;
  /// How many neighbouring vertices share one site of the transport, >= 1; fewer where the mesh has few
  /// vertices or the scale of the conformal map changes much (groupedSites). The refinement corrects
  /// areas within small regions, and the transport has to get right the areas of large ones only.
  /// Without refinement every vertex is a site, as with 1.
  int VerticesPerSite = 16;
};

/// An area-preserving map to a domain of area pi, and how it was found.
struct AreaPreservingMap
{
  /// n x 2; boundary vertices lie on the boundary of the domain unless the outline is free. A map with a
  /// free outline has its centroid in the origin.
  Points2 Positions;
  /// n x 2; the same if they lie in the domain, otherwise the transported map, in which faces may be
  /// flipped.
  Points2 OnDomain;
  Eigen::VectorXd TargetAreas;     ///< n, sum pi
  Eigen::VectorXd CellAreas;       ///< n, sum pi; vertices of one site share its cell by target area
  Eigen::VectorXd PowerWeights;    ///< n, those of the vertices' sites, squared lengths in the domain
  int Sites = 0;                   ///< number of sites of the transport
  int NewtonIterations = 0;        ///< number of Newton steps of the transport
  int PowerDiagrams = 0;           ///< number of power diagrams that the transport computed
  int CoincidentVertices = 0;      ///< vertices that shared the conformal position of another
  double MaxCellError = 0.0;       ///< max_i |A_i - nu_i| / nu_i
  double ShareOff = 0.0;           ///< share of the faces whose area is off by more than 2 %
  int FlippedFaces = 0;            ///< faces not positively oriented (exact)
  bool Bijective = false;          ///< whether no face is flipped and the boundary vertices are in order
  bool WarmStarted = false;        ///< whether it was made from the positions of Start
  int RefinementRounds = 0;        ///< number of rounds of the refinement
  int RepairedFaces = 0;           ///< faces that were untangled between the stages of the refinement
  double StartShare = 1.0;         ///< see FaceRefinementResult
  bool IsFree = false;             ///< whether the outline is free
  std::vector<int> CornerVertices; ///< vertices that stay in the domain's corners, counter-clockwise
};

/// The map with the power diagram of the transport.
struct AreaPreservingResult
{
  AreaPreservingMap Map;
  PowerDiagram Diagram;          ///< power diagram of the sites
  std::vector<int> SiteOfVertex; ///< the site of each vertex (n)
};

/// Optimal transport of the surface's area, concentrated at @p conformal (n x 2, unit disk, the boundary
/// on the circle), to the uniform measure of the disk. Without refinement interior vertices go to the
/// centroids of their power cells and boundary vertices to the circle. With refinement the transport's
/// sites are small groups of vertices, which follow the smooth map through the centroids
/// (interpolateTransport); from there the vertices are moved until the faces have their areas.
/// @p weights (n, > 0) scale the areas that vertices should get; empty: all 1. With refinement, weights
/// whose greatest is more than 32 times the least are reached in steps, of which each starts from the
/// map of the one before. A transported map whose faces cannot be untangled is reached in steps as well:
/// from a map on the way to it, the transport begins again, up to three times. The transport, its cells
/// and its numbers are then those of the last step. With a free outline, the map does not come from the
/// transport, which gives the cells alone; if freeOutlineMap() has none, or more than 1 % of the faces
/// more would lose their areas in it, it is the map to the domain.
/// @throws InvalidInput, TopologyError (see requireDisk, targetAreas), InvalidInput if faces are refined
/// and weights differ by a factor of more than a million, InvalidInput if @p conformal is
/// not such a map, ConvergenceError, Cancelled.
AreaPreservingResult areaPreservingDiskMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const Eigen::VectorXd& weights = {},
  const AreaPreservingOptions& options = {},
  const ProgressCallback& progress = {});

/// The same to a rectangle of area pi around the origin with sides along the axes: @p conformal has the
/// boundary on the rectangle's sides and a vertex in each of its corners. These four vertices stay.
/// @p width > 0 is the extent along x; the height is pi / width.
/// @throws as areaPreservingDiskMap.
AreaPreservingResult areaPreservingRectangleMap(const TriangleMesh& mesh,
  const Points2& conformal,
  double width,
  const Eigen::VectorXd& weights = {},
  const AreaPreservingOptions& options = {},
  const ProgressCallback& progress = {});

/// The same to a convex polygon, from a map @p conformal to another domain @p source, the unit disk or a
/// rectangle of area pi around the origin. The sites are the points of that map scaled into the largest
/// disk around 0 in the polygon. The result does not depend on this scale: an optimal transport
/// maximises the integral of the scalar product of points and their sites.
/// @throws as areaPreservingDiskMap, and InvalidInput if more corners are to be fixed than there are
/// boundary vertices.
AreaPreservingResult areaPreservingPolygonMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const ConvexDomain& source,
  const PolygonTarget& polygon,
  const Eigen::VectorXd& weights = {},
  const AreaPreservingOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
