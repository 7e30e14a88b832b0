// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/NeedlesAndCaps.h"

#include "Mesh/DisjointSets.h"
#include "Mesh/SliverThresholds.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <queue>
#include <utility>

namespace flattening
{
namespace
{

using VertexClasses = DisjointSets;

// The greatest number of splits for each face: a guard. Isosurfaces have fewer caps than faces, and a
// cap splits one face.
constexpr std::size_t MostSplitsPerFace = 10;

// Joins the ends of the face's shortest edge if that is too short. Returns whether they were two.
bool joinIfNeedle(const Points3& vertices, const Triangle& face, VertexClasses& classes)
{
  std::array<double, 3> length;
  for (int k = 0; k < 3; ++k)
  {
    length[k] = (vertices.row(face[k]) - vertices.row(face[(k + 1) % 3])).norm();
  }
  const auto [shortest, longest] = std::minmax_element(length.begin(), length.end());
  if (*shortest > slivers::NeedleEdge * *longest)
  {
    return false;
  }
  const auto k = shortest - length.begin();
  const int from = classes.find(face[k]);
  const int to = classes.find(face[(k + 1) % 3]);
  classes.join(from, to);
  return from != to;
}

RemovedSlivers collapseNeedles(const Points3& vertices, FaceList& list)
{
  RemovedSlivers removed;
  VertexClasses classes(vertices.rows());
  for (int joined = -1; joined != 0;)
  {
    joined = static_cast<int>(std::count_if(list.Faces.begin(),
      list.Faces.end(),
      [&](const Triangle& face) { return joinIfNeedle(vertices, face, classes); }));
    if (joined > 0)
    {
      classes.normalise(); // the smallest vertex represents each class
      for (Triangle& face : list.Faces)
      {
        std::transform(
          face.begin(), face.end(), face.begin(), [&classes](int v) { return classes.find(v); });
      }
      removed.JoinedVertices += joined;
      removed.Faces += list.dropIf([&list](std::size_t f) { return repeatsVertex(list.Faces[f]); });
    }
  }
  return removed;
}

class CapDissolver
{
public:
  // @p splits: how many faces may still be split; counted down
  CapDissolver(const Points3& vertices, FaceList& list, std::size_t& splits)
    : Vertices(vertices)
    , List(list)
    , Splits(splits)
    , Alive(list.Faces.size(), 1)
  {
  }

  // Returns the number of caps at the start.
  int run()
  {
    for (std::size_t f = 0; f < this->List.Faces.size(); ++f)
    {
      this->enqueueIfCap(static_cast<int>(f));
    }
    const int found = static_cast<int>(this->Queue.size());
    if (found == 0)
    {
      return 0;
    }
    this->FacesOfVertex.resize(this->Vertices.rows());
    for (std::size_t f = 0; f < this->List.Faces.size(); ++f)
    {
      this->enlist(static_cast<int>(f));
    }
    // Longest first: a split then only makes edges that are shorter, so that it ends.
    while (!this->Queue.empty())
    {
      const int f = this->Queue.top().second;
      this->Queue.pop();
      if (this->Alive[f])
      {
        this->dissolve(f);
      }
    }
    this->List.dropIf([this](std::size_t f) { return !this->Alive[f]; });
    return found;
  }

private:
  double squaredLength(int a, int b) const
  {
    return (this->Vertices.row(a) - this->Vertices.row(b)).squaredNorm();
  }

  // Rotates the corners so that the longest edge is the one from the first to the second.
  Triangle longestEdgeFirst(const Triangle& t) const
  {
    int longest = 0;
    for (int k = 1; k < 3; ++k)
    {
      if (this->squaredLength(t[k], t[(k + 1) % 3]) >
          this->squaredLength(t[longest], t[(longest + 1) % 3]))
      {
        longest = k;
      }
    }
    return { t[longest], t[(longest + 1) % 3], t[(longest + 2) % 3] };
  }

  void enqueueIfCap(int f)
  {
    const Triangle t = this->longestEdgeFirst(this->List.Faces[f]);
    const Eigen::Vector3d edge = this->Vertices.row(t[1]) - this->Vertices.row(t[0]);
    const Eigen::Vector3d side = this->Vertices.row(t[2]) - this->Vertices.row(t[0]);
    if (edge.cross(side).norm() > slivers::CapAltitude * edge.squaredNorm())
    {
      return;
    }
    // Rounding decides which of a needle's long edges is the longest: splitting at one, then at the
    // other would never end.
    const double shortest = std::min(this->squaredLength(t[1], t[2]), side.squaredNorm());
    if (shortest > slivers::NeedleEdge * slivers::NeedleEdge * edge.squaredNorm())
    {
      this->Queue.emplace(edge.squaredNorm(), f);
    }
  }

  void enlist(int f)
  {
    for (const int v : this->List.Faces[f])
    {
      this->FacesOfVertex[v].push_back(f);
    }
  }

  // Forgets those that are no longer alive, which can be many times as many.
  const std::vector<int>& aliveFacesOf(int vertex)
  {
    std::vector<int>& faces = this->FacesOfVertex[vertex];
    faces.erase(std::remove_if(faces.begin(), faces.end(), [this](int g) { return !this->Alive[g]; }),
      faces.end());
    return faces;
  }

  bool exists(const Triangle& t)
  {
    const std::vector<int>& faces = this->aliveFacesOf(t[0]);
    return std::any_of(faces.begin(),
      faces.end(),
      [&](int g) { return std::is_permutation(t.begin(), t.end(), this->List.Faces[g].begin()); });
  }

  void dissolve(int f)
  {
    const auto [from, to, between] = this->longestEdgeFirst(this->List.Faces[f]);
    this->Alive[f] = 0;
    const std::vector<int> candidates = this->aliveFacesOf(from);
    for (const int g : candidates)
    {
      const Triangle beyond = this->List.Faces[g];
      if (this->Splits > 0 && this->Alive[g] &&
          std::find(beyond.begin(), beyond.end(), to) != beyond.end())
      {
        --this->Splits;
        this->Alive[g] = 0;
        this->addPart(beyond, to, between, this->List.Origins[g]);
        this->addPart(beyond, from, between, this->List.Origins[g]);
      }
    }
  }

  void addPart(Triangle whole, int replaced, int replacement, int origin)
  {
    if (std::find(whole.begin(), whole.end(), replacement) != whole.end())
    {
      return; // the mirror image of the cap: nothing is left of it
    }
    std::replace(whole.begin(), whole.end(), replaced, replacement);
    if (this->exists(whole))
    {
      return; // copies would double with every split, where many caps lie on one line
    }
    const int f = static_cast<int>(this->List.Faces.size());
    this->List.Faces.push_back(whole);
    this->List.Origins.push_back(origin);
    this->Alive.push_back(1);
    this->enlist(f);
    this->enqueueIfCap(f);
  }

  const Points3& Vertices;
  FaceList& List;
  std::size_t& Splits;
  std::vector<char> Alive; // per face
  std::vector<std::vector<int>> FacesOfVertex;
  std::priority_queue<std::pair<double, int>> Queue; // squared length of the longest edge, face
};

} // namespace

RemovedSlivers removeNeedlesAndCaps(const Points3& vertices, FaceList& faces)
{
  RemovedSlivers removed;
  // Where many caps lie on one line, splits can make new caps without end. Caps are then dropped, which
  // leaves T-junctions.
  std::size_t splits = MostSplitsPerFace * faces.Faces.size();
  // Either step may make new work for the other.
  for (bool changed = true; changed;)
  {
    const RemovedSlivers needles = collapseNeedles(vertices, faces);
    const int caps = CapDissolver(vertices, faces, splits).run();
    removed.JoinedVertices += needles.JoinedVertices;
    removed.Faces += needles.Faces + caps;
    changed = needles.JoinedVertices > 0 || caps > 0;
  }
  return removed;
}

} // namespace flattening
