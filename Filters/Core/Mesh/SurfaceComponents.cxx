// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SurfaceComponents.h"

#include "Base/Errors.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/DisjointSets.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace flattening
{

std::vector<int> SurfaceComponents::faces(int component) const
{
  std::vector<int> result;
  for (std::size_t f = 0; f < this->OfFace.size(); ++f)
  {
    if (this->OfFace[f] == component)
    {
      result.push_back(static_cast<int>(f));
    }
  }
  return result;
}

SurfaceComponents connectedComponents(const TriangleMesh& mesh)
{
  DisjointSets sets(mesh.vertexCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    sets.join(mesh.Faces(f, 0), mesh.Faces(f, 1));
    sets.join(mesh.Faces(f, 1), mesh.Faces(f, 2));
  }

  SurfaceComponents components;
  components.OfFace.resize(mesh.faceCount());
  std::vector<int> number(mesh.vertexCount(), -1);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    int& component = number[sets.find(mesh.Faces(f, 0))];
    if (component < 0)
    {
      component = components.Count++;
    }
    components.OfFace[f] = component;
  }
  return components;
}

Eigen::VectorXd componentAreas(const TriangleMesh& mesh, const SurfaceComponents& components)
{
  const Eigen::VectorXd faceArea = faceAreas(mesh.Vertices, mesh.Faces);
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(components.Count);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    areas[components.OfFace[f]] += faceArea[f];
  }
  return areas;
}

int chooseComponent(const TriangleMesh& mesh,
  const SurfaceComponents& components,
  const ComponentChoice& choice)
{
  if (choice.By == ComponentChoice::Rule::ClosestToPoint)
  {
    if (!choice.Point.allFinite())
    {
      throw InvalidInput("the component's point is not finite: set all of its coordinates");
    }
    return components.OfFace[ClosestPointTree(mesh).closest(choice.Point).Face];
  }
  const int index = choice.By == ComponentChoice::Rule::ByIndex ? choice.Index : 0;
  if (index < 0 || index >= components.Count)
  {
    throw InvalidInput("there is no component " + std::to_string(index) + ": the surface has " +
                       std::to_string(components.Count) + ", numbered from 0");
  }
  const Eigen::VectorXd areas = componentAreas(mesh, components);
  std::vector<int> byArea(components.Count);
  std::iota(byArea.begin(), byArea.end(), 0);
  std::stable_sort(byArea.begin(), byArea.end(), [&areas](int a, int b) { return areas[a] > areas[b]; });
  return byArea[index];
}

int largestComponent(const TriangleMesh& mesh, const SurfaceComponents& components)
{
  return chooseComponent(mesh, components, {});
}

} // namespace flattening
