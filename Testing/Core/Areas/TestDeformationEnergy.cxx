// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/DeformationEnergy.h"
#include "Areas/DeformationLattice.h"
#include "Areas/DegreesOfFreedom.h"
#include "Areas/LatticeMatrix.h"
#include "Areas/RefinementTerms.h"
#include "Areas/SmoothDeformation.h"
#include "Base/EigenVersions.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace
{

using namespace flattening;

// A paraboloid seen from above, which is no map that keeps areas, under deformations of a lattice.
class DeformationEnergyOfAMap : public testing::Test
{
protected:
  DeformationEnergyOfAMap()
    : Mesh(analytic::sunflowerMesh(analytic::paraboloid(0.8), 2000).Mesh)
    , Positions(Mesh.Vertices.leftCols<2>())
    , Targets(faceAreas(Mesh.Vertices, Mesh.Faces))
    , Terms(Mesh, requireDisk(Mesh), 1.0, 0.001)
    , Lattice(Eigen::AlignedBox2d(Eigen::Vector2d(-1.3, -1.2), Eigen::Vector2d(1.3, 1.4)), 6)
    , Energy(Lattice, Terms, Positions, Targets)
  {
    this->Energy.setAreaWeight(7.0);
  }

  Points2 displacements(double size, int seed) const
  {
    Points2 result(this->Lattice.nodeCount(), 2);
    for (Eigen::Index i = 0; i < result.size(); ++i)
    {
      result.data()[i] = size * std::sin(1.7 * static_cast<double>((i + 1) * (seed + 3) % 997));
    }
    return result;
  }

  TriangleMesh Mesh;
  Points2 Positions;
  Eigen::VectorXd Targets;
  RefinementTerms Terms;
  DeformationLattice Lattice;
  DeformationEnergy Energy;
};

// Displacements that are an affine function of the nodes' places move every point by that function.
TEST_F(DeformationEnergyOfAMap, LatticeReproducesAffineMaps)
{
  Eigen::Matrix2d linear;
  linear << 0.2, -0.4, 0.3, 0.1;
  const Eigen::RowVector2d shift(0.5, -0.7);
  Points2 displacements(this->Lattice.nodeCount(), 2);
  for (int node = 0; node < this->Lattice.nodeCount(); ++node)
  {
    const int columns = this->Lattice.columns() + 2;
    const Eigen::Vector2d place =
      this->Lattice.origin() +
      this->Lattice.side() * Eigen::Vector2d(node % columns - 0.5, node / columns - 0.5);
    displacements.row(node) = (linear * place).transpose() + shift;
  }
  const Points2 moved = this->Lattice.moved(this->Positions, displacements);
  const Points2 expected = (this->Positions + this->Positions * linear.transpose()).rowwise() + shift;
  EXPECT_LT((moved - expected).cwiseAbs().maxCoeff(), 1e-13);
}

// The energy of a scaling x -> 1.1 x, worked out face by face: shapes do not change, and area ratios
// grow by 1.21. Square by square the ratio of the faces is that of their sum.
TEST_F(DeformationEnergyOfAMap, ScalingChangesAreasAlone)
{
  const auto areaTerm = [this](const Points2& displacements)
  {
    DeformationEnergy heavy = this->Energy;
    heavy.setAreaWeight(1e6);
    DeformationEnergy light = this->Energy;
    light.setAreaWeight(1e-6);
    return (heavy.value(displacements) - light.value(displacements)) / (1e6 - 1e-6);
  };
  const Points2 none = Points2::Zero(this->Lattice.nodeCount(), 2);
  Points2 scaling = none;
  for (int node = 0; node < this->Lattice.nodeCount(); ++node)
  {
    const int columns = this->Lattice.columns() + 2;
    scaling.row(node) =
      0.1 * (this->Lattice.origin() +
              this->Lattice.side() * Eigen::Vector2d(node % columns - 0.5, node / columns - 0.5))
              .transpose();
  }
  const Eigen::ArrayXd ratios =
    signedFaceAreas(this->Positions, this->Mesh.Faces).array() / this->Targets.array();
  const double before = (this->Targets.array() * (ratios - 1.0).square()).sum();
  const double after = (this->Targets.array() * (1.21 * ratios - 1.0).square()).sum();
  EXPECT_NEAR(areaTerm(none), before, 0.02 * before);
  EXPECT_NEAR(areaTerm(scaling), after, 0.03 * after);
  const double shapes = this->Energy.value(none) - 7.0 * areaTerm(none);
  EXPECT_NEAR(this->Energy.value(scaling) - 7.0 * areaTerm(scaling), shapes, 1e-6 * shapes);
  EXPECT_NEAR(shapes, this->Targets.sum(), 0.01 * shapes); // the faces are no slivers, and each counts 1
}

TEST_F(DeformationEnergyOfAMap, GradientIsThatOfDifferences)
{
  const Points2 at = this->displacements(0.03, 1);
  Eigen::VectorXd gradient;
  LatticeMatrix hessian(this->Lattice);
  const double value = this->Energy.derivatives(at, gradient, hessian);
  EXPECT_NEAR(value, this->Energy.value(at), 1e-12 * value);
  for (int seed = 2; seed < 8; ++seed)
  {
    const Points2 step = this->displacements(1e-6, seed);
    const double difference = 0.5 * (this->Energy.value(at + step) - this->Energy.value(at - step));
    const double slope = gradient.dot(Eigen::Map<const Eigen::VectorXd>(step.data(), step.size()));
    EXPECT_NEAR(slope, difference, 1e-5 * std::abs(difference) + 1e-12);
  }
}

// The second derivative is replaced by its positive part square by square: along any direction it is at
// least that of the energy, and not negative.
TEST_F(DeformationEnergyOfAMap, HessianBoundsDifferencesOfTheGradient)
{
  const Points2 at = this->displacements(0.03, 1);
  Eigen::VectorXd gradient;
  LatticeMatrix hessian(this->Lattice);
  this->Energy.derivatives(at, gradient, hessian);
  for (int seed = 2; seed < 8; ++seed)
  {
    const Points2 step = this->displacements(1e-5, seed);
    const Eigen::Map<const Eigen::VectorXd> s(step.data(), step.size());
    const double second =
      this->Energy.value(at + step) - 2.0 * this->Energy.value(at) + this->Energy.value(at - step);
    const double bound = s.dot(hessian.lower().selfadjointView<Eigen::Lower>() * s);
    EXPECT_GE(bound, 0.0);
    EXPECT_GE(bound, second * (1.0 - 1e-3));
  }
}

// A sum over all squares of random matrices, against the dense sum. On a lattice of one square all nodes
// are at its border.
TEST(LatticeMatrix, IsTheSumOfItsSquares)
{
  for (const int squares : { 1, 2, 5 })
  {
    const DeformationLattice lattice({ Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 0.6) }, squares);
    LatticeMatrix sum(lattice);
    const int dofs = 2 * lattice.nodeCount();
    for (int round = 0; round < 2; ++round) // the second from zero again
    {
      sum.setZero();
      Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(dofs, dofs);
      for (int square = 0; square < lattice.columns() * lattice.rows(); ++square)
      {
        const Eigen::Vector2d centre(square % lattice.columns() + 0.5, square / lattice.columns() + 0.5);
        const std::array<int, 9> nodes = lattice.influenceOn(lattice.side() * centre).Nodes;
        const LatticeMatrix::SquareBlock block = LatticeMatrix::SquareBlock::Random();
        sum.add(nodes, block);
        for (int r = 0; r < 18; ++r)
        {
          for (int c = 0; c <= r; ++c)
          {
            expected(2 * nodes[r / 2] + r % 2, 2 * nodes[c / 2] + c % 2) += block(r, c);
          }
        }
      }
      EXPECT_LT((sum.lower().toDense() - expected).cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

TEST_F(DeformationEnergyOfAMap, IsInfiniteWhereThePlaneFolds)
{
  Points2 folded = Points2::Zero(this->Lattice.nodeCount(), 2);
  folded(this->Lattice.nodeCount() / 2, 0) = 10.0;
  EXPECT_TRUE(std::isinf(this->Energy.value(folded)));
}

// Points on the circle that must stay on it, and one that must stay where it is.
TEST_F(DeformationEnergyOfAMap, GradientOfKeptPointsIsThatOfDifferences)
{
  const UnitDisk disk;
  std::vector<DeformationEnergy::BoundaryPoint> points;
  for (int k = 0; k < 12; ++k)
  {
    points.push_back({ disk.at(0.5 * k), 0.5, k == 3 });
  }
  const Points2 at = this->displacements(0.03, 1);
  const double before = this->Energy.value(at);
  this->Energy.keepOnBoundary(disk, points);
  Eigen::VectorXd gradient;
  LatticeMatrix hessian(this->Lattice);
  const double value = this->Energy.derivatives(at, gradient, hessian);
  EXPECT_GT(value, 2.0 * before);
  EXPECT_NEAR(value, this->Energy.value(at), 1e-12 * value);
  for (int seed = 2; seed < 8; ++seed)
  {
    const Points2 step = this->displacements(1e-7, seed);
    const double difference = 0.5 * (this->Energy.value(at + step) - this->Energy.value(at - step));
    const double slope = gradient.dot(Eigen::Map<const Eigen::VectorXd>(step.data(), step.size()));
    EXPECT_NEAR(slope, difference, 1e-5 * std::abs(difference) + 1e-9);
  }
}

// The paraboloid's map to the disk has half of the area that it should have at the rim. Deformations
// in the disk that keep shapes where areas allow it give rings and sectors the areas that they should
// have.
TEST_F(DeformationEnergyOfAMap, DeformationInADiskSetsTheAreasOfRegionsRight)
{
  const std::vector<int> loop = requireDisk(this->Mesh);
  const auto disk = std::make_shared<UnitDisk>();
  const DegreesOfFreedom dofs(this->Mesh.vertexCount(), disk, loop, { 5 });
  DomainMap map{ this->Positions, {} };
  for (const int v : loop)
  {
    map.Positions.row(v).normalize();
  }
  map.BoundaryParameters = disk->parametersOf(map.Positions, loop);
  const Eigen::VectorXd areas = signedFaceAreas(map.Positions, this->Mesh.Faces);
  const Eigen::VectorXd targets = this->Targets * (areas.sum() / this->Targets.sum());
  const auto worstRegion = [&](const DomainMap& flat)
  {
    constexpr int regions = 12; // three rings of four sectors each
    Eigen::VectorXd has = Eigen::VectorXd::Zero(regions);
    Eigen::VectorXd wants = has;
    const Eigen::VectorXd now = signedFaceAreas(flat.Positions, this->Mesh.Faces);
    for (int f = 0; f < this->Mesh.faceCount(); ++f)
    {
      const Eigen::RowVector2d centre =
        this->Positions(this->Mesh.Faces.row(f), flattening::all).colwise().mean();
      const int ring = std::min(2, static_cast<int>(3.0 * centre.norm()));
      const int region = 4 * ring + 2 * (centre.x() > 0.0 ? 1 : 0) + (centre.y() > 0.0 ? 1 : 0);
      has[region] += now[f];
      wants[region] += targets[f];
    }
    return (has.array() / wants.array() - 1.0).abs().maxCoeff();
  };
  DomainMap deformed = map;
  for (int k = 0; k < 3; ++k)
  {
    deformed =
      smoothlyDeformed(this->Terms, dofs, deformed, targets, DeformationEnergy::Shapes::OfMap, 1e3);
  }
  EXPECT_GT(worstRegion(map), 0.1);
  EXPECT_LT(worstRegion(deformed), 2e-3);
  EXPECT_GT(signedFaceAreas(deformed.Positions, this->Mesh.Faces).minCoeff(), 0.0);
  EXPECT_TRUE(disk->areInOrder(deformed.BoundaryParameters));
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const Eigen::Vector2d place = deformed.Positions.row(loop[k]);
    EXPECT_LT((place - disk->at(deformed.BoundaryParameters[k])).norm(), 1e-15);
  }
  EXPECT_EQ(deformed.Positions.row(loop[5]), map.Positions.row(loop[5]));
}

} // namespace
