// SPDX-License-Identifier: GPL-3.0-or-later
/// A triangulated surface known only by its edge lengths, whose edges may be flipped.
#pragma once

#include "TriangleMesh.h"

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
class IntrinsicTriangulation
{
public:
  /// One logarithmic conformal factor u per vertex.
  using Factors = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

  /// The metric of @p mesh. If a face violates or merely attains the triangle inequality (to a relative
  /// 1e-10), the same small length is added to every edge until none does (Sharp and Crane 2020,
  /// "intrinsic mollification"); addedLength() tells how much, 0 for a mesh without degenerate faces.
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
  int twin(int h) const { return this->Twins[h]; } ///< -1 on the boundary
  long double logLength(int h) const { return this->LogLengths[h]; }

  /// Natural logarithm of each half-edge's length after the conformal change
  /// l_ij -> l_ij exp((u_i + u_j) / 2) (Luo 2004). @p u holds one value per vertex.
  long double scaledLogLength(int h, const Factors& u) const
  {
    return this->LogLengths[h] + 0.5L * (u[this->origin(h)] + u[this->tip(h)]);
  }

  /// Flips edges until the triangulation is Delaunay in its own flat metric, which it keeps. Returns
  /// the number of flips.
  int flipToDelaunay();

  /// Flips edges until the triangulation is Delaunay at conformal factors @p u, keeping the *discrete
  /// conformal class* (lengths change by Ptolemy's relation: Springborn, Schroeder, Pinkall 2008; Gu,
  /// Luo, Sun, Wu 2018). The scaled lengths then satisfy every triangle inequality away from the
  /// boundary.
  int flipToDelaunay(const Factors& u);

  /// Splits every boundary edge that sees an inner vertex at more than @p largestAngle (radians, at most
  /// pi / 2) at the foot of that altitude (or what is nearest to it in the middle three fifths), and
  /// makes the triangulation Delaunay again, until there is none or @p maximumRounds are done. A
  /// boundary edge cannot be flipped, so its triangle is where the flow of a triangulation with boundary
  /// can degenerate; a narrow one stays far from that. Where the opposite vertex is on the boundary too,
  /// splitting would only cascade into a sharp corner. New vertices lie on the boundary. Returns for
  /// each new vertex the ends of its edge and its parameter.
  struct BoundarySplit
  {
    int From;
    int To;
    double Parameter; ///< 0 at From, 1 at To
  };
  std::vector<BoundarySplit> splitBoundaryEdges(double largestAngle, int maximumRounds = 20);

  /// Flips edges of the link of boundary vertex @p vertex until the two angles opposite to each of them
  /// sum to less than pi - @p slack (radians), as far as the new neighbours are neither on the boundary
  /// nor neighbours already. Neighbours on a common circle with the vertex would become collinear, and
  /// their triangle degenerate, once it is at infinity.
  void growStar(int vertex, const std::vector<char>& onBoundary, double slack);

  /// Removes the faces around @p vertex and returns its link: the other ends of its edges in the order
  /// of its faces, counter-clockwise, each with the length of that edge. The vertex keeps its number.
  struct Spoke
  {
    int Vertex;
    long double LogLength;
  };
  std::vector<Spoke> removeStar(int vertex);

  /// The half-edges that leave @p vertex, counter-clockwise; for a boundary vertex from the one that
  /// runs along the boundary. The last boundary edge, which arrives at the vertex, is not among them.
  std::vector<int> outgoing(int vertex) const;

  /// A half-edge that leaves each vertex, the boundary one if there is one; -1 if it has no face.
  const std::vector<int>& anyOutgoing() const;

private:
  void flip(int h, long double logLength);
  long double otherDiagonal(int h) const;
  int splitBoundaryEdge(int h);
  template <typename ShouldFlip, typename NewLogLength>
  int flipAll(ShouldFlip&& shouldFlip, NewLogLength&& newLogLength);

  int VertexCount = 0;
  double AddedLength = 0.0;
  std::vector<int> Origins;
  std::vector<int> Twins;
  std::vector<long double> LogLengths;
  mutable std::vector<int> Outgoing; ///< empty when stale
};

/// The angles of a triangle with the given logarithmic side lengths, opposite to each side. Where the
/// triangle inequality fails the angle opposite to the longest side is pi and the others are 0: the C1
/// extension of the convex energy (Bobenko, Pinkall, Springborn 2015).
struct TriangleAngles
{
  double Angle[3];
  double Cotangent[3]; ///< 0 where the triangle is degenerate
  bool Degenerate;
};
TriangleAngles triangleAngles(long double logA, long double logB, long double logC);

} // namespace flattening
