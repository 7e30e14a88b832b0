// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/DiskDefect.h"

#include <map>
#include <utility>
#include <vector>

namespace flattening::samples
{
namespace
{

using Edge = std::pair<int, int>; // from one vertex to another

class Halfedges
{
public:
  explicit Halfedges(const TriangleMesh& mesh)
    : FacesAround(mesh.vertexCount(), 0)
  {
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Edge edge(mesh.Faces(f, k), mesh.Faces(f, (k + 1) % 3));
        this->Unique = this->Third.try_emplace(edge, mesh.Faces(f, (k + 2) % 3)).second && this->Unique;
        ++this->FacesAround[edge.first];
      }
    }
    for (const auto& [edge, third] : this->Third)
    {
      if (!this->Third.count({ edge.second, edge.first }))
      {
        this->OneBoundaryThrough = this->NextOnBoundary.insert(edge).second && this->OneBoundaryThrough;
      }
    }
  }

  bool areUnique() const { return this->Unique; }
  bool haveOneBoundaryThroughAVertex() const { return this->OneBoundaryThrough; }
  bool areUsedBy(int vertex) const { return this->FacesAround[vertex] > 0; }
  int boundaryLength() const { return static_cast<int>(this->NextOnBoundary.size()); }
  int edgeCount() const { return (static_cast<int>(this->Third.size()) + this->boundaryLength()) / 2; }

  // Number of edges of the boundary through its first vertex.
  int firstBoundaryLength() const
  {
    const int first = this->NextOnBoundary.begin()->first;
    int length = 1;
    for (int v = this->NextOnBoundary.at(first); v != first; v = this->NextOnBoundary.at(v))
    {
      ++length;
    }
    return length;
  }

  // The faces around a vertex must form one fan, which begins at a boundary edge if there is one.
  bool isOneFan(int vertex) const
  {
    const auto boundary = this->NextOnBoundary.find(vertex);
    const int start = boundary != this->NextOnBoundary.end()
                        ? boundary->second
                        : this->Third.lower_bound({ vertex, 0 })->first.second;
    int faces = 0;
    int neighbour = start;
    do
    {
      const auto face = this->Third.find({ vertex, neighbour });
      if (face == this->Third.end())
      {
        break;
      }
      neighbour = face->second;
      ++faces;
    } while (neighbour != start);
    return faces == this->FacesAround[vertex];
  }

  bool areConnected() const
  {
    std::vector<char> reached(this->FacesAround.size(), 0);
    std::vector<int> pending{ 0 };
    reached[0] = 1;
    std::size_t count = 0;
    while (!pending.empty())
    {
      const int v = pending.back();
      pending.pop_back();
      ++count;
      for (auto face = this->Third.lower_bound({ v, 0 });
           face != this->Third.end() && face->first.first == v;
           ++face)
      {
        for (const int neighbour : { face->first.second, face->second })
        {
          if (!reached[neighbour])
          {
            reached[neighbour] = 1;
            pending.push_back(neighbour);
          }
        }
      }
    }
    return count == reached.size();
  }

private:
  std::map<Edge, int> Third; // the vertex opposite to each edge in the face on its left
  std::map<int, int> NextOnBoundary;
  std::vector<int> FacesAround;
  bool Unique = true;
  bool OneBoundaryThrough = true;
};

} // namespace

std::string diskDefect(const TriangleMesh& mesh)
{
  if (mesh.faceCount() == 0)
  {
    return "it is empty";
  }
  if (!mesh.Vertices.allFinite())
  {
    return "a coordinate is not finite";
  }
  if (!(faceAreas(mesh.Vertices, mesh.Faces).minCoeff() > 0.0))
  {
    return "a face has no area";
  }
  const Halfedges halfedges(mesh);
  if (!halfedges.areUnique())
  {
    return "two faces run along an edge in one direction";
  }
  if (!halfedges.haveOneBoundaryThroughAVertex())
  {
    return "two boundaries meet in a vertex";
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (!halfedges.areUsedBy(v))
    {
      return "a point has no face";
    }
    if (!halfedges.isOneFan(v))
    {
      return "faces meet in a vertex only";
    }
  }
  if (halfedges.boundaryLength() == 0)
  {
    return "it is closed";
  }
  if (halfedges.firstBoundaryLength() != halfedges.boundaryLength())
  {
    return "it has several boundaries";
  }
  if (!halfedges.areConnected())
  {
    return "it has several components";
  }
  const int euler = mesh.vertexCount() - halfedges.edgeCount() + mesh.faceCount();
  return euler == 1 ? std::string() : "its Euler number is " + std::to_string(euler);
}

} // namespace flattening::samples
