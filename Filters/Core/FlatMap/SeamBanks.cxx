// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/SeamBanks.h"

#include "Mesh/VertexFaces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// Two places on the map are the same if they are closer than this share of the longest side of their
// triangles. The value is between rounding and the distance of the two banks at the vertex before the
// end of a seam, which is as long as the sides there.
constexpr double SameOnMap = 1e-6;

// How far, in radii of the face around its centroid, a connection on the flattened surface may stray.
// Greater values cost time; with values near 1 a way through large triangles is missed.
constexpr double ConnectionReach = 2.0;

// The number of faces between two reports of progress, at which an abort is noticed.
constexpr int FacesPerReport = 1 << 14;

enum class Outcome : char
{
  Lost,       // a vertex is lost, or the centroid has no place
  AcrossSeam, // a corner lies beyond the seam
  Placed
};

struct PlacedFace
{
  Outcome Result = Outcome::Lost;
  /// The places of those corners that do not have the place of their vertex.
  std::array<std::optional<SurfacePoint>, 3> OtherBank;
};

/// Places on the map.
class MapPlaces
{
public:
  explicit MapPlaces(const FlattenedSurface& flattened)
    : Flattened(flattened)
  {
  }

  Eigen::RowVector2d position(const SurfacePoint& at) const
  {
    Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
    for (int k = 0; k < 3; ++k)
    {
      sum += at.Weights[k] * this->corner(at.Face, k);
    }
    return sum;
  }

  bool areSame(const SurfacePoint& a, const SurfacePoint& b) const
  {
    return (this->position(a) - this->position(b)).norm() <=
           SameOnMap * std::max(this->longestSide(a.Face), this->longestSide(b.Face));
  }

private:
  Eigen::RowVector2d corner(int face, int k) const
  {
    return this->Flattened.Positions.row(this->Flattened.Surface.Faces(face, k));
  }
  double longestSide(int face) const
  {
    return std::max({ (this->corner(face, 0) - this->corner(face, 1)).norm(),
      (this->corner(face, 1) - this->corner(face, 2)).norm(),
      (this->corner(face, 2) - this->corner(face, 0)).norm() });
  }

  const FlattenedSurface& Flattened;
};

/// Finds the bank on which a face lies.
class BankSearch
{
public:
  BankSearch(const FlattenedSurface& flattened,
    const TriangleMesh& target,
    const PlaceSearch& search,
    const TransferredMap& map)
    : Surface(flattened.Surface)
    , Target(target)
    , Search(search)
    , Map(map)
    , OnMap(flattened)
    , Around(flattened.Surface.Faces, flattened.Surface.vertexCount())
  {
  }

  PlacedFace place(int face) const;

private:
  std::optional<SurfacePoint> placeOfCentroid(int face, const Eigen::Vector3d& centroid) const;
  bool isConnected(int from, int to, const Eigen::Vector3d& centre, double radius) const;

  const TriangleMesh& Surface;
  const TriangleMesh& Target;
  const PlaceSearch& Search;
  const TransferredMap& Map;
  MapPlaces OnMap;
  VertexFaces Around;
};

// The place nearest to the centroid of those that are found from the whole surface and from the places
// of the corners; the last ones are on the right side where another fold is nearer.
std::optional<SurfacePoint> BankSearch::placeOfCentroid(int face, const Eigen::Vector3d& centroid) const
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    normal += this->Search.Normals.row(this->Target.Faces(face, k)).transpose();
  }
  std::optional<SurfacePoint> nearest;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const SurfacePoint& at)
  {
    const double distance = (at.Position - centroid).norm();
    if (distance < least && normal.dot(this->Search.Walk.normal(at)) > 0.0)
    {
      least = distance;
      nearest = at;
    }
  };
  offer(this->Search.Tree.closest(centroid));
  for (int k = 0; k < 3; ++k)
  {
    const SurfacePoint& corner = this->Map.Places[this->Target.Faces(face, k)];
    offer(this->Search.Walk.closest(centroid, corner.Face));
  }
  return nearest;
}

// Whether faces that share vertices lead from one face to another within a ball.
bool BankSearch::isConnected(int from, int to, const Eigen::Vector3d& centre, double radius) const
{
  std::set<int> found{ from };
  std::vector<int> open{ from };
  while (!open.empty() && found.count(to) == 0)
  {
    const int face = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k)
    {
      const int vertex = this->Surface.Faces(face, k);
      const Eigen::Vector3d corner = this->Surface.Vertices.row(vertex);
      if (face != from && (corner - centre).norm() > radius)
      {
        continue;
      }
      for (const int next : this->Around[vertex])
      {
        if (found.insert(next).second)
        {
          open.push_back(next);
        }
      }
    }
  }
  return found.count(to) > 0;
}

PlacedFace BankSearch::place(int face) const
{
  PlacedFace result;
  const Eigen::Matrix3d corners = faceCorners(this->Target, face);
  for (int k = 0; k < 3; ++k)
  {
    if (!this->Map.Survived[this->Target.Faces(face, k)])
    {
      return result;
    }
  }
  const Eigen::Vector3d centroid = corners.colwise().mean();
  const std::optional<SurfacePoint> middle = this->placeOfCentroid(face, centroid);
  if (!middle)
  {
    return result;
  }
  const double radius = (corners.rowwise() - centroid.transpose()).rowwise().norm().maxCoeff();
  // The way round the end of a seam is so short that it looks like a connection.
  result.Result = this->Search.Boundary.hasSeamEndIn(corners, this->Map.Tolerance) ? Outcome::AcrossSeam
                                                                                   : Outcome::Placed;
  for (int k = 0; k < 3 && result.Result == Outcome::Placed; ++k)
  {
    const SurfacePoint& own = this->Map.Places[this->Target.Faces(face, k)];
    const SurfacePoint at = this->Search.Walk.closest(corners.row(k), middle->Face);
    if (this->OnMap.areSame(at, own))
    {
      continue;
    }
    if ((at.Position - own.Position).norm() <= this->Search.SamePlace)
    {
      result.OtherBank[k] = at;
    }
    else if (!this->OnMap.areSame(this->Search.Walk.closest(centroid, own.Face), *middle) &&
             (this->Search.Boundary.partAt(at) == SurfaceBoundary::Part::Seam ||
               !this->isConnected(middle->Face, own.Face, centroid, ConnectionReach * radius)))
    {
      result.Result = Outcome::AcrossSeam;
    }
  }
  return result;
}

/// Collects the placed faces. A vertex has its own position and those on other banks.
class PartOnMap
{
public:
  PartOnMap(const FlattenedSurface& flattened, const TriangleMesh& target, TransferredMap& map)
    : Target(target)
    , Map(map)
    , OnMap(flattened)
  {
  }

  void add(int face, const PlacedFace& placed);
  void finish();

private:
  int copyAt(int vertex, const SurfacePoint& at);

  const TriangleMesh& Target;
  TransferredMap& Map;
  MapPlaces OnMap;
  std::map<int, std::vector<SurfacePoint>> OtherBanks; // of vertices on seams
  std::vector<int> Faces;
  std::vector<std::array<int, 3>> Copies; // for each face; 0: the vertex' own position
};

int PartOnMap::copyAt(int vertex, const SurfacePoint& at)
{
  std::vector<SurfacePoint>& others = this->OtherBanks[vertex];
  const auto known = std::find_if(others.begin(),
    others.end(),
    [this, &at](const SurfacePoint& other) { return this->OnMap.areSame(at, other); });
  if (known != others.end())
  {
    return static_cast<int>(known - others.begin()) + 1;
  }
  others.push_back(at);
  return static_cast<int>(others.size());
}

void PartOnMap::add(int face, const PlacedFace& placed)
{
  this->Map.FacesAcrossSeams += placed.Result == Outcome::AcrossSeam;
  if (placed.Result != Outcome::Placed)
  {
    return;
  }
  std::array<int, 3> copies{};
  for (int k = 0; k < 3; ++k)
  {
    if (placed.OtherBank[k])
    {
      copies[k] = this->copyAt(this->Target.Faces(face, k), *placed.OtherBank[k]);
    }
  }
  this->Faces.push_back(face);
  this->Copies.push_back(copies);
}

void PartOnMap::finish()
{
  const int vertexCount = this->Target.vertexCount();
  std::vector<int> first(vertexCount + 1, 0); // where the copies of each vertex begin
  for (int v = 0; v < vertexCount; ++v)
  {
    const auto others = this->OtherBanks.find(v);
    first[v + 1] =
      first[v] + 1 + (others == this->OtherBanks.end() ? 0 : static_cast<int>(others->second.size()));
  }
  DerivedMesh& part = this->Map.Part;
  part.Faces = this->Faces;
  part.Mesh.Faces.resize(static_cast<Eigen::Index>(this->Faces.size()), 3);
  std::vector<int> index(first.back(), -1);
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int copy = first[this->Target.Faces(this->Faces[f], k)] + this->Copies[f][k];
      part.Mesh.Faces(static_cast<Eigen::Index>(f), k) = copy;
      index[copy] = 0;
    }
  }

  std::vector<int> original;
  std::vector<Eigen::RowVector2d> positions;
  for (int v = 0; v < vertexCount; ++v)
  {
    const std::size_t before = original.size();
    for (int copy = first[v]; copy < first[v + 1]; ++copy)
    {
      if (index[copy] == 0)
      {
        index[copy] = static_cast<int>(original.size());
        original.push_back(v);
        positions.emplace_back(copy == first[v]
                                 ? Eigen::RowVector2d(this->Map.Positions.row(v))
                                 : this->OnMap.position(this->OtherBanks[v][copy - first[v] - 1]));
      }
    }
    this->Map.KeptVertices += original.size() > before;
    this->Map.RepeatedVertices += original.size() > before + 1;
  }
  part.Mesh.Faces = part.Mesh.Faces.unaryExpr([&index](int copy) { return index[copy]; }).eval();
  part.Vertices = keptVertices(original, vertexCount);
  part.Mesh.Vertices.resize(static_cast<Eigen::Index>(original.size()), 3);
  this->Map.PartPositions.resize(static_cast<Eigen::Index>(original.size()), 2);
  for (std::size_t v = 0; v < original.size(); ++v)
  {
    part.Mesh.Vertices.row(static_cast<Eigen::Index>(v)) = this->Target.Vertices.row(original[v]);
    this->Map.PartPositions.row(static_cast<Eigen::Index>(v)) = positions[v];
  }
}

} // namespace

void placeFaces(const FlattenedSurface& flattened,
  const TriangleMesh& target,
  const PlaceSearch& search,
  TransferredMap& map,
  const ProgressCallback& progress)
{
  std::optional<BankSearch> banks;
  if (search.Boundary.hasSeams())
  {
    banks.emplace(flattened, target, search, map);
  }
  PartOnMap part(flattened, target, map);
  std::vector<PlacedFace> placed;
  for (int begin = 0; begin < target.faceCount(); begin += FacesPerReport)
  {
    report(progress, static_cast<double>(begin) / target.faceCount(), "Transferring the faces");
    const int end = std::min(begin + FacesPerReport, target.faceCount());
    placed.assign(end - begin, {});
    tbb::parallel_for(begin,
      end,
      [&](int f)
      {
        if (banks)
        {
          placed[f - begin] = banks->place(f);
        }
        else if (map.Survived[target.Faces(f, 0)] && map.Survived[target.Faces(f, 1)] &&
                 map.Survived[target.Faces(f, 2)])
        {
          placed[f - begin].Result = Outcome::Placed;
        }
      });
    for (int f = begin; f < end; ++f)
    {
      part.add(f, placed[f - begin]);
    }
  }
  part.finish();
}

} // namespace flattening
