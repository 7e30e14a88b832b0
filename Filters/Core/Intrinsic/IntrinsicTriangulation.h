// SPDX-License-Identifier: GPL-3.0-or-later
/// A triangulated surface that is known by its edge lengths only and whose edges may be flipped.
#pragma once

#include "Base/Progress.h"
#include "Intrinsic/SymmetricTrapezoid.h"
#include "Intrinsic/TriangleAngles.h"
#include "Mesh/Halfedges.h"
#include "Mesh/TriangleMesh.h"

#include <limits>
#include <optional>
#include <vector>

namespace flattening
{

/// Half-edges are numbered 3 f + k: side k of face f, from its vertex k to its vertex k + 1. After flips
/// the triangulation may be a Delta-complex (two edges between the same vertices, an edge from a vertex
/// to itself), so that neighbours are identified by half-edges, never by vertices.
///
/// Lengths are stored as logarithms: they stay representable whatever the conformal factors, and the
/// lengths after a flip by Ptolemy's relation are sums of positive terms. They have extended precision
/// because the angles of needles depend on small differences of them.
///
/// The boundary is a mirror: the surface and its mirror image, glued along it, are a closed surface, for
/// which discrete uniformization has no exceptions. After a flip of a boundary edge and its image,
/// symmetric trapezoids (SymmetricTrapezoid.h), the mirror cells, lie in order along the mirror. A
/// vertex that flips have brought to the boundary stands for the edge from it to its image.
class IntrinsicTriangulation
{
public:
  /// One logarithmic conformal factor u per vertex.
  using Factors = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

  /// Takes over the metric of @p mesh. If a face violates or merely attains the triangle inequality (up
  /// to slivers::IntrinsicExcess of the mean edge length), or an edge is shorter than
  /// slivers::IntrinsicEdge of it, the same small length is added to every edge so that none does any
  /// more (Sharp and Crane 2020, "A Laplacian for nonmanifold triangle meshes", intrinsic
  /// mollification); addedLength() tells how much.
  explicit IntrinsicTriangulation(const TriangleMesh& mesh);

  int vertexCount() const { return this->VertexCount; }
  int faceCount() const { return static_cast<int>(this->Origins.size() / 3); }
  int halfedgeCount() const { return static_cast<int>(this->Origins.size()); }
  /// The length added to every edge, input units; 0 for a mesh without degenerate faces and nearly
  /// coincident vertices.
  double addedLength() const { return this->AddedLength; }

  static int face(int h) { return h / 3; }
  static int next(int h) { return nextHalfedge(h); }
  static int previous(int h) { return previousHalfedge(h); }
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
    int Origin;   ///< vertex; -1 if the edge was removed
    int Previous; ///< the boundary edge before this one
    int Next;     ///< the boundary edge after this one
    int Inner;    ///< half-edge along it, or -1 - b if boundary edge b runs along its other side
    long double LogLength;
    long double LogCrossing; ///< logarithm of the distance of its origin from the image; or OnMirror
    bool AtInfinity;         ///< whether it is opposite to the vertex at infinity, without a mirror cell
  };
  const std::vector<BoundaryEdge>& boundaryEdges() const { return this->Boundary; }
  int tipOfBoundaryEdge(int b) const { return this->Boundary[this->Boundary[b].Next].Origin; }
  /// The mirror cell of boundary edge @p b at factors @p u.
  SymmetricTrapezoid scaledTrapezoid(int b, const Factors& u) const;

  /// Flips inner edges until the triangulation is Delaunay in its own flat metric, which it keeps.
  /// Returns the number of flips: about as many as edges for isosurfaces, the square of the number of
  /// vertices for long strips of fans.
  /// @throws ConvergenceError after 1000 flips for each half-edge; Cancelled.
  long long flipToDelaunay(const ProgressCallback& progress = {});

  /// Does the same for the triangulation together with its mirror image: where an angle opposite to the
  /// boundary is obtuse, mirror cells result.
  /// @throws ConvergenceError after 1000 flips for each half-edge; Cancelled.
  long long flipDoubleToDelaunay(const ProgressCallback& progress = {});

  /// Flips edges until the triangulation, with its mirror image, is Delaunay at conformal factors @p u,
  /// keeping the *discrete conformal class* (lengths change by Ptolemy's relation: Springborn,
  /// Schroeder, Pinkall 2008; Gu, Luo, Sun, Wu 2018). The scaled lengths then satisfy every triangle
  /// inequality, except next to edges at infinity. Ends after 10 flips for each half-edge, as more are a
  /// sign of factors that a flow should not keep. Returns the number of flips.
  long long flipToDelaunay(const Factors& u);

  /// An edge between the vertex at infinity and one of its neighbours.
  struct Spoke
  {
    int Vertex; ///< the neighbour
    long double LogLength;
  };
  /// The surroundings of the vertex that went to infinity.
  struct Star
  {
    std::vector<Spoke> Spokes; ///< in the order of the faces, counter-clockwise
    int FirstBoundaryEdge;     ///< the first edge of the rest of the mirror
  };
  /// Removes the faces around boundary vertex @p vertex, which goes to infinity and keeps its number.
  /// The boundary then consists of the rest of the mirror, from FirstBoundaryEdge on, and after it the
  /// edges opposite to the vertex, at infinity. Precondition: no flip has brought a vertex to the
  /// mirror.
  Star removeStar(int vertex);

  /// A new neighbour of the vertex at infinity and the conformal factor that it must have.
  struct Neighbour
  {
    int Vertex;
    long double LogFactor;
  };
  /// If an edge at infinity is longer than the other two sides of its face together at factors @p u, the
  /// opposite vertex lies beyond it and becomes a neighbour of the vertex at infinity, unless it is
  /// @p excluded (per vertex). With the factor returned its distance from infinity is that of the other
  /// neighbours. One call adds at most one vertex.
  std::optional<Neighbour> reachInfinity(const Factors& u, const std::vector<char>& excluded);

  /// A copy of some faces, in which edges to the rest cannot be flipped, and its origin.
  struct Part;
  Part part(const std::vector<int>& faces) const;

  /// Takes over the flips made in @p part, a result of part(). Precondition: this triangulation has not
  /// changed since.
  void replace(const Part& part);

  /// The half-edges that leave @p vertex, counter-clockwise; for a boundary vertex from the one that
  /// runs along the boundary. The last boundary edge, which arrives at the vertex, is not among them.
  /// Precondition: no flip has brought a vertex to the mirror.
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
  std::vector<int> Origins; ///< -1 for the sides of a removed face, until closeGaps()
  std::vector<int> Twins;
  std::vector<long double> LogLengths;
  std::vector<BoundaryEdge> Boundary;
  std::vector<int> FreeFaces; ///< removed faces, until closeGaps()
  mutable std::vector<int>
    Outgoing; ///< a half-edge that leaves each vertex; empty if it must be computed
};

/// Some faces of a whole triangulation.
struct IntrinsicTriangulation::Part
{
  IntrinsicTriangulation Triangulation; ///< with vertices numbered from 0
  std::vector<int> Vertices;            ///< the vertex of the whole for each vertex of the part
  std::vector<int> Faces;               ///< the face of the whole for each face of the part
  std::vector<int> Outside; ///< the side of the whole beyond each boundary edge, as in twin()
};

} // namespace flattening
