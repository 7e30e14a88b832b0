// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/DerivedMesh.h"

#include <boost/container/small_vector.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace flattening
{

DerivedMesh derivedFromItself(TriangleMesh mesh)
{
  DerivedMesh derived;
  derived.Vertices.resize(mesh.vertexCount(), mesh.vertexCount());
  derived.Vertices.setIdentity();
  derived.Faces.resize(mesh.faceCount());
  std::iota(derived.Faces.begin(), derived.Faces.end(), 0);
  derived.Mesh = std::move(mesh);
  return derived;
}

VertexOrigins keptVertices(const std::vector<int>& original, int originalCount)
{
  VertexOrigins origins(static_cast<int>(original.size()), originalCount);
  origins.reserve(Eigen::VectorXi::Ones(static_cast<Eigen::Index>(original.size())));
  for (std::size_t v = 0; v < original.size(); ++v)
  {
    origins.insert(static_cast<int>(v), original[v]) = 1.0;
  }
  origins.makeCompressed();
  return origins;
}

namespace
{

// The product of the two matrices. Rows have few entries, and only one where a vertex was kept.
// Eigen's product runs in one thread.
VertexOrigins composed(const VertexOrigins& next, const VertexOrigins& before)
{
  using Entries = boost::container::small_vector<std::pair<int, double>, 16>;
  std::vector<Entries> rows(next.rows());
  tbb::parallel_for(0,
    static_cast<int>(next.rows()),
    [&](int row)
    {
      Entries& entries = rows[row];
      for (VertexOrigins::InnerIterator via(next, row); via; ++via)
      {
        for (VertexOrigins::InnerIterator from(before, static_cast<int>(via.col())); from; ++from)
        {
          const auto column = static_cast<int>(from.col());
          const auto place = std::lower_bound(entries.begin(),
            entries.end(),
            column,
            [](const auto& entry, int c) { return entry.first < c; });
          if (place != entries.end() && place->first == column)
          {
            place->second += via.value() * from.value();
          }
          else
          {
            entries.insert(place, { column, via.value() * from.value() });
          }
        }
      }
    });
  VertexOrigins result(next.rows(), before.cols());
  Eigen::Index count = 0;
  for (const Entries& entries : rows)
  {
    count += static_cast<Eigen::Index>(entries.size());
  }
  result.resizeNonZeros(count);
  int* begin = result.outerIndexPtr();
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    int at = begin[row];
    for (const auto& [column, weight] : rows[row])
    {
      result.innerIndexPtr()[at] = column;
      result.valuePtr()[at++] = weight;
    }
    begin[row + 1] = at;
  }
  return result;
}

} // namespace

void follow(DerivedMesh& derived, DerivedMesh&& next)
{
  derived.Vertices = composed(next.Vertices, derived.Vertices);
  for (int& face : next.Faces)
  {
    face = face < 0 ? -1 : derived.Faces[face];
  }
  derived.Faces = std::move(next.Faces);
  derived.Mesh = std::move(next.Mesh);
}

DerivedMesh extractFaces(const TriangleMesh& mesh, const std::vector<int>& faces)
{
  std::vector<int> index(mesh.vertexCount(), -1);
  for (const int f : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      index[mesh.Faces(f, k)] = 0;
    }
  }
  std::vector<int> original;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (index[v] == 0)
    {
      index[v] = static_cast<int>(original.size());
      original.push_back(v);
    }
  }

  DerivedMesh part;
  part.Mesh.Vertices.resize(static_cast<Eigen::Index>(original.size()), 3);
  for (std::size_t v = 0; v < original.size(); ++v)
  {
    part.Mesh.Vertices.row(v) = mesh.Vertices.row(original[v]);
  }
  part.Mesh.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      part.Mesh.Faces(f, k) = index[mesh.Faces(faces[f], k)];
    }
  }
  part.Vertices = keptVertices(original, mesh.vertexCount());
  part.Faces = faces;
  return part;
}

} // namespace flattening
