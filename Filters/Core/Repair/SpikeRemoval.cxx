// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/SpikeRemoval.h"

#include "Mesh/SelfIntersections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

constexpr std::size_t MostVertices = 20; // a fin of one voxel; larger sheets are part of the object
constexpr double SteepRatio = 0.5;       // the ends of a fin, which would become spikes without it
constexpr int Sweeps = 100;

// Sum of area vectors and of areas.
struct Star
{
  Eigen::Vector3d Vector = Eigen::Vector3d::Zero();
  double Area = 0.0;

  void add(const Eigen::Vector3d& face)
  {
    this->Vector += face;
    this->Area += face.norm();
  }
  // A star without area is left to the repair of faces.
  double ratio() const { return this->Area > 0.0 ? this->Vector.norm() / this->Area : 1.0; }
};

Eigen::Vector3d areaVector(const Points3& points, const FaceMatrix& faces, int f)
{
  const Eigen::RowVector3d a = points.row(faces(f, 0));
  const Eigen::Vector3d u = points.row(faces(f, 1)) - a;
  const Eigen::Vector3d v = points.row(faces(f, 2)) - a;
  return 0.5 * u.cross(v);
}

std::vector<int> sortedOnce(std::vector<int> values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::vector<int> steepVertices(const TriangleMesh& mesh)
{
  std::vector<Star> stars(mesh.vertexCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const Eigen::Vector3d face = areaVector(mesh.Vertices, mesh.Faces, f);
    for (int k = 0; k < 3; ++k)
    {
      stars[mesh.Faces(f, k)].add(face);
    }
  }
  std::vector<int> steep;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (stars[v].ratio() < SteepRatio)
    {
      steep.push_back(v);
    }
  }
  return steep;
}

// The faces around some of the vertices, and their neighbours.
class Stars
{
public:
  Stars(const TriangleMesh& mesh, const std::vector<int>& vertices)
    : Mesh(mesh)
    , Place(mesh.vertexCount(), -1)
    , Faces(vertices.size())
  {
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      this->Place[vertices[i]] = static_cast<int>(i);
    }
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int place = this->Place[mesh.Faces(f, k)];
        if (place >= 0)
        {
          this->Faces[place].push_back(f);
        }
      }
    }
  }

  const std::vector<int>& faces(int v) const { return this->Faces[this->Place[v]]; }

  std::vector<int> neighbours(int v) const { return sortedOnce(this->corners(v)); }

  // Every neighbour is met in two faces.
  bool isInner(int v) const { return this->corners(v).size() == 2 * this->neighbours(v).size(); }

  double ratio(int v) const
  {
    Star star;
    for (const int f : this->faces(v))
    {
      star.add(areaVector(this->Mesh.Vertices, this->Mesh.Faces, f));
    }
    return star.ratio();
  }

private:
  std::vector<int> corners(int v) const
  {
    std::vector<int> result;
    for (const int f : this->faces(v))
    {
      for (int k = 0; k < 3; ++k)
      {
        if (this->Mesh.Faces(f, k) != v)
        {
          result.push_back(this->Mesh.Faces(f, k));
        }
      }
    }
    return result;
  }

  const TriangleMesh& Mesh;
  std::vector<int> Place; // -1 for other vertices
  std::vector<std::vector<int>> Faces;
};

// Connected sets of the vertices (sorted), each sorted.
std::vector<std::vector<int>> connectedSets(const std::vector<int>& vertices, const Stars& stars)
{
  std::vector<char> reached(vertices.size(), 0);
  std::vector<std::vector<int>> sets;
  for (std::size_t first = 0; first < vertices.size(); ++first)
  {
    if (reached[first])
    {
      continue;
    }
    reached[first] = 1;
    std::vector<int> set{ vertices[first] };
    for (std::size_t i = 0; i < set.size(); ++i)
    {
      for (const int v : stars.neighbours(set[i]))
      {
        const auto found = std::lower_bound(vertices.begin(), vertices.end(), v);
        if (found != vertices.end() && *found == v && !reached[found - vertices.begin()])
        {
          reached[found - vertices.begin()] = 1;
          set.push_back(v);
        }
      }
    }
    std::sort(set.begin(), set.end());
    sets.push_back(std::move(set));
  }
  return sets;
}

class FoldFlattener
{
public:
  explicit FoldFlattener(TriangleMesh& mesh)
    : Mesh(mesh)
  {
  }

  FlattenedFolds run()
  {
    FlattenedFolds result;
    const std::vector<int> steep = steepVertices(this->Mesh);
    const Stars own(this->Mesh, steep);
    const std::vector<std::vector<int>> sets = foldedSets(steep, own);
    if (sets.empty())
    {
      return result;
    }
    const Stars stars(this->Mesh, withNeighbours(steep, own));
    const Points3 before = this->Mesh.Vertices;
    const std::vector<int> piercedBefore = this->intersections(sets, stars);
    std::vector<char> flat;
    flat.reserve(sets.size());
    for (const std::vector<int>& set : sets)
    {
      flat.push_back(set.size() <= MostVertices && this->flatten(set, withNeighbours(set, own), stars));
    }
    const std::vector<int> piercedAfter = this->intersections(sets, stars);
    for (std::size_t i = 0; i < sets.size(); ++i)
    {
      if (flat[i] && piercedAfter[i] > piercedBefore[i])
      {
        this->restore(sets[i], before);
        flat[i] = 0;
      }
      result.LeftFolded += !flat[i];
      result.Spikes += flat[i] && sets[i].size() == 1;
      result.Fins += flat[i] && sets[i].size() > 1;
    }
    for (const int f : facesAround(steep, stars))
    {
      result.AreaChange += areaVector(this->Mesh.Vertices, this->Mesh.Faces, f).norm() -
                           areaVector(before, this->Mesh.Faces, f).norm();
    }
    return result;
  }

private:
  // Connected sets of steep inner vertices that are folded somewhere.
  static std::vector<std::vector<int>> foldedSets(std::vector<int> steep, const Stars& stars)
  {
    steep.erase(
      std::remove_if(steep.begin(), steep.end(), [&stars](int v) { return !stars.isInner(v); }),
      steep.end());
    std::vector<std::vector<int>> sets = connectedSets(steep, stars);
    const auto isFolded = [&stars](int v) { return stars.ratio(v) < FoldedRatio; };
    sets.erase(std::remove_if(sets.begin(),
                 sets.end(),
                 [&isFolded](const std::vector<int>& set)
                 { return std::none_of(set.begin(), set.end(), isFolded); }),
      sets.end());
    return sets;
  }

  static std::vector<int> withNeighbours(const std::vector<int>& vertices, const Stars& stars)
  {
    std::vector<int> result = vertices;
    for (const int v : vertices)
    {
      const std::vector<int> neighbours = stars.neighbours(v);
      result.insert(result.end(), neighbours.begin(), neighbours.end());
    }
    return sortedOnce(std::move(result));
  }

  static std::vector<int> facesAround(const std::vector<int>& vertices, const Stars& stars)
  {
    std::vector<int> faces;
    for (const int v : vertices)
    {
      faces.insert(faces.end(), stars.faces(v).begin(), stars.faces(v).end());
    }
    return sortedOnce(std::move(faces));
  }

  // Per set: the number of pairs of a face around its vertices and one that it passes through.
  std::vector<int> intersections(const std::vector<std::vector<int>>& sets, const Stars& stars) const
  {
    std::vector<PlacedTriangle> all(this->Mesh.faceCount());
    for (int f = 0; f < this->Mesh.faceCount(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        all[f].Vertices[k] = this->Mesh.Faces(f, k);
        all[f].Points[k] = this->Mesh.Vertices.row(this->Mesh.Faces(f, k));
      }
    }
    std::vector<PlacedTriangle> moving;
    std::vector<std::pair<int, int>> setAndFace;
    for (std::size_t set = 0; set < sets.size(); ++set)
    {
      for (const int f : facesAround(sets[set], stars))
      {
        moving.push_back(all[f]);
        setAndFace.emplace_back(static_cast<int>(set), f);
      }
    }
    std::vector<int> count(sets.size(), 0);
    for (const auto& [i, other] : overlappingBoxes(moving, all))
    {
      const auto [set, face] = setAndFace[i];
      count[set] += face != other && intersect(all[face], all[other]);
    }
    return count;
  }

  void restore(const std::vector<int>& set, const Points3& positions)
  {
    for (const int v : set)
    {
      this->Mesh.Vertices.row(v) = positions.row(v);
    }
  }

  // Undone, and false, where it does not help all or harms any.
  bool flatten(const std::vector<int>& set, const std::vector<int>& around, const Stars& stars)
  {
    std::vector<double> ratios;
    for (const int v : around)
    {
      ratios.push_back(stars.ratio(v));
    }
    Points3 before(static_cast<Eigen::Index>(set.size()), 3);
    for (std::size_t i = 0; i < set.size(); ++i)
    {
      before.row(static_cast<Eigen::Index>(i)) = this->Mesh.Vertices.row(set[i]);
    }
    this->moveToMeans(set, stars);

    bool better = true;
    for (std::size_t i = 0; better && i < around.size(); ++i)
    {
      const bool inSet = std::binary_search(set.begin(), set.end(), around[i]);
      better = stars.ratio(around[i]) >= (inSet ? FoldedRatio : std::min(ratios[i], FoldedRatio));
    }
    for (std::size_t i = 0; !better && i < set.size(); ++i)
    {
      this->Mesh.Vertices.row(set[i]) = before.row(static_cast<Eigen::Index>(i));
    }
    return better;
  }

  void moveToMeans(const std::vector<int>& set, const Stars& stars)
  {
    for (int sweep = 0; sweep < (set.size() == 1 ? 1 : Sweeps); ++sweep)
    {
      for (const int v : set)
      {
        const std::vector<int> neighbours = stars.neighbours(v);
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (const int neighbour : neighbours)
        {
          sum += this->Mesh.Vertices.row(neighbour);
        }
        this->Mesh.Vertices.row(v) = sum / static_cast<double>(neighbours.size());
      }
    }
  }

  TriangleMesh& Mesh;
};

} // namespace

FlattenedFolds flattenSpikesAndFins(TriangleMesh& mesh)
{
  return FoldFlattener(mesh).run();
}

} // namespace flattening
