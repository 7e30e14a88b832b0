// SPDX-License-Identifier: GPL-3.0-or-later
/// The boundary of a disk as the curves on the surface along which it was cut. A seam has two banks: it
/// is twice in the boundary of the disk, once in either direction, with vertices of its own.
#pragma once

#include "Disk/SurfaceToDiskOptions.h"
#include "Mesh/DerivedMesh.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace flattening
{

/// Finds the copies that the cut made of one point.
/// @param origins  of the vertices, on the surface before it was cut: equal rows are copies of a point.
/// @param onSeam  one flag per vertex.
/// @return the first vertex that is a copy of the same point, per vertex; -1 for a vertex off the seam.
/// Empty if @p onSeam is empty.
std::vector<int> pointsOfSeam(const VertexOrigins& origins, const std::vector<char>& onSeam);

/// The seams in pieces that begin and end where seams end, branch, or meet the boundary of the surface
/// before it was cut. A point is named by the first vertex that is a copy of it.
struct SeamSegments
{
  /// The points of each piece, away from its start. The pieces are in the order in which the boundary of
  /// the disk meets them after the start of the seams.
  std::vector<std::vector<int>> Segments;
  std::vector<double> Lengths; ///< of the pieces, input units
  /// The points of the rest of the boundary: of the whole boundary, which begins and ends with the same
  /// point, or of each part between two seams.
  std::vector<std::vector<int>> Borders;
  /// Per vertex: the number of its piece, from 1, and the smallest one where several pieces meet; 0 off
  /// the seams. Copies of a point have the same.
  std::vector<int> SegmentOf;
  /// Per vertex: its distance from the start, along the seams; 0 off the seams. Copies of a point have
  /// the same, to the last bit.
  Eigen::VectorXd Distance;
};

/// Seams that are joined have one start: where they meet the boundary of the surface before it was cut;
/// if they do not, one of their ends; or a branching point of a cut graph without ends. Of several it is
/// the one closest to @p start, or the one with the smallest number.
SeamSegments seamSegments(const DiskSurface& disk, const std::optional<Eigen::Vector3d>& start = {});

} // namespace flattening
