// SPDX-License-Identifier: GPL-3.0-or-later
#include "IntrinsicTriangulation.h"

#include "Errors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{

// Cosine of the angle opposite to the side of length exp(opposite); outside [-1, 1] where the triangle
// inequality fails.
double cosineOpposite(long double opposite, long double left, long double right)
{
  const double x = std::exp(static_cast<double>(left - opposite));
  const double y = std::exp(static_cast<double>(right - opposite));
  return (x * x + y * y - 1.0) / (2.0 * x * y);
}

constexpr double FlipTolerance = 1e-12;

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
  std::sort(keyed.begin(), keyed.end());
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
  const double slack = 1e-10 * total / count;
  for (int h = 0; h < count; ++h)
  {
    const double excess = lengths[next(h)] + lengths[previous(h)] - lengths[h];
    this->AddedLength = std::max(this->AddedLength, slack - excess);
  }
  this->LogLengths.resize(count);
  for (int h = 0; h < count; ++h)
  {
    this->LogLengths[h] = std::log(lengths[h] + this->AddedLength);
  }
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
    this->Twins[newSlot[k]] = twins[k];
    if (twins[k] >= 0)
    {
      this->Twins[twins[k]] = newSlot[k];
    }
    this->Origins[newSlot[k]] = origins[k];
    this->LogLengths[newSlot[k]] = lengths[k];
  }
  this->Origins[h] = origins[1]; // c
  this->Origins[t] = origins[3]; // d
  this->LogLengths[h] = this->LogLengths[t] = logLength;
  this->Outgoing.clear();
}

template <typename ShouldFlip, typename NewLogLength>
int IntrinsicTriangulation::flipAll(ShouldFlip&& shouldFlip, NewLogLength&& newLogLength)
{
  std::vector<int> stack;
  std::vector<char> queued(this->halfedgeCount(), 0);
  const auto push = [&](int h)
  {
    const int t = this->Twins[h];
    if (t < 0)
    {
      return;
    }
    h = std::min(h, t);
    if (!queued[h])
    {
      queued[h] = 1;
      stack.push_back(h);
    }
  };
  for (int h = 0; h < this->halfedgeCount(); ++h)
  {
    const int t = this->Twins[h];
    if (t > h && this->face(t) != this->face(h) && shouldFlip(h))
    {
      push(h);
    }
  }
  // Delaunay flips end by themselves; the bound only guards against rounding on degenerate metrics.
  const long long bound = 10LL * this->halfedgeCount();
  long long flips = 0;
  while (!stack.empty() && flips < bound)
  {
    const int h = stack.back();
    stack.pop_back();
    queued[h] = 0;
    const int t = this->Twins[h];
    if (t < 0 || this->face(t) == this->face(h) || !shouldFlip(h))
    {
      continue;
    }
    // Which half-edge stands for an edge may change with the slots: clear the marks of the four sides.
    for (const int side : { next(h), previous(h), next(t), previous(t) })
    {
      queued[side] = 0;
      if (this->Twins[side] >= 0)
      {
        queued[this->Twins[side]] = 0;
      }
    }
    this->flip(h, newLogLength(h));
    ++flips;
    for (const int side : { next(h), previous(h), next(t), previous(t) })
    {
      push(side);
    }
  }
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
  const auto cosine = [this](int h)
  {
    return cosineOpposite(this->LogLengths[h], this->LogLengths[next(h)], this->LogLengths[previous(h)]);
  };
  return this->flipAll([&](int h) { return cosine(h) + cosine(this->Twins[h]) < -FlipTolerance; },
    [&](int h) { return this->otherDiagonal(h); });
}

void IntrinsicTriangulation::growStar(int vertex, const std::vector<char>& onBoundary, double slack)
{
  const auto opposite = [this](int h)
  {
    return triangleAngles(this->LogLengths[h], this->LogLengths[next(h)], this->LogLengths[previous(h)])
      .Angle[0];
  };
  for (bool flipped = true; flipped;)
  {
    flipped = false;
    const std::vector<int> around = this->outgoing(vertex);
    for (const int spoke : around)
    {
      const int h = next(spoke);
      const int t = this->Twins[h];
      const int apex = t < 0 ? -1 : this->Origins[previous(t)];
      const bool known =
        apex < 0 || apex == vertex || onBoundary[apex] ||
        std::any_of(around.begin(), around.end(), [&](int s) { return this->tip(s) == apex; });
      if (!known && opposite(h) + opposite(t) > EIGEN_PI - slack)
      {
        this->flip(h, this->otherDiagonal(h));
        flipped = true;
        break;
      }
    }
  }
}

int IntrinsicTriangulation::flipToDelaunay(const Factors& u)
{
  const auto cosine = [&](int h)
  {
    return cosineOpposite(this->scaledLogLength(h, u),
      this->scaledLogLength(next(h), u),
      this->scaledLogLength(previous(h), u));
  };
  return this->flipAll([&](int h) { return cosine(h) + cosine(this->Twins[h]) < -FlipTolerance; },
    [&](int h)
    {
      const int t = this->Twins[h];
      const long double x = this->LogLengths[previous(h)] + this->LogLengths[previous(t)]; // ca + db
      const long double y = this->LogLengths[next(h)] + this->LogLengths[next(t)];         // bc + ad
      return std::max(x, y) + std::log1p(std::exp(static_cast<double>(-std::abs(x - y)))) -
             this->LogLengths[h];
    });
}

int IntrinsicTriangulation::splitBoundaryEdge(int h)
{
  // Face (a b c), boundary edge ab, becomes (a f c) and (f b c), f the foot of the altitude from c or
  // near it.
  const int bc = next(h);
  const int ca = previous(h);
  const int b = this->Origins[bc];
  const int c = this->Origins[ca];
  const long double unit = this->LogLengths[h];
  const double p = std::exp(static_cast<double>(this->LogLengths[ca] - unit));
  const double q = std::exp(static_cast<double>(this->LogLengths[bc] - unit));
  const double foot = 0.5 * (1.0 + (p - q) * (p + q));
  const double x = std::clamp(foot, 0.2, 0.8);
  const double altitude = std::sqrt(std::max(0.0, (p - foot) * (p + foot)));
  const long double logMedian = unit + std::log(std::hypot(altitude, foot - x));

  const int f = this->VertexCount++;
  const int n = this->halfedgeCount();
  const int bcTwin = this->Twins[bc];
  const long double bcLength = this->LogLengths[bc];
  this->Origins[bc] = f; // the old face: a f, f c, c a
  this->LogLengths[h] = unit + std::log(x);
  this->LogLengths[bc] = logMedian;
  this->Twins[bc] = n + 2;
  const int origins[3] = { f, b, c };
  const long double lengths[3] = { unit + std::log1p(-x), bcLength, logMedian };
  const int twins[3] = { -1, bcTwin, bc };
  this->Origins.insert(this->Origins.end(), origins, origins + 3);
  this->LogLengths.insert(this->LogLengths.end(), lengths, lengths + 3);
  this->Twins.insert(this->Twins.end(), twins, twins + 3);
  if (bcTwin >= 0)
  {
    this->Twins[bcTwin] = n + 1;
  }
  this->Outgoing.clear();
  return f;
}

std::vector<IntrinsicTriangulation::BoundarySplit> IntrinsicTriangulation::splitBoundaryEdges(
  double largestAngle,
  int maximumRounds)
{
  const double smallestCosine = std::cos(largestAngle) - 1e-9;
  std::vector<BoundarySplit> splits;
  for (int round = 0; round < maximumRounds; ++round)
  {
    const int before = this->halfedgeCount();
    std::vector<char> onBoundary(this->VertexCount, 0);
    for (int h = 0; h < before; ++h)
    {
      onBoundary[this->origin(h)] |= this->Twins[h] < 0;
    }
    for (int h = 0; h < before; ++h)
    {
      const int apex = this->origin(previous(h));
      const bool isInner = apex < static_cast<int>(onBoundary.size()) && !onBoundary[apex];
      if (this->Twins[h] < 0 && isInner &&
          cosineOpposite(this->LogLengths[h], this->LogLengths[next(h)], this->LogLengths[previous(h)]) <
            smallestCosine)
      {
        const int from = this->origin(h);
        const int to = this->tip(h);
        const long double length = this->LogLengths[h];
        this->splitBoundaryEdge(h);
        splits.push_back({ from, to, std::exp(static_cast<double>(this->LogLengths[h] - length)) });
      }
    }
    if (this->halfedgeCount() == before)
    {
      break;
    }
    this->flipToDelaunay();
  }
  return splits;
}

const std::vector<int>& IntrinsicTriangulation::anyOutgoing() const
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
  return this->Outgoing;
}

std::vector<int> IntrinsicTriangulation::outgoing(int vertex) const
{
  std::vector<int> halfedges;
  const int start = this->anyOutgoing()[vertex];
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

std::vector<IntrinsicTriangulation::Spoke> IntrinsicTriangulation::removeStar(int vertex)
{
  const std::vector<int> around = this->outgoing(vertex);
  std::vector<Spoke> link;
  std::vector<char> removed(this->faceCount(), 0);
  for (const int h : around)
  {
    link.push_back({ this->tip(h), this->LogLengths[h] });
    removed[this->face(h)] = 1;
  }
  if (!around.empty() && this->Twins[previous(around.back())] < 0)
  {
    const int last = previous(around.back());
    link.push_back({ this->Origins[last], this->LogLengths[last] });
  }

  std::vector<int> newFace(this->faceCount(), -1);
  int kept = 0;
  for (int f = 0; f < this->faceCount(); ++f)
  {
    if (!removed[f])
    {
      newFace[f] = kept++;
    }
  }
  for (int f = 0; f < static_cast<int>(newFace.size()); ++f)
  {
    const int g = newFace[f];
    for (int k = 0; g >= 0 && k < 3; ++k)
    {
      const int t = this->Twins[3 * f + k];
      const int twinFace = t < 0 ? -1 : newFace[t / 3];
      this->Twins[3 * g + k] = twinFace < 0 ? -1 : 3 * twinFace + t % 3;
      this->Origins[3 * g + k] = this->Origins[3 * f + k];
      this->LogLengths[3 * g + k] = this->LogLengths[3 * f + k];
    }
  }
  this->Origins.resize(3 * kept);
  this->Twins.resize(3 * kept);
  this->LogLengths.resize(3 * kept);
  this->Outgoing.clear();
  return link;
}

TriangleAngles triangleAngles(long double logA, long double logB, long double logC)
{
  const long double log[3] = { logA, logB, logC };
  const long double unit = std::max({ logA, logB, logC });
  double side[3];
  for (int k = 0; k < 3; ++k)
  {
    side[k] = std::exp(static_cast<double>(log[k] - unit));
  }
  // How far the sum of the other two sides exceeds side k, with the nearly equal pair of a needle
  // subtracted as logarithms.
  double excess[3];
  for (int k = 0; k < 3; ++k)
  {
    int near = (k + 1) % 3;
    int other = (k + 2) % 3;
    if (std::abs(log[other] - log[k]) < std::abs(log[near] - log[k]))
    {
      std::swap(near, other);
    }
    excess[k] = side[other] - side[near] * std::expm1(static_cast<double>(log[k] - log[near]));
  }
  TriangleAngles result;
  result.Degenerate = false;
  for (int k = 0; k < 3; ++k)
  {
    if (!(excess[k] > 0.0))
    {
      result.Degenerate = true;
      for (int j = 0; j < 3; ++j)
      {
        result.Angle[j] = j == k ? EIGEN_PI : 0.0;
        result.Cotangent[j] = 0.0;
      }
      return result;
    }
  }
  const double perimeter = side[0] + side[1] + side[2];
  const double fourArea = std::sqrt(perimeter * excess[0] * excess[1] * excess[2]);
  for (int k = 0; k < 3; ++k)
  {
    const double b = excess[(k + 1) % 3];
    const double c = excess[(k + 2) % 3];
    result.Angle[k] = 2.0 * std::atan2(std::sqrt(b * c), std::sqrt(perimeter * excess[k]));
    const double l = side[(k + 1) % 3];
    const double r = side[(k + 2) % 3];
    result.Cotangent[k] = (l * l + r * r - side[k] * side[k]) / fourArea;
  }
  return result;
}

} // namespace flattening
