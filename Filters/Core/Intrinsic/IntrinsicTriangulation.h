// SPDX-License-Identifier: GPL-3.0-or-later
/// A triangulated surface known only by its edge lengths, whose edges may be flipped.
#pragma once

#include "Intrinsic/SymmetricTrapezoid.h"
#include "Intrinsic/TriangleAngles.h"
#include "Mesh/TriangleMesh.h"

#include <limits>
#include <optional>
#include <vector>

namespace flattening
{

/// Half-edges are numbered 3 f + k: side k of face f, from its vertex k to its vertex k + 1. After flips
/// the triangulation may be a Delta-complex (two edges between the same vertices, an edge from a vertex
/// to itself), so neighbours are known by their half-edges, never by their vertices.
///
/// Lengths are kept as logarithms: they stay representable whatever the conformal factors, and Ptolemy's
/// flip is a sum of positive terms in them. They are of extended precision because the angles of needles
/// depend on small differences of them.
///
/// The boundary is a mirror: the surface and its mirror image, glued along it, are a closed surface, for
/// which discrete uniformization has no exceptions. What flips make of a boundary edge and its image is
/// kept as mirror cells (MirrorCell.h), in order along the mirror. A vertex that flips have brought
/// there stands for the edge from it to its image.
class IntrinsicTriangulation
{
public:
  /// One logarithmic conformal factor u per vertex.
  using Factors = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

  /// The metric of @p mesh. If a face violates or merely attains the triangle inequality (to 1e-10 of
  /// the mean edge length), or an edge is shorter than 1e-7 of that, the same small length is added to
  /// every edge until none does (Sharp and Crane 2020, "intrinsic mollification"); addedLength() tells
  /// how much, 0 for a mesh without degenerate faces and nearly coincident vertices.
  explicit IntrinsicTriangulation(const TriangleMesh& mesh);

  int vertexCount() const { return this->VertexCount; }
  int faceCount() const { return static_cast<int>(this->Origins.size() / 3); }
  int halfedgeCount() const { return static_cast<int>(this->Origins.size()); }
  double addedLength() const { return this->AddedLength; }

  static int face(int h) { return h / 3; }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int origin(int h) const { return this->Origins[h]; }
  int tip(int h) const { return this->Origins[next(h)]; }
  int twin(int h) const { return this->Twins[h]; } ///< -1 - b if boundary edge b is on its other side
  long double logLength(int h) const { return this->LogLengths[h]; }

  /// Natural logarithm of each half-edge's length after the conformal change
  /// l_ij -> l_ij exp((u_i + u_j) / 2) (Luo 2004). @p u holds one value per vertex.
  long double scaledLogLength(int h, const Factors& u) const
  {
    return this->LogLengths[h] + 0.5L * (u[this->origin(h)] + u[this->tip(h)]);
  }

  /// The angles of face @p f at factors @p u: entry k is opposite to half-edge 3 f + k.
  TriangleAngles scaledAngles(int f, const Factors& u) const
  {
    return triangleAngles(this->scaledLogLength(3 * f, u),
      this->scaledLogLength(3 * f + 1, u),
      this->scaledLogLength(3 * f + 2, u));
  }

  /// The logarithm of the distance of a vertex on the mirror from its image.
  static constexpr long double OnMirror = -std::numeric_limits<long double>::infinity();

  /// An edge of the boundary, with the surface on its left.
  struct BoundaryEdge
  {
    int Origin;   ///< vertex; -1 if the edge is no more
    int Previous; ///< in order along the boundary
    int Next;
    int Inner; ///< half-edge along it, or -1 - b if boundary edge b runs along its other side
    long double LogLength;
    long double LogCrossing; ///< from its origin to the image of that; OnMirror if it lies there
    bool AtInfinity;         ///< seen from the vertex at infinity: no mirror cell
  };
  const std::vector<BoundaryEdge>& boundaryEdges() const { return this->Boundary; }
  int tipOfBoundaryEdge(int b) const { return this->Boundary[this->Boundary[b].Next].Origin; }
  SymmetricTrapezoid scaledTrapezoid(int b, const Factors& u) const;

  /// Flips inner edges until the triangulation is Delaunay in its own flat metric, which it keeps.
  /// Returns the number of flips.
  int flipToDelaunay();

  /// The same for the triangulation with its mirror image: where an angle opposite to the boundary is
  /// obtuse, mirror cells come about.
  int flipDoubleToDelaunay();

  /// Flips edges until the triangulation, with its mirror image, is Delaunay at conformal factors @p u,
  /// keeping the *discrete conformal class* (lengths change by Ptolemy's relation: Springborn,
  /// Schroeder, Pinkall 2008; Gu, Luo, Sun, Wu 2018). The scaled lengths then satisfy every triangle
  /// inequality, but next to edges at infinity.
  int flipToDelaunay(const Factors& u);

  /// Removes the faces around boundary vertex @p vertex, which goes to infinity and keeps its number.
  /// The boundary then consists of the rest of the mirror, from FirstBoundaryEdge on, and after it the
  /// edges opposite to the vertex, at infinity. The flips above must not have brought a vertex to the
  /// mirror yet.
  struct Spoke
  {
    int Vertex; ///< other end
    long double LogLength;
  };
  struct Star
  {
    std::vector<Spoke> Spokes; ///< in the order of the faces, counter-clockwise
    int FirstBoundaryEdge;
  };
  Star removeStar(int vertex);

  /// If an edge at infinity is longer than the other two sides of its face together at factors @p u, the
  /// opposite vertex lies beyond it and becomes a neighbour of the vertex at infinity, unless it is
  /// @p excluded (per vertex). Its factor must then be the one returned, so that its distance from
  /// infinity is that of the other neighbours. One vertex at a time.
  struct Neighbour
  {
    int Vertex;
    long double LogFactor;
  };
  std::optional<Neighbour> reachInfinity(const Factors& u, const std::vector<char>& excluded);

  /// A copy of some faces, in which edges to the rest cannot be flipped, and where it came from.
  struct Part;
  Part part(const std::vector<int>& faces) const;

  /// Takes over the flips made in a part that part() returned, this triangulation being unchanged since.
  void replace(const Part& part);

  /// The half-edges that leave @p vertex, counter-clockwise; for a boundary vertex from the one that
  /// runs along the boundary. The last boundary edge, which arrives at the vertex, is not among them.
  /// For triangulations without vertices that flips brought to the mirror.
  std::vector<int> outgoing(int vertex) const;

private:
  IntrinsicTriangulation() = default;
  int addFace();
  void removeFace(int f);
  void closeGaps();
  int addBoundaryEdge(const BoundaryEdge& edge);
  void glue(int side, int otherSide);
  void flip(int h, long double logLength);
  void openBoundaryEdge(int b, long double logCrossing);
  int closeBoundaryVertex(int b, long double logAcross);
  long double otherDiagonal(int h) const;
  template <typename Metric>
  class DelaunayFlips;

  int VertexCount = 0;
  double AddedLength = 0.0;
  std::vector<int> Origins; ///< -1 for the sides of a face that is no more, while edges are flipped only
  std::vector<int> Twins;
  std::vector<long double> LogLengths;
  std::vector<BoundaryEdge> Boundary;
  std::vector<int> FreeFaces;
  mutable std::vector<int> Outgoing; ///< empty when stale
};

struct IntrinsicTriangulation::Part
{
  IntrinsicTriangulation Triangulation; ///< with vertices numbered from 0
  std::vector<int> Vertices;            ///< of the whole, for each of the part's
  std::vector<int> Faces;               ///< of the whole
  std::vector<int> Outside; ///< the side of the whole beyond each boundary edge, as in twin()
};

} // namespace flattening
