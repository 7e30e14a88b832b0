// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/RefinementEnergy.h"
#include "Areas/TargetAreas.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace
{

using namespace flattening;

// A flat map of a paraboloid with its vertices shaken, its gradient and Hessian.
class RefinementEnergyOfAMap : public testing::Test
{
protected:
  RefinementEnergyOfAMap()
    : Mesh(analytic::sunflowerMesh(analytic::paraboloid(0.8), 300).Mesh)
    , FacesOf(Mesh.Faces, Mesh.vertexCount())
    , Loop(requireDisk(Mesh))
    , Dofs(Mesh.vertexCount(), std::make_shared<UnitDisk>(), Loop, { 0 })
    , Terms(Mesh, Loop, Dofs.domain().perimeter(), 0.01)
    , Energy(Terms, FacesOf, Dofs)
  {
    const Eigen::VectorXd areas = faceAreas(Mesh.Vertices, Mesh.Faces);
    Eigen::VectorXd counts(areas.size());
    for (Eigen::Index f = 0; f < counts.size(); ++f)
    {
      counts[f] = 1.0 + 0.2 * std::sin(static_cast<double>(f));
    }
    this->Energy.setTargets(areas * (EIGEN_PI / areas.sum()), areaWeights(areas), counts);
    this->Energy.setEpsilon(0.1);
    this->Map.Positions = Mesh.Vertices.leftCols<2>();
    for (Eigen::Index i = 0; i < this->Map.Positions.size(); ++i)
    {
      this->Map.Positions.data()[i] += 0.02 * std::sin(17.0 * static_cast<double>(i));
    }
    this->Map.BoundaryParameters.resize(static_cast<Eigen::Index>(Loop.size()));
    const double first = this->Dofs.domain().parameterOf(Mesh.Vertices.row(Loop[0]).head<2>());
    for (std::size_t k = 0; k < Loop.size(); ++k)
    {
      const double share = static_cast<double>(k) / static_cast<double>(Loop.size());
      this->Map.BoundaryParameters[k] = first + 2.0 * EIGEN_PI * (share + 0.01 * std::sin(5.0 * share));
      this->Map.Positions.row(Loop[k]) = this->Dofs.domain().at(this->Map.BoundaryParameters[k]);
    }
    this->Energy.setEnclosed(this->Map);
  }

  Eigen::VectorXd randomStep(int seed) const
  {
    Eigen::VectorXd step(this->Dofs.count());
    for (Eigen::Index i = 0; i < step.size(); ++i)
    {
      step[i] = std::sin(1.3 * static_cast<double>((i + 1) * (seed + 2) % 9973));
    }
    return step / step.norm();
  }

  TriangleMesh Mesh;
  VertexFaces FacesOf;
  std::vector<int> Loop;
  DegreesOfFreedom Dofs;
  RefinementTerms Terms;
  RefinementEnergy Energy;
  DomainMap Map;
};

TEST_F(RefinementEnergyOfAMap, HasOneUnknownOnTheBoundaryTwoInsideAndNoneInACorner)
{
  const int inside = this->Mesh.vertexCount() - static_cast<int>(this->Loop.size());
  EXPECT_EQ(this->Dofs.count(), 2 * inside + static_cast<int>(this->Loop.size()) - 1);
}

TEST_F(RefinementEnergyOfAMap, GradientMatchesDifferences)
{
  this->Energy.evaluate(this->Map);
  const Eigen::VectorXd gradient = this->Energy.gradient(this->Map);
  for (int seed = 0; seed < 10; ++seed)
  {
    const Eigen::VectorXd step = this->randomStep(seed);
    constexpr double length = 1e-5;
    const double up = this->Energy.evaluate(this->Dofs.moved(this->Map, step, length));
    const double down = this->Energy.evaluate(this->Dofs.moved(this->Map, step, -length));
    EXPECT_NEAR(gradient.dot(step), (up - down) / (2.0 * length), 1e-6 * gradient.norm());
  }
}

// Half of the bound of what could be indefinite is in the Hessian: it may fall short of a second
// difference, but only by a part of it.
// An interval whose share is a hundredth of its length in the map.
TEST_F(RefinementEnergyOfAMap, ATinyIntervalIsHeld)
{
  BoundaryInterval& interval = this->Terms.Intervals[5];
  interval.Share *= 0.01;
  const double free = this->Energy.evaluate(this->Map);
  interval.LimitWeight = 20.0;
  const double value = this->Energy.evaluate(this->Map);
  const double length = this->Map.BoundaryParameters[6] - this->Map.BoundaryParameters[5];
  const double excess = length / interval.Share / 3.0 - 1.0;
  ASSERT_GT(excess, 10.0);
  EXPECT_NEAR(value - free, 20.0 * excess * excess, 1e-9 * value);
  const Eigen::VectorXd gradient = this->Energy.gradient(this->Map);
  const SparseMatrix hessian = this->Energy.hessian(this->Map);
  for (int seed = 0; seed < 10; ++seed)
  {
    const Eigen::VectorXd step = this->randomStep(seed);
    constexpr double size = 1e-5;
    const double up = this->Energy.evaluate(this->Dofs.moved(this->Map, step, size));
    const double down = this->Energy.evaluate(this->Dofs.moved(this->Map, step, -size));
    EXPECT_NEAR(gradient.dot(step), (up - down) / (2.0 * size), 1e-6 * gradient.norm());
    const double second = step.dot(hessian.selfadjointView<Eigen::Lower>() * step);
    EXPECT_NEAR(second, (up - 2.0 * value + down) / (size * size), 0.01 * second);
  }
}

TEST_F(RefinementEnergyOfAMap, HessianIsPositiveAndNearlyTheSecondDerivative)
{
  const double value = this->Energy.evaluate(this->Map);
  const SparseMatrix hessian = this->Energy.hessian(this->Map);
  for (int seed = 0; seed < 10; ++seed)
  {
    const Eigen::VectorXd step = this->randomStep(seed);
    const Eigen::VectorXd product = hessian.selfadjointView<Eigen::Lower>() * step;
    constexpr double length = 1e-4;
    const double up = this->Energy.evaluate(this->Dofs.moved(this->Map, step, length));
    const double down = this->Energy.evaluate(this->Dofs.moved(this->Map, step, -length));
    const double second = (up - 2.0 * value + down) / (length * length);
    EXPECT_GT(step.dot(product), 0.0);
    EXPECT_NEAR(step.dot(product), second, 0.3 * std::abs(second));
  }
}

// Sums of a second call must not hold anything of the first.
TEST_F(RefinementEnergyOfAMap, HessianStartsAnewEveryTime)
{
  this->Energy.evaluate(this->Map);
  const SparseMatrix first = this->Energy.hessian(this->Map);
  const SparseMatrix second = this->Energy.hessian(this->Map);
  EXPECT_EQ((first - second).norm(), 0.0);
}

// A weight of 4 on half of the surface, whose faces then have four times their area for target: they
// count a quarter as much as the others, so that all count by their area on the surface.
TEST(FaceCounts, AreInverseToWeights)
{
  const TriangleMesh mesh = analytic::sunflowerMesh(analytic::paraboloid(0.8), 300).Mesh;
  const Eigen::VectorXd areas = faceAreas(mesh.Vertices, mesh.Faces);
  const Eigen::Index half = areas.size() / 2;
  Eigen::VectorXd targets = areas;
  targets.head(half) *= 4.0;
  const Eigen::VectorXd counts = faceCounts(mesh, targets);
  const double scale = targets.sum() / areas.sum();
  EXPECT_LT((counts.head(half).array() - 0.25 * scale).abs().maxCoeff(), 1e-14);
  EXPECT_LT((counts.tail(areas.size() - half).array() - scale).abs().maxCoeff(), 1e-14);
  EXPECT_TRUE((faceCounts(mesh, areas).array() == 1.0).all());
}

// Five faces of a mean target of 0.62: those below half of it count as if they were so large, up to 20
// times their own area.
TEST(AreaWeights, LetSmallFacesCountLikeLargerOnes)
{
  Eigen::VectorXd targets(5);
  targets << 1.0, 1.0, 1.0, 0.1, 0.001;
  Eigen::VectorXd expected(5);
  expected << 1.0, 1.0, 1.0, 3.101, 20.0;
  EXPECT_LT((areaWeights(targets) - expected).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((areaWeights(1e-9 * targets) - expected).cwiseAbs().maxCoeff(), 1e-12);
}

} // namespace
