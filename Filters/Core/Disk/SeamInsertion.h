// SPDX-License-Identifier: GPL-3.0-or-later
/// Seams that are made edges of a mesh one after the other, until the surface is cut open along them.
#pragma once

#include "Disk/EdgeCut.h"
#include "Geodesics/GeodesicPath.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshTopology.h"

#include <Eigen/Core>

#include <set>
#include <utility>
#include <vector>

namespace flattening
{

struct SeamOpenedSurface
{
  /// The cut surface has the same genus. It is a disk if the genus is 0 and the surface was closed, or a
  /// tube cut from end to end, or has one boundary to which all seams lead.
  CutSurface Cut;
  /// The points asked for, moved onto the surface.
  std::vector<Eigen::Vector3d> Points;
  double Length = 0.0; ///< of the seams, input units
};

/// A surface and the seams in it. Vertices and edges are *taken* if they lie on the boundary or on a
/// seam. The taken edges form parts: each boundary loop is one, and a seam is a part of its own until it
/// meets others.
class SeamInsertion
{
public:
  using Vertex = EditableSurface::Vertex;

  /// @param topology  of the mesh
  SeamInsertion(const TriangleMesh& mesh, const MeshTopology& topology);

  /// The surface, in which points may be inserted and faces refined as long as no seam's edge is split.
  EditableSurface& surface() { return this->Surface; }
  const SurfaceMesh& mesh() const { return this->Surface.mesh(); }

  bool isOnBoundary(const PathPoint& point) const;
  bool isOnSeam(const PathPoint& point) const;
  bool isTaken(Vertex v) const { return this->partOf(v) >= 0; }
  /// Whether an end of a seam or a boundary joins both vertices: a seam between them closes a loop.
  bool areJoined(Vertex a, Vertex b) const;
  /// The number of parts.
  int partCount() const { return this->Parts; }
  /// The number of edges of all seams.
  std::size_t edgeCount() const { return this->Edges.size(); }

  /// Takes a vertex without an edge, as a part of its own.
  void take(Vertex v);

  /// Makes a path a seam. Only its ends may be taken, and not by the same part.
  /// @param path  as snapToVertices leaves it, without taken vertices
  /// @return the vertices of the new seam
  std::vector<Vertex> insert(const std::vector<PathPoint>& path);

  /// Improves the faces along the seams (flipInsideOriginalFaces), splits edges beside them that join
  /// two vertices of the boundary to be, and cuts the surface open along the seams.
  SeamOpenedSurface cut();

private:
  void splitChords();
  int partOf(Vertex v) const;
  void join(Vertex v, int part);

  EditableSurface Surface;
  std::set<std::pair<Vertex, Vertex>> Edges; // of the seams, the smaller vertex first
  std::vector<int> LabelOf;                  // per vertex: the label of its part, or -1
  std::vector<int> PartOfLabel;              // labels of parts that met name the same part
  int Parts = 0;
};

} // namespace flattening
