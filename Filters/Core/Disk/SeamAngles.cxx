// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/SeamAngles.h"

#include "Remeshing/SliverRemoval.h"

#include <utility>

namespace flattening
{

void openAnglesBesideSeam(DiskSurface& disk, double degrees, const ProgressCallback& progress)
{
  DerivedMesh opened = withoutSmallAnglesInside(disk.Surface.Mesh, degrees, progress);
  std::vector<char> onSeam(opened.Mesh.vertexCount(), 0);
  for (int v = 0; v < opened.Mesh.vertexCount(); ++v)
  {
    // A vertex of the seam is as it was; one that was moved close to the seam is made of several.
    const VertexOrigins::InnerIterator origin(opened.Vertices, v);
    onSeam[v] = origin && origin.value() == 1.0 && disk.Seam[origin.col()];
  }
  disk.Seam = std::move(onSeam);
  follow(disk.Surface, std::move(opened));
}

} // namespace flattening
