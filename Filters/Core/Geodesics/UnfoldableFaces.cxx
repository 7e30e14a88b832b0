// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/UnfoldableFaces.h"

#include "Mesh/DisjointSets.h"
#include "Mesh/FaceSides.h"
#include "Mesh/Halfedges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace flattening
{
namespace
{

// A shortest path bends only at a place around which there is more than a full angle (radians), or on
// the boundary more than half of one. A smaller excess is rounding: a path that should bend by so
// little is as long as one that misses the place by so little, to 1e-18 of its length.
constexpr double RoundingOfAngle = 1e-9;

constexpr double HalfAngle = EIGEN_PI;

// A half-edge of the boundary with its two ends, in the order of their coordinates.
struct BoundaryEdge
{
  const double* Low;
  const double* High;
  int Halfedge;
  bool Ascending; // whether the half-edge runs from Low to High

  bool liesOn(const BoundaryEdge& other) const
  {
    return std::equal(this->Low, this->Low + 3, other.Low) &&
           std::equal(this->High, this->High + 3, other.High);
  }
  bool operator<(const BoundaryEdge& other) const
  {
    const auto key = [](const BoundaryEdge& edge)
    {
      return std::make_tuple(
        edge.Low[0], edge.Low[1], edge.Low[2], edge.High[0], edge.High[1], edge.High[2], edge.Halfedge);
    };
    return key(*this) < key(other);
  }
};

std::vector<BoundaryEdge> sortedBoundary(const TriangleMesh& mesh, const std::vector<int>& opposite)
{
  std::vector<BoundaryEdge> edges;
  for (int h = 0; h < static_cast<int>(opposite.size()); ++h)
  {
    if (opposite[h] < 0)
    {
      const double* from = mesh.Vertices.row(mesh.Faces(h / 3, h % 3)).data();
      const int n = nextHalfedge(h);
      const double* to = mesh.Vertices.row(mesh.Faces(n / 3, n % 3)).data();
      const bool ascending = !std::lexicographical_compare(to, to + 3, from, from + 3);
      edges.push_back({ ascending ? from : to, ascending ? to : from, h, ascending });
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Joins pairs of half-edges of the boundary that lie on each other in opposite directions, and their
// ends. More than two in one place belong to sheets that only touch, and stay apart.
void closeSeams(const TriangleMesh& mesh, std::vector<int>& opposite, DisjointSets& places)
{
  const auto endOf = [&mesh](int h) { return mesh.Faces(h / 3, h % 3); };
  const std::vector<BoundaryEdge> edges = sortedBoundary(mesh, opposite);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end)
  {
    const BoundaryEdge& first = edges[begin];
    while (end < edges.size() && edges[end].liesOn(first))
    {
      ++end;
    }
    if (end - begin == 2 && edges[begin + 1].Ascending != first.Ascending)
    {
      const int h = first.Halfedge;
      const int other = edges[begin + 1].Halfedge;
      opposite[h] = other;
      opposite[other] = h;
      places.join(endOf(h), endOf(nextHalfedge(other)));
      places.join(endOf(nextHalfedge(h)), endOf(other));
    }
  }
}

// Numbers the sets of vertices in the order of their first vertices.
std::vector<int> numbered(DisjointSets& sets, int vertexCount)
{
  std::vector<int> numberOf(vertexCount, -1);
  std::vector<int> result(vertexCount);
  int count = 0;
  for (int v = 0; v < vertexCount; ++v)
  {
    int& number = numberOf[sets.find(v)];
    if (number < 0)
    {
      number = count++;
    }
    result[v] = number;
  }
  return result;
}

PlanarSide planarSide(const TriangleMesh& mesh, int h)
{
  const auto corner = [&mesh](int halfedge) -> Eigen::Vector3d
  { return mesh.Vertices.row(mesh.Faces(halfedge / 3, halfedge % 3)); };
  const Eigen::Vector3d along = corner(nextHalfedge(h)) - corner(h);
  const Eigen::Vector3d toApex = corner(previousHalfedge(h)) - corner(h);
  const double length = along.norm();
  if (!(length > 0.0))
  {
    return { 0.0, toApex.norm(), 0.0 };
  }
  return { length, along.dot(toApex) / length, along.cross(toApex).norm() / length };
}

// The faces around each place that one turn around it meets, from one of its half-edges.
int cornersOfFan(const std::vector<int>& opposite, int start)
{
  int count = 1;
  for (int h = opposite[previousHalfedge(start)]; h != start; h = opposite[previousHalfedge(h)])
  {
    if (h < 0)
    {
      // The boundary: the rest of the fan lies the other way round.
      for (int other = opposite[start]; other >= 0; other = opposite[nextHalfedge(other)])
      {
        ++count;
      }
      return count;
    }
    ++count;
  }
  return count;
}

// Whether a shortest path may bend at a place.
bool bendsAt(const UnfoldableFaces& faces, int place)
{
  const int begin = faces.CornerStarts[place];
  const int end = faces.CornerStarts[place + 1];
  double angle = 0.0;
  bool onBoundary = false;
  for (int c = begin; c < end; ++c)
  {
    const int h = faces.Corners[c];
    angle += std::atan2(faces.Sides[h].ApexY, faces.Sides[h].ApexX);
    onBoundary = onBoundary || faces.Opposite[h] < 0;
  }
  if (begin < end && cornersOfFan(faces.Opposite, faces.Corners[begin]) < end - begin)
  {
    return true; // parts that meet only here
  }
  return angle > (onBoundary ? HalfAngle : 2.0 * HalfAngle) + RoundingOfAngle;
}

} // namespace

UnfoldableFaces::UnfoldableFaces(const TriangleMesh& mesh, Seams seams)
  : Origin(3 * mesh.faceCount())
  , Opposite(oppositeHalfedges(mesh.Faces))
  , Sides(3 * mesh.faceCount())
{
  DisjointSets sets(mesh.vertexCount());
  if (seams == Seams::Closed)
  {
    const std::vector<int> before = this->Opposite;
    closeSeams(mesh, this->Opposite, sets);
    this->HasClosedSeams = before != this->Opposite;
  }
  this->PlaceOf = numbered(sets, mesh.vertexCount());
  const int count =
    this->PlaceOf.empty() ? 0 : 1 + *std::max_element(this->PlaceOf.begin(), this->PlaceOf.end());

  this->CornerStarts.assign(count + 1, 0);
  for (int h = 0; h < this->halfedgeCount(); ++h)
  {
    this->Origin[h] = this->PlaceOf[mesh.Faces(h / 3, h % 3)];
    this->Sides[h] = planarSide(mesh, h);
    this->MeanLength += this->Sides[h].Length / this->halfedgeCount();
    ++this->CornerStarts[this->Origin[h] + 1];
  }
  std::partial_sum(this->CornerStarts.begin(), this->CornerStarts.end(), this->CornerStarts.begin());
  this->Corners.resize(this->Origin.size());
  std::vector<int> next(this->CornerStarts.begin(), this->CornerStarts.end() - 1);
  for (int h = 0; h < this->halfedgeCount(); ++h)
  {
    this->Corners[next[this->Origin[h]]++] = h;
  }

  this->Bends.resize(count);
  for (int place = 0; place < count; ++place)
  {
    this->Bends[place] = bendsAt(*this, place);
  }
}

} // namespace flattening
