// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/TracedSurface.h"

#include <map>
#include <numeric>

namespace flattening
{

TracedSurface::TracedSurface(const TriangleMesh& mesh)
  : Halfedges(mesh)
  , OriginalVertices(mesh.vertexCount())
  , Faces(mesh.faceCount())
{
  std::iota(this->Faces.begin(), this->Faces.end(), 0);
}

TracedSurface::Origin TracedSurface::origin(int v) const
{
  return v < this->OriginalVertices ? Origin{ { v, 1.0 } }
                                    : this->NewVertices[v - this->OriginalVertices];
}

int TracedSurface::cut(const std::vector<int>& loop)
{
  for (const int h : loop)
  {
    this->NewVertices.push_back(this->origin(this->Halfedges.origin(h)));
  }
  return this->Halfedges.cut(loop);
}

int TracedSurface::splitEdge(int h)
{
  std::map<int, double> weights;
  for (const int end : { this->Halfedges.origin(h), this->Halfedges.tip(h) })
  {
    for (const auto& [vertex, weight] : this->origin(end))
    {
      weights[vertex] += 0.5 * weight;
    }
  }
  this->NewVertices.emplace_back(weights.begin(), weights.end());
  this->Faces.push_back(this->Faces[HalfedgeSurface::face(h)]);
  this->Faces.push_back(this->Faces[HalfedgeSurface::face(this->Halfedges.twin(h))]);
  return this->Halfedges.splitEdge(h);
}

int TracedSurface::addVertex(const Eigen::Vector3d& point, Origin origin)
{
  this->NewVertices.push_back(std::move(origin));
  return this->Halfedges.addVertex(point);
}

void TracedSurface::addFaces(const std::vector<std::array<int, 3>>& faces)
{
  this->Halfedges.addFaces(faces);
  this->Faces.resize(this->Halfedges.faceCount(), -1);
}

DerivedMesh TracedSurface::derived() const
{
  DerivedMesh result;
  result.Mesh = this->Halfedges.mesh();
  result.Faces = this->Faces;
  std::vector<Eigen::Triplet<double, int>> weights;
  weights.reserve(result.Mesh.vertexCount());
  for (int v = 0; v < this->OriginalVertices; ++v)
  {
    weights.emplace_back(v, v, 1.0);
  }
  for (int v = this->OriginalVertices; v < result.Mesh.vertexCount(); ++v)
  {
    for (const auto& [original, weight] : this->NewVertices[v - this->OriginalVertices])
    {
      weights.emplace_back(v, original, weight);
    }
  }
  result.Vertices.resize(result.Mesh.vertexCount(), this->OriginalVertices);
  result.Vertices.setFromTriplets(weights.begin(), weights.end());
  return result;
}

} // namespace flattening
