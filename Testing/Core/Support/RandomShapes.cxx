// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/RandomShapes.h"

#include "Support/MarchingTetrahedra.h"
#include "Support/SampleSurfaces.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flattening::samples
{
namespace
{

constexpr double Outside = -1.0;

bool isBorder(const Volume& volume, int x, int y, int z)
{
  return x == 0 || y == 0 || z == 0 || x == volume.Size[0] - 1 || y == volume.Size[1] - 1 ||
         z == volume.Size[2] - 1;
}

template <typename Visit>
void forEachPoint(const Volume& volume, Visit&& visit)
{
  for (int z = 0; z < volume.Size[2]; ++z)
  {
    for (int y = 0; y < volume.Size[1]; ++y)
    {
      for (int x = 0; x < volume.Size[0]; ++x)
      {
        visit(x, y, z);
      }
    }
  }
}

// Mean of a point and its neighbours along one axis.
void blurAlong(Volume& volume, int axis)
{
  const Volume old = volume;
  forEachPoint(volume,
    [&](int x, int y, int z)
    {
      std::array<int, 3> before = { x, y, z };
      std::array<int, 3> after = before;
      before[axis] = std::max(before[axis] - 1, 0);
      after[axis] = std::min(after[axis] + 1, volume.Size[axis] - 1);
      volume.at(x, y, z) = (old.at(before[0], before[1], before[2]) + old.at(x, y, z) +
                             old.at(after[0], after[1], after[2])) /
                           3.0;
    });
}

// Adds the two triangles of one side of a voxel, with the normal along +axis or -axis.
class VoxelFaces
{
public:
  explicit VoxelFaces(const std::array<int, 3>& points)
    : Points(points)
    , Index(static_cast<std::size_t>(points[0]) * points[1] * points[2], -1)
  {
  }

  void add(std::array<int, 3> voxel, int axis, bool positive)
  {
    voxel[axis] += positive ? 1 : 0;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    std::array<int, 4> corner;
    for (int k = 0; k < 4; ++k)
    {
      std::array<int, 3> point = voxel;
      point[u] += k == 1 || k == 2 ? 1 : 0;
      point[v] += k >= 2 ? 1 : 0;
      corner[positive ? k : 3 - k] = this->vertex(point);
    }
    this->Faces.push_back({ corner[0], corner[1], corner[2] });
    this->Faces.push_back({ corner[0], corner[2], corner[3] });
  }

  TriangleMesh surface() const { return meshOf(this->Vertices, this->Faces); }

private:
  int vertex(const std::array<int, 3>& point)
  {
    int& index = this->Index[point[0] + this->Points[0] * (point[1] + this->Points[1] * point[2])];
    if (index < 0)
    {
      index = static_cast<int>(this->Vertices.size());
      this->Vertices.push_back({ double(point[0]), double(point[1]), double(point[2]) });
    }
    return index;
  }

  std::array<int, 3> Points;
  std::vector<int> Index;
  std::vector<std::array<double, 3>> Vertices;
  std::vector<std::array<int, 3>> Faces;
};

} // namespace

TriangleMesh bumpySphere(RandomNumbers& random)
{
  TriangleMesh mesh = sphere(random.integer(2, 3));
  for (int bump = random.integer(0, 4); bump > 0; --bump)
  {
    const Eigen::RowVector3d direction = random.point(-4.0, 4.0);
    const double phase = random.real(0.0, 2.0 * Pi);
    const double height = random.real(0.0, 0.2);
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      mesh.Vertices.row(v) *= 1.0 + height * std::sin(mesh.Vertices.row(v).dot(direction) + phase);
    }
  }
  return mesh;
}

TriangleMesh chainOfRings(RandomNumbers& random, int rings)
{
  const double radius = random.real(2.8, 3.3);
  const double thickness = random.real(1.0, 1.3);
  const double step = 2.0 * radius - 0.5 * thickness; // the tubes of neighbours merge
  const double margin = radius + thickness + 1.5;
  Volume volume({ int(2.0 * margin + (rings - 1) * step) + 1, int(2.0 * margin) + 1, 6 });
  const Eigen::RowVector3d first = Eigen::RowVector3d(margin, margin, 2.5) + random.point(-0.3, 0.3);
  forEachPoint(volume,
    [&](int x, int y, int z)
    {
      double& value = volume.at(x, y, z);
      value = -volume.Size[0];
      for (int ring = 0; ring < rings; ++ring)
      {
        const Eigen::RowVector3d p =
          Eigen::RowVector3d(x, y, z) - first - Eigen::RowVector3d(ring * step, 0.0, 0.0);
        const double toCircle = std::hypot(std::hypot(p.x(), p.y()) - radius, p.z());
        value = std::max(value, thickness - toCircle);
      }
    });
  return marchingTetrahedra(volume);
}

TriangleMesh noiseSurface(RandomNumbers& random, int smoothing, bool padded)
{
  Volume volume({ random.integer(4, 9), random.integer(4, 9), random.integer(4, 9) });
  for (double& value : volume.Values)
  {
    value = random.real(0.0, 1.0);
  }
  for (int pass = 0; pass < smoothing; ++pass)
  {
    for (const int axis : { 0, 1, 2 })
    {
      blurAlong(volume, axis);
    }
  }
  // The isovalue is a quantile, so that a given share of the voxels is inside however the smoothing
  // changed their range.
  std::vector<double> sorted = volume.Values;
  std::sort(sorted.begin(), sorted.end());
  const double isovalue = sorted[static_cast<std::size_t>(random.real(0.3, 0.7) * sorted.size())];
  const double halfSpan = 0.5 * (sorted.back() - sorted.front());
  forEachPoint(volume,
    [&](int x, int y, int z)
    {
      const bool outside = padded && isBorder(volume, x, y, z);
      volume.at(x, y, z) = outside ? Outside : (volume.at(x, y, z) - isovalue) / halfSpan;
    });
  return marchingTetrahedra(volume);
}

TriangleMesh piercedVoxels(RandomNumbers& random)
{
  const std::array<int, 3> size = { random.integer(3, 9), random.integer(3, 9), random.integer(3, 9) };
  Volume solid({ size[0] + 2, size[1] + 2, size[2] + 2 }); // one layer outside all around
  forEachPoint(
    solid, [&](int x, int y, int z) { solid.at(x, y, z) = isBorder(solid, x, y, z) ? Outside : 1.0; });
  for (int tunnel = random.integer(0, 6); tunnel > 0; --tunnel)
  {
    const int axis = random.integer(0, 2);
    std::array<int, 3> voxel = {
      random.integer(1, size[0]), random.integer(1, size[1]), random.integer(1, size[2])
    };
    for (voxel[axis] = 1; voxel[axis] <= size[axis]; ++voxel[axis])
    {
      solid.at(voxel[0], voxel[1], voxel[2]) = Outside;
    }
  }
  const double missing = random.chance(0.5) ? random.real(0.0, 0.4) : 0.0;
  for (double& value : solid.Values)
  {
    value = random.chance(missing) ? Outside : value;
  }

  VoxelFaces faces({ size[0] + 3, size[1] + 3, size[2] + 3 });
  forEachPoint(solid,
    [&](int x, int y, int z)
    {
      if (solid.at(x, y, z) < 0.0)
      {
        return;
      }
      for (const int axis : { 0, 1, 2 })
      {
        for (const bool positive : { false, true })
        {
          std::array<int, 3> neighbour = { x, y, z };
          neighbour[axis] += positive ? 1 : -1;
          if (solid.at(neighbour[0], neighbour[1], neighbour[2]) < 0.0)
          {
            faces.add({ x, y, z }, axis, positive);
          }
        }
      }
    });
  return faces.surface();
}

} // namespace flattening::samples
