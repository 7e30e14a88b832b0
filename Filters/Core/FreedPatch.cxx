// SPDX-License-Identifier: GPL-3.0-or-later
#include "FreedPatch.h"

#include <algorithm>
#include <unordered_map>

namespace flattening
{
namespace
{

void sortUnique(std::vector<int>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

} // namespace

FreedPatch::FreedPatch(const FlatMesh& mesh, int face, int mostVertices)
  : Mesh(mesh)
  , MostVertices(mostVertices)
{
  this->free(face);
  this->includeFlippedFaces();
}

bool FreedPatch::grow()
{
  const std::size_t before = this->Vertices.size();
  for (const int f : this->Faces)
  {
    this->free(f);
  }
  this->includeFlippedFaces();
  return this->Vertices.size() > before;
}

void FreedPatch::free(int face)
{
  for (int k = 0; k < 3; ++k)
  {
    const int v = this->Mesh.Faces(face, k);
    if (!this->Mesh.Fixed[v])
    {
      this->Vertices.push_back(v);
    }
  }
}

void FreedPatch::includeFlippedFaces()
{
  sortUnique(this->Vertices);
  std::size_t known = 0;
  while (this->Vertices.size() > known && !this->tooLarge())
  {
    known = this->Vertices.size();
    this->Faces.clear();
    for (const int v : this->Vertices)
    {
      const auto faces = this->Mesh.FacesOf[v];
      this->Faces.insert(this->Faces.end(), faces.begin(), faces.end());
    }
    sortUnique(this->Faces);
    for (const int f : this->Faces)
    {
      if (!this->Mesh.safelyPositive(f))
      {
        this->free(f);
      }
    }
    sortUnique(this->Vertices);
  }
}

FreedPatch::Local FreedPatch::local() const
{
  Local result;
  std::vector<int> vertices = this->Vertices;
  if (vertices.empty())
  {
    return result;
  }
  FlatPatch& flat = result.Flat;
  flat.FreeVertices = static_cast<int>(vertices.size());
  std::unordered_map<int, int> numbers;
  for (const int v : vertices)
  {
    numbers.emplace(v, static_cast<int>(numbers.size()));
  }
  flat.Faces.resize(this->Faces.size(), 3);
  for (std::size_t i = 0; i < this->Faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = this->Mesh.Faces(this->Faces[i], k);
      const auto [entry, isNew] = numbers.emplace(v, static_cast<int>(numbers.size()));
      if (isNew)
      {
        vertices.push_back(v);
      }
      flat.Faces(i, k) = entry->second;
    }
  }
  result.Origin = this->Mesh.Positions.row(vertices.front());
  flat.Positions.resize(vertices.size(), 2);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    flat.Positions.row(i) = this->Mesh.Positions.row(vertices[i]) - result.Origin;
  }
  result.Unit = flat.Positions.cwiseAbs().maxCoeff();
  if (result.Unit > 0.0)
  {
    flat.Positions /= result.Unit;
    for (const int f : this->Faces)
    {
      const TargetTriangle target = this->Mesh.Targets(f);
      flat.Targets.push_back({ target.Second / result.Unit, target.Third / result.Unit });
    }
  }
  return result;
}

} // namespace flattening
