// SPDX-License-Identifier: GPL-3.0-or-later
/// The area-preserving map of a surface to the unit disk, a rectangle or a convex polygon, from its
/// conformal map (paper, section 4).
#pragma once

#include "Areas/FaceRefinement.h"
#include "Areas/TargetAreas.h"
#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"
#include "Transport/PowerDiagram.h"
#include "Transport/Transport.h"

#include <vector>

namespace flattening
{

struct AreaPreservingOptions
{
  TransportOptions Transport; ///< StartWeights per vertex (n)
  /// The refined map of the transport with these StartWeights (n x 2), or empty: refinement goes on from
  /// there, which takes a fifth to a third of the time where weights have changed little. Counts for
  /// nothing if it is no one-to-one map of the mesh to the domain.
  Points2 StartPositions;
  bool RefineFaces = true; ///< from exact cells to exact faces (refineFaces)
  FaceRefinementOptions Refinement;
  /// How many neighbouring vertices are one site of the transport if faces are refined: the refinement
  /// needs of it what is wrong over whole regions only. Fewer where the mesh has few vertices. 1: every
  /// vertex is a site, as without refinement.
  int VerticesPerSite = 8;
};

struct AreaPreservingMap
{
  Points2 Positions;            ///< n x 2; boundary vertices on the boundary of the domain
  Eigen::VectorXd TargetAreas;  ///< n, sum pi
  Eigen::VectorXd CellAreas;    ///< n, sum pi; vertices of one site share its cell by target area
  Eigen::VectorXd PowerWeights; ///< n, of their sites, squared lengths in the domain
  int Sites = 0;                ///< of the transport
  int NewtonIterations = 0;
  int PowerDiagrams = 0;
  int CoincidentVertices = 0; ///< vertices that shared the conformal position of another
  double MaxCellError = 0.0;  ///< max_i |A_i - nu_i| / nu_i
  int FlippedFaces = 0;       ///< faces not positively oriented (exact)
  bool Bijective = false;     ///< whether none is, and the boundary vertices are in order
  bool IsContinued = false;   ///< whether refinement went on from StartPositions
  int RefinementRounds = 0;
  int RepairedFaces = 0;           ///< that were flipped between the stages of the refinement
  double StartShare = 1.0;         ///< see FaceRefinementResult
  std::vector<int> CornerVertices; ///< that stay in the domain's corners, counter-clockwise
};

struct AreaPreservingResult
{
  AreaPreservingMap Map;
  PowerDiagram Diagram;          ///< of the sites
  std::vector<int> SiteOfVertex; ///< n
};

/// Optimal transport of the surface's area, concentrated at @p conformal (n x 2, unit disk, the boundary
/// on the circle), to the uniform measure of the disk. Without refinement interior vertices go to the
/// centroids of their power cells and boundary vertices to the circle. With it the transport's sites are
/// small groups of vertices, which follow the smooth map through the centroids (interpolateTransport);
/// from there they are moved until the faces are exact.
/// @throws InvalidInput, TopologyError (see requireDisk, targetAreas), InvalidInput if @p conformal is
/// not such a map, ConvergenceError, Cancelled.
AreaPreservingResult areaPreservingDiskMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const Eigen::VectorXd& weights = {},
  const AreaPreservingOptions& options = {},
  const ProgressCallback& progress = {});

/// The same to a rectangle of area pi around the origin with sides along the axes: @p conformal has the
/// boundary on its sides and a vertex in each of its corners, where these stay.
/// @p width > 0 along x; the height is pi / width.
AreaPreservingResult areaPreservingRectangleMap(const TriangleMesh& mesh,
  const Points2& conformal,
  double width,
  const Eigen::VectorXd& weights = {},
  const AreaPreservingOptions& options = {},
  const ProgressCallback& progress = {});

struct PolygonTarget
{
  Points2 Corners; ///< k x 2, counter-clockwise, with area pi and its centroid at 0 (DomainPolygon.h)
  /// Whether a boundary vertex stays in each corner: the one whose power cell has the corner. Else
  /// corners are cut off by the boundary edges across them.
  bool FixCorners = false;
};

/// The same to a convex polygon, from a map @p conformal to another domain @p source, the unit disk or a
/// rectangle of area pi around the origin. The sites are the points of that map scaled into the largest
/// disk around 0 in the polygon. The transport does not depend on this scale: its map maximises the sum
/// of products of places and sites.
/// @throws as areaPreservingDiskMap, and InvalidInput if there are more corners to be fixed than
/// boundary vertices.
AreaPreservingResult areaPreservingPolygonMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const ConvexDomain& source,
  const PolygonTarget& polygon,
  const Eigen::VectorXd& weights = {},
  const AreaPreservingOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
