// SPDX-License-Identifier: GPL-3.0-or-later
#include "LevelCut.h"

#include <algorithm>

namespace flattening
{

using Halfedge = SurfaceMesh::Halfedge_index;

std::vector<Halfedge> edgesAcrossLevel(const SurfaceMesh& mesh,
  const std::vector<double>& values,
  double level)
{
  std::vector<Halfedge> crossed;
  for (const auto edge : mesh.edges())
  {
    const Halfedge h = mesh.halfedge(edge);
    if ((values[mesh.source(h)] < level) != (values[mesh.target(h)] < level))
    {
      crossed.push_back(h);
    }
  }
  return crossed;
}

void splitAtLevel(EditableSurface& surface, std::vector<double>& values, double level)
{
  constexpr double closest = 1e-6; // to an end, as share of the edge
  const SurfaceMesh& mesh = surface.mesh();
  for (const Halfedge h : edgesAcrossLevel(mesh, values, level))
  {
    const double from = values[mesh.source(h)];
    const double to = values[mesh.target(h)];
    const double t = std::clamp((level - from) / (to - from), closest, 1.0 - closest);
    const auto middle = surface.splitEdge(h, t).Middle;
    values.resize(mesh.num_vertices());
    values[middle] = level;
  }
}

} // namespace flattening
