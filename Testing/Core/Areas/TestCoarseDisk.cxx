// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/CoarseDisk.h"
#include "Base/EigenVersions.h"
#include "Base/Errors.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

// A flat disk in space that is stretched along x, and as its chart the disk before.
class CoarseDiskOfAnEllipse : public testing::Test
{
protected:
  CoarseDiskOfAnEllipse()
    : Surface(sunflowerMesh(flatDisk(), 8000).Mesh)
    , Loop(requireDisk(Surface))
    , Chart(Surface.Vertices.leftCols<2>())
  {
    this->Surface.Vertices.col(0) *= Stretch;
    this->Targets = faceAreas(this->Surface.Vertices, this->Surface.Faces);
    this->Disk = coarseDisk(this->Surface, this->Loop, this->Chart, this->Targets, 500);
  }

  // The corners of a face in space.
  Eigen::Matrix3d cornersOf(Eigen::Index face) const
  {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k)
    {
      corners.row(k) = this->Surface.Vertices.row(this->Disk.Vertices[this->Disk.Faces(face, k)]);
    }
    return corners;
  }

  static constexpr double Stretch = 1.7;
  TriangleMesh Surface;
  std::vector<int> Loop;
  Points2 Chart;
  Eigen::VectorXd Targets;
  CoarseDisk Disk;
};

TEST_F(CoarseDiskOfAnEllipse, IsADiskWithTheSameBoundary)
{
  const auto count = static_cast<int>(this->Disk.Vertices.size());
  const int inner = count - static_cast<int>(this->Loop.size());
  EXPECT_GT(inner, 450);
  EXPECT_LT(inner, 900); // more near the boundary
  const MeshTopology topology = analyseTopology(this->Disk.Faces, count);
  EXPECT_EQ(topology.Vertices, count);
  EXPECT_EQ(topology.eulerCharacteristic(), 1);
  ASSERT_EQ(topology.BoundaryLoops.size(), 1U);
  ASSERT_EQ(topology.BoundaryLoops[0].size(), this->Loop.size());
  for (std::size_t k = 0; k < this->Loop.size(); ++k)
  {
    EXPECT_EQ(topology.BoundaryLoops[0][k], static_cast<int>(k));
    EXPECT_EQ(this->Disk.Vertices[k], this->Loop[k]);
  }
  const Points2 positions = this->Chart(this->Disk.Vertices, flattening::all);
  EXPECT_EQ(countFlippedFaces(positions, this->Disk.Faces), 0);
}

// The stretch is the same everywhere, so that the averages are exact.
TEST_F(CoarseDiskOfAnEllipse, FacesHaveTheAnglesThatTheyHaveOnTheSurface)
{
  for (Eigen::Index face = 0; face < this->Disk.Faces.rows(); ++face)
  {
    const Eigen::Matrix3d corners = this->cornersOf(face);
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d one = corners.row((k + 1) % 3) - corners.row(k);
      const Eigen::Vector3d other = corners.row((k + 2) % 3) - corners.row(k);
      const double cotangent = one.dot(other) / one.cross(other).norm();
      EXPECT_NEAR(this->Disk.Cotangents(face, k), cotangent, 1e-9 * (1.0 + std::abs(cotangent)));
    }
  }
}

TEST_F(CoarseDiskOfAnEllipse, TargetsAreWhatFacesCover)
{
  EXPECT_NEAR(this->Disk.Targets.sum(), this->Targets.sum(), 1e-3 * this->Targets.sum());
  double error = 0.0;
  for (Eigen::Index face = 0; face < this->Disk.Faces.rows(); ++face)
  {
    const Eigen::Matrix3d corners = this->cornersOf(face);
    const Eigen::Vector3d one = corners.row(1) - corners.row(0);
    const Eigen::Vector3d other = corners.row(2) - corners.row(0);
    error += std::abs(this->Disk.Targets[face] - 0.5 * one.cross(other).norm());
  }
  EXPECT_LT(error, 0.04 * this->Targets.sum()); // what the parts along the sides of faces make
}

// An affine map of the chart is one of every vertex.
TEST_F(CoarseDiskOfAnEllipse, CarriesAffineMaps)
{
  Eigen::Matrix2d linear;
  linear << 2.0, 0.3, -0.4, 1.1;
  const Eigen::RowVector2d offset(5.0, -3.0);
  const Points2 wanted = (this->Chart * linear).rowwise() + offset;
  const Points2 carried = this->Disk.carried(wanted(this->Disk.Vertices, flattening::all));
  EXPECT_LT((carried - wanted).cwiseAbs().maxCoeff(), 1e-12);
  for (const int v : this->Disk.Vertices)
  {
    EXPECT_EQ(carried.row(v), wanted.row(v)) << v; // without rounding
  }
}

TEST_F(CoarseDiskOfAnEllipse, CanBeCancelledAnywhere)
{
  for (const double stop : { 0.0, 0.1, 0.35, 0.7 })
  {
    EXPECT_THROW(coarseDisk(this->Surface,
                   this->Loop,
                   this->Chart,
                   this->Targets,
                   500,
                   [stop](double fraction, const char*) { return fraction < stop; }),
      Cancelled)
      << stop;
  }
}

} // namespace
