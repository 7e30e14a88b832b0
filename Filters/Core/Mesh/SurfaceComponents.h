// SPDX-License-Identifier: GPL-3.0-or-later
/// The connected components of a surface and the choice of one.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

struct SurfaceComponents
{
  int Count = 0;
  std::vector<int> OfFace; ///< 0 .. Count-1 per face, numbered by their first faces

  /// Indices of the faces of one component, ascending.
  std::vector<int> faces(int component) const;
};

/// Finds the connected components; faces that share a vertex belong to the same one.
SurfaceComponents connectedComponents(const TriangleMesh& mesh);

/// Area of every component, input units squared.
Eigen::VectorXd componentAreas(const TriangleMesh& mesh, const SurfaceComponents& components);

/// Which component of a surface is meant.
struct ComponentChoice
{
  enum class Rule
  {
    Largest,
    ClosestToPoint,
    ByIndex
  };
  Rule By = Rule::Largest;
  Eigen::Vector3d Point = Eigen::Vector3d::Zero(); ///< for ClosestToPoint, input units
  int Index = 0; ///< for ByIndex: from 0, in order of decreasing area; equal areas keep their order
};

/// The number of the chosen component.
/// @throws InvalidInput if the point is not finite or there is no component of that index.
int chooseComponent(const TriangleMesh& mesh,
  const SurfaceComponents& components,
  const ComponentChoice& choice);

/// The component of the largest area, and of equals the first.
int largestComponent(const TriangleMesh& mesh, const SurfaceComponents& components);

} // namespace flattening
