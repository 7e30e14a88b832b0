// SPDX-License-Identifier: GPL-3.0-or-later
#include "Intrinsic/IntrinsicTriangulation.h"

#include "Mesh/FaceSides.h"
#include "Mesh/SliverThresholds.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{

// Lengths whose logarithms one parallel task computes. Results do not depend on it.
constexpr int LogarithmsPerTask = 4096;

} // namespace

IntrinsicTriangulation::IntrinsicTriangulation(const TriangleMesh& mesh)
  : VertexCount(mesh.vertexCount())
{
  const int count = 3 * mesh.faceCount();
  this->Origins.resize(count);
  this->Twins = oppositeHalfedges(mesh.Faces);
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
  const double slack = slivers::IntrinsicExcess * total / count;
  const double shortest = slivers::IntrinsicEdge * total / count;
  for (int h = 0; h < count; ++h)
  {
    const double excess = lengths[next(h)] + lengths[previous(h)] - lengths[h];
    this->AddedLength = std::max({ this->AddedLength, slack - excess, shortest - lengths[h] });
  }
  this->LogLengths.resize(count);
  tbb::parallel_for(tbb::blocked_range<int>(0, count, LogarithmsPerTask),
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

SymmetricTrapezoid IntrinsicTriangulation::scaledTrapezoid(int b, const Factors& u) const
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

// Moves the last faces into the rows of the removed ones.
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

// Makes two sides neighbours. A side is a half-edge, or -1 - b for boundary edge b.
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

// Flips boundary edge b, from p to q, and its image: the face p q r there is removed, and r comes to lie
// on the mirror between p and q.
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

// The inverse of openBoundaryEdge(): the origin of edge b leaves the mirror, and a new face, which is
// returned, has it as its third corner.
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

} // namespace flattening
