// SPDX-License-Identifier: GPL-3.0-or-later
/// The surfaces that are benchmarked: disks, ready for the conformal map.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <functional>
#include <string>
#include <vector>

namespace flattening::benchmarks
{

/// A disk, and the seconds that vtkSurfaceToDiskFilter took for it; 0 where it was not needed.
struct BenchmarkSurface
{
  TriangleMesh Mesh;
  double SurfaceToDiskSeconds = 0.0;
};

/// About 6,800 vertices in rings.
BenchmarkSurface hemisphere();
/// A Gaussian bump on a square grid of 101 x 101 vertices, as in the paper's Table 1.
BenchmarkSurface gaussianSquare();
/// The flat square [-1, 1]^2.
BenchmarkSurface squareGrid(int columns, int rows);

/// The brain in @p scan (`ch2bet.nii.gz`: 1 mm, skull-stripped), smoothed by 2 mm, isovalue 40, as one
/// closed surface with a hole cut by vtkSurfaceToDiskFilter.
BenchmarkSurface closedBrain(const std::string& scan);
/// The same closed brain remeshed to edges of 1.465 mm, the hole 0.75 % of its area.
BenchmarkSurface remeshedBrain(const std::string& scan);
/// The same closed and remeshed brain, opened by leaving out the triangles around a point: 0.75 % of the
/// area. The boundary of the hole consists of edges of the mesh; vtkSurfaceToDiskFilter makes a smoother
/// one.
BenchmarkSurface remeshedBrainWithCoarseHole(const std::string& scan);
/// One half of the closed brain, cut at the mid-plane, with the triangles of the isosurface.
BenchmarkSurface halfBrain(const std::string& scan);
/// The half on the other side.
BenchmarkSurface otherHalfBrain(const std::string& scan);
/// The same half, remeshed to edges of the given length (mm).
BenchmarkSurface remeshedHalfBrain(const std::string& scan, double edgeLength = 1.2);

/// The brain in @p scan (`ch2better.nii.gz`: 0.5 mm, skull-stripped), smoothed by one voxel, isovalue
/// 60, its 120 handles removed, opened at a hole: a million vertices too, with long narrow parts.
BenchmarkSurface fineBrain(const std::string& scan);
/// The closed brain without remeshing, with a hole of 0.75 % of its area.
BenchmarkSurface brainWithResolvedHole(const std::string& scan);
/// An open tube, cut from end to end and remeshed.
BenchmarkSurface unrolled(const TriangleMesh& tube, double edgeLength);
/// Each face split in four, @p times over; the half brain twice: a million vertices.
BenchmarkSurface subdivided(const BenchmarkSurface& coarse, int times);

/// A surface that is made when it is needed.
struct NamedSurface
{
  std::string Name;
  std::function<BenchmarkSurface()> Load;
  bool IsLarge = false; // whether its maps take half a minute or more
};

/// The surfaces on which the conformal map, the transport and the refinement are measured.
std::vector<NamedSurface> flattenedSurfaces(const std::string& scan);

} // namespace flattening::benchmarks
