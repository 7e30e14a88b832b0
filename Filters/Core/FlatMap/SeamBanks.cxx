// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/SeamBanks.h"

#include "FlatMap/BankSearch.h"
#include "FlatMap/MapPlaces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

namespace flattening
{
namespace
{

// The number of faces between two reports of progress, at which an abort is noticed.
constexpr int FacesPerReport = 1 << 14;

/// Collects the placed faces. A vertex has its own position and those on other banks.
class PartOnMap
{
public:
  PartOnMap(const FlattenedSurface& flattened, const TriangleMesh& target, TransferredMap& map)
    : Surface(flattened.Surface)
    , Target(target)
    , Map(map)
    , OnMap(flattened)
    , Copies(target.faceCount())
  {
  }

  /// A face that the flattened surface has, too. All of these come before the others.
  void addShared(int face, const SharedFace& shared);
  void add(int face, const PlacedFace& placed);
  void finish();

private:
  template <typename AreSame>
  int copyAt(int vertex, const SurfacePoint& at, const AreSame& areSame);

  const TriangleMesh& Surface;
  const TriangleMesh& Target;
  TransferredMap& Map;
  MapPlaces OnMap;
  std::map<int, std::vector<SurfacePoint>> OtherBanks; // of vertices on seams
  // For each face of the target that is placed, the copies of its vertices; 0: a vertex' own position.
  std::vector<std::optional<std::array<int, 3>>> Copies;
};

template <typename AreSame>
int PartOnMap::copyAt(int vertex, const SurfacePoint& at, const AreSame& areSame)
{
  std::vector<SurfacePoint>& others = this->OtherBanks[vertex];
  const auto known = std::find_if(
    others.begin(), others.end(), [&](const SurfacePoint& other) { return areSame(at, other); });
  if (known != others.end())
  {
    return static_cast<int>(known - others.begin()) + 1;
  }
  others.push_back(at);
  return static_cast<int>(others.size());
}

void PartOnMap::addShared(int face, const SharedFace& shared)
{
  std::array<int, 3> copies{};
  for (int k = 0; k < 3; ++k)
  {
    const int vertex = this->Target.Faces(face, k);
    const SurfacePoint at = cornerOf(this->Surface, shared, k);
    const auto areEqual = [this](const SurfacePoint& a, const SurfacePoint& b)
    { return this->OnMap.areEqual(a, b); };
    if (!areEqual(at, this->Map.Places[vertex]))
    {
      copies[k] = this->copyAt(vertex, at, areEqual);
    }
  }
  this->Copies[face] = copies;
}

void PartOnMap::add(int face, const PlacedFace& placed)
{
  this->Map.FacesAcrossSeams += placed.Result == PlacedAs::AcrossSeam;
  if (placed.Result != PlacedAs::Placed)
  {
    return;
  }
  std::array<int, 3> copies{};
  for (int k = 0; k < 3; ++k)
  {
    if (placed.OtherBank[k])
    {
      copies[k] = this->copyAt(this->Target.Faces(face, k),
        *placed.OtherBank[k],
        [this](const SurfacePoint& a, const SurfacePoint& b) { return this->OnMap.areSame(a, b); });
    }
  }
  this->Copies[face] = copies;
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
  for (int face = 0; face < this->Target.faceCount(); ++face)
  {
    if (this->Copies[face])
    {
      part.Faces.push_back(face);
    }
  }
  part.Mesh.Faces.resize(static_cast<Eigen::Index>(part.Faces.size()), 3);
  std::vector<int> index(first.back(), -1);
  for (std::size_t f = 0; f < part.Faces.size(); ++f)
  {
    const int face = part.Faces[f];
    for (int k = 0; k < 3; ++k)
    {
      const int copy = first[this->Target.Faces(face, k)] + (*this->Copies[face])[k];
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
  for (int f = 0; f < target.faceCount(); ++f)
  {
    if (search.Shared[f].Face >= 0)
    {
      part.addShared(f, search.Shared[f]);
    }
  }
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
        if (search.Shared[f].Face >= 0)
        {
          return;
        }
        if (banks)
        {
          placed[f - begin] = banks->place(f);
        }
        else if (map.Survived[target.Faces(f, 0)] && map.Survived[target.Faces(f, 1)] &&
                 map.Survived[target.Faces(f, 2)])
        {
          placed[f - begin].Result = PlacedAs::Placed;
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
