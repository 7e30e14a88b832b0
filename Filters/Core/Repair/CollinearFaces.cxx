// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/CollinearFaces.h"

#include "Repair/NeedlesAndCaps.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <queue>
#include <utility>

namespace flattening
{
namespace
{

using Triangle = std::array<int, 3>;

constexpr double SmallestAltitude = 1e-10; // of the longest edge

class CollinearDissolver
{
public:
  CollinearDissolver(const Points3& vertices, std::vector<Triangle>& faces, std::vector<int>& origins)
    : Vertices(vertices)
    , Faces(faces)
    , Origins(origins)
    , Alive(faces.size(), 1)
  {
  }

  int run()
  {
    for (int f = 0; f < static_cast<int>(this->Faces.size()); ++f)
    {
      this->enqueueIfCollinear(f);
    }
    const int found = static_cast<int>(this->Queue.size());
    if (found == 0)
    {
      return 0;
    }
    this->FacesOfVertex.resize(this->Vertices.rows());
    for (int f = 0; f < static_cast<int>(this->Faces.size()); ++f)
    {
      this->enlist(f);
    }
    // Longest first: a split then only makes edges that are shorter, which ends.
    while (!this->Queue.empty())
    {
      const int f = this->Queue.top().second;
      this->Queue.pop();
      if (this->Alive[f])
      {
        this->dissolve(f);
      }
    }
    this->compact();
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

  void enqueueIfCollinear(int f)
  {
    const Triangle t = this->longestEdgeFirst(this->Faces[f]);
    const Eigen::Vector3d edge = this->Vertices.row(t[1]) - this->Vertices.row(t[0]);
    const Eigen::Vector3d side = this->Vertices.row(t[2]) - this->Vertices.row(t[0]);
    if (edge.cross(side).norm() > SmallestAltitude * edge.squaredNorm())
    {
      return;
    }
    // Rounding decides which of a needle's long edges is the longest: splitting at one, then at the
    // other would never end.
    const double shortest = std::min(this->squaredLength(t[1], t[2]), side.squaredNorm());
    if (shortest > SmallestEdgeShare * SmallestEdgeShare * edge.squaredNorm())
    {
      this->Queue.emplace(edge.squaredNorm(), f);
    }
  }

  void enlist(int f)
  {
    for (const int v : this->Faces[f])
    {
      this->FacesOfVertex[v].push_back(f);
    }
  }

  void dissolve(int f)
  {
    const auto [from, to, between] = this->longestEdgeFirst(this->Faces[f]);
    this->Alive[f] = 0;
    const std::vector<int> candidates = this->FacesOfVertex[from];
    for (const int g : candidates)
    {
      const Triangle beyond = this->Faces[g];
      if (this->Alive[g] && std::find(beyond.begin(), beyond.end(), to) != beyond.end())
      {
        this->Alive[g] = 0;
        this->addPart(beyond, to, between, this->Origins[g]);
        this->addPart(beyond, from, between, this->Origins[g]);
      }
    }
  }

  void addPart(Triangle whole, int replaced, int replacement, int origin)
  {
    if (std::find(whole.begin(), whole.end(), replacement) != whole.end())
    {
      return; // the collinear face's own mirror image: nothing is left of it
    }
    std::replace(whole.begin(), whole.end(), replaced, replacement);
    const int f = static_cast<int>(this->Faces.size());
    this->Faces.push_back(whole);
    this->Origins.push_back(origin);
    this->Alive.push_back(1);
    this->enlist(f);
    this->enqueueIfCollinear(f);
  }

  void compact()
  {
    std::size_t kept = 0;
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      if (this->Alive[f])
      {
        this->Faces[kept] = this->Faces[f];
        this->Origins[kept++] = this->Origins[f];
      }
    }
    this->Faces.resize(kept);
    this->Origins.resize(kept);
  }

  const Points3& Vertices;
  std::vector<Triangle>& Faces;
  std::vector<int>& Origins;
  std::vector<char> Alive;
  std::vector<std::vector<int>> FacesOfVertex;
  std::priority_queue<std::pair<double, int>> Queue;
};

} // namespace

int dissolveCollinearFaces(const Points3& vertices,
  std::vector<std::array<int, 3>>& faces,
  std::vector<int>& origins)
{
  return CollinearDissolver(vertices, faces, origins).run();
}

} // namespace flattening
