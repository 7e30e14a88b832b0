// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/SpikeRemoval.h"

#include "Base/EigenVersions.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/VertexFaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// Flatness below which a vertex is folded. A convention: a cone of 19 degrees looks like a spike; a
// larger bound flattens features of the object, a smaller one leaves spikes.
constexpr double FoldedRatio = 1.0 / 3.0;
// Flatness below which a vertex beside a folded one moves with it: the ends of a fin, which would
// otherwise become spikes.
constexpr double SteepRatio = 0.5;
// The largest set of vertices that is flattened: a fin of one voxel. Larger sheets are part of the
// object.
constexpr std::size_t MostVertices = 20;
// Rounds in which every vertex of a set moves to the mean of its neighbours: a fin three edges high and
// five long comes down to a fiftieth of an edge. With fewer rounds larger folds stay folded.
constexpr int Sweeps = 100;
// The share of the area that must be left. A guard: a surface that is all folds, such as a small one
// pressed flat, has no shape without them. Folds of an object are a few percent of its area.
constexpr double LeastAreaLeft = 0.01;

using VertexSet = std::vector<int>; // ascending

VertexSet sortedOnce(std::vector<int> values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

bool contains(const VertexSet& set, int v)
{
  return std::binary_search(set.begin(), set.end(), v);
}

Eigen::Vector3d areaVector(const Points3& points, const FaceMatrix& faces, int f)
{
  const Eigen::RowVector3d a = points.row(faces(f, 0));
  const Eigen::Vector3d u = points.row(faces(f, 1)) - a;
  const Eigen::Vector3d v = points.row(faces(f, 2)) - a;
  return 0.5 * u.cross(v);
}

class FoldFlattener
{
public:
  explicit FoldFlattener(TriangleMesh& mesh)
    : Mesh(mesh)
    , FacesOf(mesh.Faces, mesh.vertexCount())
  {
  }

  FlattenedFolds run()
  {
    FlattenedFolds result;
    const std::vector<VertexSet> sets = this->foldedSets();
    if (sets.empty())
    {
      return result;
    }
    const TriangleMesh before = this->Mesh;
    std::vector<VertexSet> flattened;
    std::vector<std::vector<int>> faces; // around each of the flattened sets
    for (const VertexSet& set : sets)
    {
      if (set.size() <= MostVertices && this->flatten(set))
      {
        flattened.push_back(set);
        faces.push_back(this->facesAround(set));
      }
    }
    const std::vector<int> intersectionsBefore = intersectionsPerGroup(before, faces);
    const std::vector<int> intersectionsAfter = intersectionsPerGroup(this->Mesh, faces);
    for (std::size_t i = 0; i < flattened.size(); ++i)
    {
      const VertexSet& set = flattened[i];
      if (intersectionsAfter[i] > intersectionsBefore[i])
      {
        this->Mesh.Vertices(set, flattening::all) = before.Vertices(set, flattening::all);
        continue;
      }
      ++(set.size() == 1 ? result.Spikes : result.Fins);
    }
    result.LeftFolded = static_cast<int>(sets.size()) - result.Spikes - result.Fins;
    for (const int f : this->facesAround(this->Steep))
    {
      result.AreaChange += areaVector(this->Mesh.Vertices, this->Mesh.Faces, f).norm() -
                           areaVector(before.Vertices, before.Faces, f).norm();
    }
    const double areaBefore = faceAreas(before.Vertices, before.Faces).sum();
    if (areaBefore + result.AreaChange < LeastAreaLeft * areaBefore)
    {
      this->Mesh.Vertices = before.Vertices;
      result = FlattenedFolds();
      result.LeftFolded = static_cast<int>(sets.size());
    }
    return result;
  }

private:
  double flatness(int v) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0.0;
    for (const int f : this->FacesOf[v])
    {
      const Eigen::Vector3d face = areaVector(this->Mesh.Vertices, this->Mesh.Faces, f);
      sum += face;
      area += face.norm();
    }
    return area > 0.0 ? sum.norm() / area : 1.0; // faces without area are left to other repairs
  }

  // The other corners of the faces around a vertex.
  std::vector<int> corners(int v) const
  {
    std::vector<int> result;
    for (const int f : this->FacesOf[v])
    {
      const auto face = this->Mesh.Faces.row(f);
      std::copy_if(face.begin(), face.end(), std::back_inserter(result), [v](int w) { return w != v; });
    }
    return result;
  }

  VertexSet neighbours(int v) const { return sortedOnce(this->corners(v)); }

  // Every neighbour of an inner vertex is met in two faces.
  bool isInner(int v) const { return this->corners(v).size() == 2 * this->neighbours(v).size(); }

  VertexSet withNeighbours(const VertexSet& vertices) const
  {
    std::vector<int> result = vertices;
    for (const int v : vertices)
    {
      const VertexSet neighbours = this->neighbours(v);
      result.insert(result.end(), neighbours.begin(), neighbours.end());
    }
    return sortedOnce(std::move(result));
  }

  std::vector<int> facesAround(const VertexSet& vertices) const
  {
    std::vector<int> faces;
    for (const int v : vertices)
    {
      faces.insert(faces.end(), this->FacesOf[v].begin(), this->FacesOf[v].end());
    }
    return sortedOnce(std::move(faces));
  }

  // Finds all steep vertices. Returns the connected sets of steep inner vertices with a folded one.
  std::vector<VertexSet> foldedSets()
  {
    VertexSet inner;
    for (int v = 0; v < this->Mesh.vertexCount(); ++v)
    {
      if (this->flatness(v) < SteepRatio)
      {
        this->Steep.push_back(v);
        if (this->isInner(v))
        {
          inner.push_back(v);
        }
      }
    }
    std::vector<VertexSet> sets;
    std::vector<char> reached(this->Mesh.vertexCount(), 0);
    for (const int first : inner)
    {
      if (reached[first])
      {
        continue;
      }
      reached[first] = 1;
      VertexSet set{ first };
      for (std::size_t i = 0; i < set.size(); ++i)
      {
        for (const int v : this->neighbours(set[i]))
        {
          if (!reached[v] && contains(inner, v))
          {
            reached[v] = 1;
            set.push_back(v);
          }
        }
      }
      if (std::any_of(set.begin(), set.end(), [this](int v) { return this->flatness(v) < FoldedRatio; }))
      {
        sets.push_back(sortedOnce(std::move(set)));
      }
    }
    return sets;
  }

  // Moves the vertices of the set. Undoes this and returns false if the set stays folded or a vertex
  // beside it becomes folded, or more so.
  bool flatten(const VertexSet& set)
  {
    const VertexSet around = this->withNeighbours(set);
    std::vector<double> least; // flatness that is demanded
    for (const int v : around)
    {
      least.push_back(contains(set, v) ? FoldedRatio : std::min(this->flatness(v), FoldedRatio));
    }
    const Points3 before = this->Mesh.Vertices(set, flattening::all);
    this->moveToMeans(set);
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      if (!(this->flatness(around[i]) >= least[i]))
      {
        this->Mesh.Vertices(set, flattening::all) = before;
        return false;
      }
    }
    return true;
  }

  void moveToMeans(const VertexSet& set)
  {
    for (int sweep = 0; sweep < (set.size() == 1 ? 1 : Sweeps); ++sweep)
    {
      for (const int v : set)
      {
        const VertexSet neighbours = this->neighbours(v);
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
  VertexFaces FacesOf;
  VertexSet Steep;
};

} // namespace

FlattenedFolds flattenSpikesAndFins(TriangleMesh& mesh)
{
  return FoldFlattener(mesh).run();
}

} // namespace flattening
