// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceComponents.h"

#include "SurfaceProjection.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <numeric>

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
  std::vector<int> rank(mesh.vertexCount(), 0);
  std::vector<int> parent(mesh.vertexCount());
  std::iota(parent.begin(), parent.end(), 0);
  boost::disjoint_sets<int*, int*> sets(rank.data(), parent.data());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    sets.union_set(mesh.Faces(f, 0), mesh.Faces(f, 1));
    sets.union_set(mesh.Faces(f, 1), mesh.Faces(f, 2));
  }

  SurfaceComponents components;
  components.OfFace.resize(mesh.faceCount());
  std::vector<int> number(mesh.vertexCount(), -1);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    int& component = number[sets.find_set(mesh.Faces(f, 0))];
    if (component < 0)
    {
      component = components.Count++;
    }
    components.OfFace[f] = component;
  }
  return components;
}

int largestComponent(const TriangleMesh& mesh, const SurfaceComponents& components)
{
  const Eigen::VectorXd faceArea = faceAreas(mesh.Vertices, mesh.Faces);
  Eigen::VectorXd area = Eigen::VectorXd::Zero(components.Count);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    area[components.OfFace[f]] += faceArea[f];
  }
  Eigen::Index largest = 0;
  area.maxCoeff(&largest);
  return static_cast<int>(largest);
}

int closestComponent(const TriangleMesh& mesh,
  const SurfaceComponents& components,
  const Eigen::Vector3d& point)
{
  return components.OfFace[SurfaceProjection(mesh).closest(point).Face];
}

} // namespace flattening
