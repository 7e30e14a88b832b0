// SPDX-License-Identifier: GPL-3.0-or-later
#include "IntrinsicTriangulation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{

constexpr int HalfedgesPerTask = 4096;
constexpr double FlipTolerance = 1e-12;
// Two opposite angles whose cosines have a larger sum need not be looked at more closely.
constexpr double CertainlyDelaunay = 1e-3;
// Relative to the mean edge length. The angles of a shorter edge's needles would lose more digits of the
// logarithms than the flow's tolerance allows.
constexpr double LeastExcess = 1e-10;
constexpr double LeastLength = 1e-7;
constexpr long double OnMirror = -std::numeric_limits<long double>::infinity();

std::vector<int> findTwins(const FaceMatrix& faces)
{
  std::vector<std::pair<std::uint64_t, int>> keyed(3 * faces.rows());
  for (int h = 0; h < static_cast<int>(keyed.size()); ++h)
  {
    const int a = faces(h / 3, h % 3);
    const int b = faces(h / 3, (h + 1) % 3);
    keyed[h] = {
      (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint64_t>(std::max(a, b)), h
    };
  }
  tbb::parallel_sort(keyed.begin(), keyed.end());
  std::vector<int> twins(keyed.size(), -1);
  for (std::size_t i = 0; i + 1 < keyed.size(); ++i)
  {
    if (keyed[i].first == keyed[i + 1].first)
    {
      twins[keyed[i].second] = keyed[i + 1].second;
      twins[keyed[i + 1].second] = keyed[i].second;
    }
  }
  return twins;
}

// The metric of the surface itself. The boundary stays as it is.
struct FlatMetric
{
  const IntrinsicTriangulation& Triangulation;
  std::function<long double(int)> OtherDiagonal;

  long double logLength(int h) const { return this->Triangulation.logLength(h); }
  double cosine(int h) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    return cosineOpposite(t.logLength(h), t.logLength(t.next(h)), t.logLength(t.previous(h)));
  }
  bool mustFlip(int h) const
  {
    return this->cosine(h) + this->cosine(this->Triangulation.twin(h)) < -FlipTolerance;
  }
  long double flipped(int h) const { return this->OtherDiagonal(h); }
  bool mustOpen(int) const { return false; }
  long double opened(int) const { return 0.0L; }
  bool mustClose(int) const { return false; }
  long double closed(int) const { return 0.0L; }
};

// The metric at some factors. The new lengths are those at factors 0: Ptolemy's relations are the same
// at all of them.
struct ConformalMetric
{
  const IntrinsicTriangulation& Triangulation;
  const IntrinsicTriangulation::Factors& U;

  long double logLength(int h) const { return this->Triangulation.scaledLogLength(h, this->U); }
  double cosine(int h) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    return cosineOpposite(t.scaledLogLength(h, this->U),
      t.scaledLogLength(t.next(h), this->U),
      t.scaledLogLength(t.previous(h), this->U));
  }
  MirrorCell cell(int b) const { return this->Triangulation.scaledMirrorCell(b, this->U); }
  MirrorCell unscaledCell(int b) const
  {
    const auto& edges = this->Triangulation.boundaryEdges();
    return { edges[b].LogLength, edges[b].LogCrossing, edges[edges[b].Next].LogCrossing };
  }

  bool mustFlip(int h) const
  {
    return this->cosine(h) + this->cosine(this->Triangulation.twin(h)) < -FlipTolerance;
  }
  long double flipped(int h) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    const int o = t.twin(h);
    const long double x = t.logLength(t.previous(h)) + t.logLength(t.previous(o)); // ca + db
    const long double y = t.logLength(t.next(h)) + t.logLength(t.next(o));         // bc + ad
    return std::max(x, y) + std::log1p(std::exp(static_cast<double>(-std::abs(x - y)))) - t.logLength(h);
  }
  bool mustOpen(int b) const
  {
    const auto& edge = this->Triangulation.boundaryEdges()[b];
    return !edge.AtInfinity && edge.Inner >= 0 &&
           this->cosine(edge.Inner) + cosineOppositeEdge(this->cell(b)) < -FlipTolerance;
  }
  long double opened(int b) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    const int h = t.boundaryEdges()[b].Inner;
    return crossingAtApex(this->unscaledCell(b), t.logLength(t.previous(h)), t.logLength(t.next(h)));
  }
  bool mustClose(int b) const
  {
    const auto& edge = this->Triangulation.boundaryEdges()[b];
    return edge.LogCrossing != OnMirror &&
           cosineOppositeCrossing(this->cell(b)) +
               cosineOppositeCrossing(this->cell(edge.Previous).reversed()) <
             -FlipTolerance;
  }
  long double closed(int b) const
  {
    return edgeAcross(
      this->unscaledCell(this->Triangulation.boundaryEdges()[b].Previous), this->unscaledCell(b));
  }
};

// The metric of the surface and its mirror image, unfolded into the plane with the mirror as x axis.
struct DoubledMetric : ConformalMetric
{
  std::function<long double(int)> OtherDiagonal;

  long double flipped(int h) const { return this->OtherDiagonal(h); }
  long double opened(int b) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    const MirrorCell cell = this->unscaledCell(b);
    const int h = t.boundaryEdges()[b].Inner;
    const auto inEdges = [&cell](long double logLength)
    { return std::exp(static_cast<double>(logLength - cell.LogEdge)); };
    const double p = inEdges(t.logLength(t.previous(h)));
    const double q = inEdges(t.logLength(t.next(h)));
    const double along = 0.5 * (1.0 + (p - q) * (p + q));
    const double across = std::sqrt(std::max(0.0, (p - along) * (p + along)));
    const double above = inEdges(cell.LogAtOrigin) +
                         along * (inEdges(cell.LogAtTip) - inEdges(cell.LogAtOrigin)) +
                         2.0 * across * mirrorCellShape(cell).Extent;
    return cell.LogEdge + std::log(above);
  }
  long double closed(int b) const
  {
    const MirrorCell after = this->unscaledCell(b);
    const MirrorCell before = this->unscaledCell(this->Triangulation.boundaryEdges()[b].Previous);
    const auto inEdges = [&after](long double logLength)
    { return std::exp(static_cast<double>(logLength - after.LogEdge)); };
    const double x =
      mirrorCellShape(after).Extent + inEdges(before.LogEdge) * mirrorCellShape(before).Extent;
    const double y = 0.5 * (inEdges(after.LogAtTip) - inEdges(before.LogAtOrigin));
    return after.LogEdge + std::log(std::hypot(x, y));
  }
};

} // namespace

IntrinsicTriangulation::IntrinsicTriangulation(const TriangleMesh& mesh)
  : VertexCount(mesh.vertexCount())
{
  const int count = 3 * mesh.faceCount();
  this->Origins.resize(count);
  this->Twins = findTwins(mesh.Faces);
  std::vector<double> lengths(count);
  double total = 0.0;
  for (int h = 0; h < count; ++h)
  {
    const int a = mesh.Faces(h / 3, h % 3);
    const int b = mesh.Faces(h / 3, (h + 1) % 3);
    this->Origins[h] = a;
    lengths[h] = (mesh.Vertices.row(a) - mesh.Vertices.row(b)).stableNorm();
    total += lengths[h];
  }
  const double slack = LeastExcess * total / count;
  const double shortest = LeastLength * total / count;
  for (int h = 0; h < count; ++h)
  {
    const double excess = lengths[next(h)] + lengths[previous(h)] - lengths[h];
    this->AddedLength = std::max({ this->AddedLength, slack - excess, shortest - lengths[h] });
  }
  this->LogLengths.resize(count);
  tbb::parallel_for(tbb::blocked_range<int>(0, count, HalfedgesPerTask),
    [&](const tbb::blocked_range<int>& halfedges)
    {
      for (int h = halfedges.begin(); h < halfedges.end(); ++h)
      {
        this->LogLengths[h] = std::log(lengths[h] + this->AddedLength);
      }
    });

  std::vector<int> leaving(this->VertexCount, -1);
  for (int h = 0; h < count; ++h)
  {
    if (this->Twins[h] < 0)
    {
      leaving[this->Origins[h]] =
        this->addBoundaryEdge({ this->Origins[h], -1, -1, -1, this->LogLengths[h], OnMirror, false });
      this->glue(h, -1 - leaving[this->Origins[h]]);
    }
  }
  for (int b = 0; b < static_cast<int>(this->Boundary.size()); ++b)
  {
    const int next = leaving[this->tip(this->Boundary[b].Inner)];
    this->Boundary[b].Next = next;
    this->Boundary[next].Previous = b;
  }
}

MirrorCell IntrinsicTriangulation::scaledMirrorCell(int b, const Factors& u) const
{
  const BoundaryEdge& edge = this->Boundary[b];
  const BoundaryEdge& next = this->Boundary[edge.Next];
  return { edge.LogLength + 0.5L * (u[edge.Origin] + u[next.Origin]),
    edge.LogCrossing + u[edge.Origin],
    next.LogCrossing + u[next.Origin] };
}

int IntrinsicTriangulation::addBoundaryEdge(const BoundaryEdge& edge)
{
  this->Boundary.push_back(edge);
  return static_cast<int>(this->Boundary.size()) - 1;
}

int IntrinsicTriangulation::addFace()
{
  if (!this->FreeFaces.empty())
  {
    const int f = this->FreeFaces.back();
    this->FreeFaces.pop_back();
    return f;
  }
  const int f = this->faceCount();
  this->Origins.resize(3 * f + 3);
  this->Twins.resize(3 * f + 3);
  this->LogLengths.resize(3 * f + 3);
  return f;
}

void IntrinsicTriangulation::removeFace(int f)
{
  std::fill_n(this->Origins.begin() + 3 * f, 3, -1);
  this->FreeFaces.push_back(f);
}

// Moves the last faces to the places of those that are no more.
void IntrinsicTriangulation::closeGaps()
{
  std::sort(this->FreeFaces.begin(), this->FreeFaces.end());
  int count = this->faceCount();
  for (const int gap : this->FreeFaces)
  {
    while (count > 0 && this->Origins[3 * (count - 1)] < 0)
    {
      --count;
    }
    if (gap >= count)
    {
      break;
    }
    const int last = --count;
    for (int k = 0; k < 3; ++k)
    {
      this->Origins[3 * gap + k] = this->Origins[3 * last + k];
      this->LogLengths[3 * gap + k] = this->LogLengths[3 * last + k];
      const int twin = this->Twins[3 * last + k];
      this->glue(3 * gap + k, twin >= 0 && twin / 3 == last ? 3 * gap + twin % 3 : twin);
    }
  }
  this->FreeFaces.clear();
  this->Origins.resize(3 * count);
  this->Twins.resize(3 * count);
  this->LogLengths.resize(3 * count);
  this->Outgoing.clear();
}

// Sides are half-edges, or -1 - b for boundary edge b.
void IntrinsicTriangulation::glue(int side, int otherSide)
{
  const auto set = [this](int from, int to)
  { (from >= 0 ? this->Twins[from] : this->Boundary[-1 - from].Inner) = to; };
  set(side, otherSide);
  set(otherSide, side);
}

void IntrinsicTriangulation::flip(int h, long double logLength)
{
  // Faces (a b c) and (b a d), h from a to b, become (c d b) and (d c a).
  const int t = this->Twins[h];
  const int slot[4] = { next(h), previous(h), next(t), previous(t) };    // bc, ca, ad, db
  const int newSlot[4] = { previous(h), next(t), previous(t), next(h) }; // where each of them goes
  int twins[4];
  int origins[4];
  long double lengths[4];
  for (int k = 0; k < 4; ++k)
  {
    twins[k] = this->Twins[slot[k]];
    origins[k] = this->Origins[slot[k]];
    lengths[k] = this->LogLengths[slot[k]];
    for (int j = 0; j < 4; ++j)
    {
      if (twins[k] == slot[j])
      {
        twins[k] = newSlot[j];
        break;
      }
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    this->Origins[newSlot[k]] = origins[k];
    this->LogLengths[newSlot[k]] = lengths[k];
    this->glue(newSlot[k], twins[k]);
  }
  this->Origins[h] = origins[1]; // c
  this->Origins[t] = origins[3]; // d
  this->LogLengths[h] = this->LogLengths[t] = logLength;
  this->Outgoing.clear();
}

// The face a b c on edge b, from a to b, is turned over the mirror: c comes to lie between a and b.
void IntrinsicTriangulation::openBoundaryEdge(int b, long double logCrossing)
{
  const int h = this->Boundary[b].Inner;
  const int bc = next(h);
  const int ca = previous(h);
  const int after = this->Boundary[b].Next;
  const int added = this->addBoundaryEdge({ this->Origins[ca],
    b,
    after,
    -1,
    this->LogLengths[bc],
    logCrossing,
    this->Boundary[b].AtInfinity });
  this->Boundary[b].Next = added;
  this->Boundary[b].LogLength = this->LogLengths[ca];
  this->Boundary[after].Previous = added;
  if (this->Twins[bc] == ca)
  {
    this->glue(-1 - b, -1 - added);
  }
  else
  {
    this->glue(-1 - b, this->Twins[ca]);
    this->glue(-1 - added, this->Twins[bc]);
  }
  this->removeFace(face(h));
}

// The inverse: the origin of edge b leaves the mirror, and a face fills its place. Returns that face.
int IntrinsicTriangulation::closeBoundaryVertex(int b, long double logAcross)
{
  const int before = this->Boundary[b].Previous;
  const int after = this->Boundary[b].Next;
  const int f = this->addFace();
  const int sides[2] = { -1 - b, -1 - before };
  const int inner[2] = { this->Boundary[b].Inner, this->Boundary[before].Inner };
  for (int k = 0; k < 2; ++k)
  {
    this->LogLengths[3 * f + 1 + k] = this->Boundary[-1 - sides[k]].LogLength;
    this->glue(3 * f + 1 + k, inner[k] == sides[1 - k] ? 3 * f + 2 - k : inner[k]);
  }
  this->Origins[3 * f] = this->Boundary[before].Origin;
  this->Origins[3 * f + 1] = this->Boundary[after].Origin;
  this->Origins[3 * f + 2] = this->Boundary[b].Origin;
  this->LogLengths[3 * f] = this->Boundary[before].LogLength = logAcross;
  this->glue(3 * f, -1 - before);
  this->Boundary[before].Next = after;
  this->Boundary[after].Previous = before;
  this->Boundary[b].Origin = -1;
  return f;
}

// Of the angles opposite to all half-edges, by one exponential per side: not to the last digit.
template <typename Metric>
std::vector<double> IntrinsicTriangulation::cosines(const Metric& metric) const
{
  std::vector<double> cosines(this->halfedgeCount());
  tbb::parallel_for(tbb::blocked_range<int>(0, this->faceCount(), HalfedgesPerTask / 3),
    [&](const tbb::blocked_range<int>& faces)
    {
      for (int f = faces.begin(); f < faces.end(); ++f)
      {
        double length[3];
        for (int k = 0; k < 3; ++k)
        {
          length[k] =
            std::exp(static_cast<double>(metric.logLength(3 * f + k) - metric.logLength(3 * f)));
        }
        for (int k = 0; k < 3; ++k)
        {
          const double a = length[k];
          const double b = length[(k + 1) % 3];
          const double c = length[(k + 2) % 3];
          cosines[3 * f + k] = ((b - a) * (b + a) + c * c) / (2.0 * b * c);
        }
      }
    });
  return cosines;
}

template <typename Metric>
int IntrinsicTriangulation::flipAll(const Metric& metric)
{
  std::vector<int> stack; // sides, as in glue()
  std::vector<char> queued(this->halfedgeCount(), 0);
  std::vector<char> boundaryQueued(this->Boundary.size(), 0);
  const auto mark = [&](int side) -> char&
  { return side >= 0 ? queued[side] : boundaryQueued[-1 - side]; };
  const auto push = [&](int side)
  {
    side = side < 0 ? side : std::min(side, this->Twins[side]);
    if (!mark(side))
    {
      mark(side) = 1;
      stack.push_back(side);
    }
  };
  const auto mayFlip = [&](int h)
  { return this->Origins[h] >= 0 && this->Twins[h] >= 0 && face(this->Twins[h]) != face(h); };
  const std::vector<double> cosines = this->cosines(metric);
  std::vector<char> mustFlip(this->halfedgeCount(), 0);
  tbb::parallel_for(tbb::blocked_range<int>(0, this->halfedgeCount(), HalfedgesPerTask),
    [&](const tbb::blocked_range<int>& halfedges)
    {
      for (int h = halfedges.begin(); h < halfedges.end(); ++h)
      {
        mustFlip[h] = this->Twins[h] > h &&
                      !(cosines[h] + cosines[this->Twins[h]] > CertainlyDelaunay) && mayFlip(h) &&
                      metric.mustFlip(h);
      }
    });
  for (int h = 0; h < this->halfedgeCount(); ++h)
  {
    if (mustFlip[h])
    {
      push(h);
    }
  }
  for (int b = 0; b < static_cast<int>(this->Boundary.size()); ++b)
  {
    if (this->Boundary[b].Origin >= 0 && (metric.mustClose(b) || metric.mustOpen(b)))
    {
      push(-1 - b);
    }
  }
  // Delaunay flips end by themselves; the bound only guards against rounding on degenerate metrics.
  const long long bound = 10LL * this->halfedgeCount() + 1000;
  long long flips = 0;
  while (!stack.empty() && flips < bound)
  {
    const int side = stack.back();
    stack.pop_back();
    mark(side) = 0;
    if (side >= 0 && mayFlip(side) && metric.mustFlip(side))
    {
      const int t = this->Twins[side];
      // Which half-edge stands for an edge may change with the slots: clear the marks of the four sides.
      const int sides[4] = { next(side), previous(side), next(t), previous(t) };
      for (const int s : sides)
      {
        mark(s) = 0;
        mark(this->Twins[s]) = 0;
      }
      this->flip(side, metric.flipped(side));
      ++flips;
      for (const int s : sides)
      {
        push(s);
      }
    }
    const int b = -1 - side;
    if (side >= 0 || this->Boundary[b].Origin < 0)
    {
      continue;
    }
    if (metric.mustClose(b))
    {
      const int before = this->Boundary[b].Previous;
      const int f = this->closeBoundaryVertex(b, metric.closed(b));
      queued.resize(this->halfedgeCount(), 0);
      ++flips;
      for (const int s : { 3 * f + 1, 3 * f + 2, -1 - before, -1 - this->Boundary[before].Next })
      {
        push(s);
      }
    }
    else if (metric.mustOpen(b))
    {
      this->openBoundaryEdge(b, metric.opened(b));
      boundaryQueued.resize(this->Boundary.size(), 0);
      ++flips;
      const int added = this->Boundary[b].Next;
      for (const int s : { -1 - b, -1 - added, -1 - this->Boundary[added].Next })
      {
        push(s);
      }
    }
  }
  this->closeGaps();
  return static_cast<int>(flips);
}

// Log-length of the other diagonal of the two triangles at h, unfolded into the plane.
long double IntrinsicTriangulation::otherDiagonal(int h) const
{
  const int t = this->Twins[h];
  const long double unit = this->LogLengths[h]; // edge h from (0,0) to (1,0)
  const auto apex = [&](int fromOrigin, int fromTip, double side)
  {
    const double p = std::exp(static_cast<double>(this->LogLengths[fromOrigin] - unit));
    const double q = std::exp(static_cast<double>(this->LogLengths[fromTip] - unit));
    const double x = 0.5 * (1.0 + (p - q) * (p + q));
    return Eigen::Vector2d(x, side * std::sqrt(std::max(0.0, (p - x) * (p + x))));
  };
  const Eigen::Vector2d c = apex(previous(h), next(h), 1.0);
  const Eigen::Vector2d d = apex(next(t), previous(t), -1.0);
  return unit + std::log((c - d).norm());
}

int IntrinsicTriangulation::flipToDelaunay()
{
  return this->flipAll(FlatMetric{ *this, [this](int h) { return this->otherDiagonal(h); } });
}

int IntrinsicTriangulation::flipDoubleToDelaunay()
{
  const Factors none = Factors::Zero(this->VertexCount);
  return this->flipAll(
    DoubledMetric{ { *this, none }, [this](int h) { return this->otherDiagonal(h); } });
}

int IntrinsicTriangulation::flipToDelaunay(const Factors& u)
{
  return this->flipAll(ConformalMetric{ *this, u });
}

IntrinsicTriangulation::Part IntrinsicTriangulation::part(const std::vector<int>& faces) const
{
  Part part{ IntrinsicTriangulation(), {}, faces, {} };
  IntrinsicTriangulation& copy = part.Triangulation;
  std::vector<int> localFace(this->faceCount(), -1);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    localFace[faces[i]] = static_cast<int>(i);
  }
  std::vector<int> localVertex(this->VertexCount, -1);
  for (const int f : faces)
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
    {
      int& vertex = localVertex[this->Origins[h]];
      if (vertex < 0)
      {
        vertex = static_cast<int>(part.Vertices.size());
        part.Vertices.push_back(this->Origins[h]);
      }
      copy.Origins.push_back(vertex);
      copy.LogLengths.push_back(this->LogLengths[h]);
    }
  }
  copy.VertexCount = static_cast<int>(part.Vertices.size());
  copy.Twins.resize(copy.Origins.size());
  for (int k = 0; k < copy.halfedgeCount(); ++k)
  {
    const int twin = this->Twins[3 * faces[face(k)] + k % 3];
    if (twin >= 0 && localFace[face(twin)] >= 0)
    {
      copy.Twins[k] = 3 * localFace[face(twin)] + twin % 3;
    }
    else
    {
      const int b =
        copy.addBoundaryEdge({ copy.Origins[k], -1, -1, k, copy.LogLengths[k], OnMirror, true });
      copy.Twins[k] = -1 - b;
      part.Outside.push_back(twin);
    }
  }
  return part;
}

void IntrinsicTriangulation::replace(const Part& part)
{
  const IntrinsicTriangulation& copy = part.Triangulation;
  const auto whole = [&part](int k) { return 3 * part.Faces[face(k)] + k % 3; };
  for (int k = 0; k < copy.halfedgeCount(); ++k)
  {
    const int h = whole(k);
    const int twin = copy.Twins[k];
    this->Origins[h] = part.Vertices[copy.Origins[k]];
    this->LogLengths[h] = copy.LogLengths[k];
    this->glue(h, twin >= 0 ? whole(twin) : part.Outside[-1 - twin]);
  }
  this->Outgoing.clear();
}

std::vector<int> IntrinsicTriangulation::outgoing(int vertex) const
{
  if (this->Outgoing.empty())
  {
    this->Outgoing.assign(this->VertexCount, -1);
    for (int h = 0; h < this->halfedgeCount(); ++h)
    {
      int& entry = this->Outgoing[this->Origins[h]];
      if (entry < 0 || this->Twins[h] < 0)
      {
        entry = h;
      }
    }
  }
  std::vector<int> halfedges;
  const int start = this->Outgoing[vertex];
  for (int h = start; h >= 0;)
  {
    halfedges.push_back(h);
    h = this->Twins[previous(h)];
    if (h == start)
    {
      break;
    }
  }
  return halfedges;
}

IntrinsicTriangulation::Star IntrinsicTriangulation::removeStar(int vertex)
{
  const std::vector<int> around = this->outgoing(vertex);
  const int out = -1 - this->Twins[around.front()];
  const int in = -1 - this->Twins[previous(around.back())];
  Star star;
  for (const int h : around)
  {
    star.Spokes.push_back({ this->tip(h), this->LogLengths[h] });
  }
  star.Spokes.push_back({ this->Boundary[in].Origin, this->Boundary[in].LogLength });
  star.FirstBoundaryEdge = this->Boundary[out].Next;

  int before = this->Boundary[in].Previous;
  for (auto h = around.rbegin(); h != around.rend(); ++h)
  {
    const int opposite = next(*h);
    const int added = this->addBoundaryEdge(
      { this->tip(opposite), before, -1, -1, this->LogLengths[opposite], OnMirror, true });
    this->glue(-1 - added, this->Twins[opposite]);
    this->Boundary[before].Next = added;
    this->removeFace(face(*h));
    before = added;
  }
  this->Boundary[before].Next = star.FirstBoundaryEdge;
  this->Boundary[star.FirstBoundaryEdge].Previous = before;
  this->Boundary[out].Origin = this->Boundary[in].Origin = -1;
  this->closeGaps();
  return star;
}

std::optional<IntrinsicTriangulation::Neighbour> IntrinsicTriangulation::reachInfinity(const Factors& u,
  const std::vector<char>& excluded)
{
  for (int b = 0; b < static_cast<int>(this->Boundary.size()); ++b)
  {
    const int h = this->Boundary[b].Inner;
    if (this->Boundary[b].Origin < 0 || !this->Boundary[b].AtInfinity || h < 0)
    {
      continue;
    }
    const int apex = this->origin(previous(h));
    const long double base = this->scaledLogLength(h, u);
    const double sides = std::exp(static_cast<double>(this->scaledLogLength(next(h), u) - base)) +
                         std::exp(static_cast<double>(this->scaledLogLength(previous(h), u) - base));
    if (sides <= 1.0 && !excluded[apex])
    {
      this->openBoundaryEdge(b, OnMirror);
      this->closeGaps();
      // Ptolemy's relation with the distances from infinity, of which those of the edge's ends are 1.
      return Neighbour{ apex, u[apex] - 2.0L * std::log(static_cast<long double>(sides)) };
    }
  }
  return {};
}

} // namespace flattening
