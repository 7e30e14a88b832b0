// SPDX-License-Identifier: GPL-3.0-or-later
// After a change of weights the map is found from the one before.
#include "AnalyticSurfaces.h"
#include "Areas/AreaPreservingDisk.h"
#include "Areas/WarmStart.h"
#include "Conformal/ConformalDisk.h"
#include "FlatMap/DistortionSummary.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"
#include "Transport/BoundaryPlacement.h"
#include "Transport/DomainPolygon.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <string>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using samples::Pi;

struct Bump
{
  TriangleMesh Mesh = sunflowerMesh(gaussianBump(1.0, 0.3), 12000).Mesh;
  Points2 Conformal = conformalDiskMap(Mesh).Positions;

  Eigen::VectorXd weights(double factor) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Ones(this->Mesh.vertexCount());
    for (int v = 0; v < this->Mesh.vertexCount(); ++v)
    {
      const bool inside =
        (this->Mesh.Vertices.row(v).head<2>() - Eigen::RowVector2d(0.4, 0.2)).norm() < 0.2;
      result[v] = inside ? factor : 1.0;
    }
    return result;
  }
};

AreaPreservingOptions from(const AreaPreservingMap& former)
{
  AreaPreservingOptions options;
  options.Start.PowerWeights = former.PowerWeights;
  options.Start.Positions = former.Positions;
  return options;
}

// How far the area of the faces inside the region is from what it should be.
double regionError(const TriangleMesh& mesh, const Points2& flat, const Eigen::VectorXd& weights)
{
  const Eigen::VectorXd has = signedFaceAreas(flat, mesh.Faces);
  const Eigen::VectorXd wants = faceTargets(mesh, weights);
  double hasSum = 0.0;
  double wantsSum = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    if (weights[mesh.Faces(f, 0)] != 1.0 && weights[mesh.Faces(f, 1)] != 1.0 &&
        weights[mesh.Faces(f, 2)] != 1.0)
    {
      hasSum += has[f];
      wantsSum += wants[f];
    }
  }
  return std::abs((hasSum / has.sum()) / (wantsSum / wants.sum()) - 1.0);
}

TEST(WarmStart, AWeightIsChangedToTheSameAccuracyAsFromTheBeginning)
{
  const Bump bump;
  AreaPreservingMap former = areaPreservingDiskMap(bump.Mesh, bump.Conformal).Map;
  EXPECT_FALSE(former.WarmStarted);
  for (const double factor : { 2.0, 4.0, 0.5, 1.1 })
  {
    const Eigen::VectorXd weights = bump.weights(factor);
    const AreaPreservingMap cold = areaPreservingDiskMap(bump.Mesh, bump.Conformal, weights).Map;
    const AreaPreservingMap warm =
      areaPreservingDiskMap(bump.Mesh, bump.Conformal, weights, from(former)).Map;
    EXPECT_TRUE(warm.WarmStarted);
    EXPECT_TRUE(warm.Bijective);
    EXPECT_EQ(countFlippedFaces(warm.Positions, bump.Mesh.Faces), 0);
    EXPECT_LE(warm.MaxCellError, 1e-6);
    EXPECT_LT((warm.CellAreas - cold.CellAreas).cwiseAbs().maxCoeff() / cold.CellAreas.minCoeff(), 2e-5);
    const auto summary = [&](const AreaPreservingMap& map)
    { return summariseDistortion(measureDistortion(bump.Mesh, map.Positions, weights)); };
    const DistortionSummary is = summary(warm);
    const DistortionSummary was = summary(cold);
    const double region = regionError(bump.Mesh, warm.Positions, weights);
    std::cout << "factor " << factor << ": faces within 2 % " << is.FacesWithin2Percent << " ("
              << was.FacesWithin2Percent << "), angle error " << is[Measure::AngleError].Mean << " ("
              << was[Measure::AngleError].Mean << "), region " << region << " ("
              << regionError(bump.Mesh, cold.Positions, weights) << "), rounds " << warm.RefinementRounds
              << " (" << cold.RefinementRounds << ")\n";
    EXPECT_GE(is.FacesWithin2Percent, 99.4);
    EXPECT_GE(is.FacesWithin2Percent, was.FacesWithin2Percent - 0.3);
    EXPECT_LE(is[Measure::AngleError].Mean, was[Measure::AngleError].Mean + 1.0);
    EXPECT_LT(region, 1e-3);
    former = warm;
  }
}

// Nothing has changed, and nothing is to be done.
TEST(WarmStart, TheSameWeightsKeepTheMap)
{
  const Bump bump;
  const Eigen::VectorXd weights = bump.weights(3.0);
  const AreaPreservingMap former = areaPreservingDiskMap(bump.Mesh, bump.Conformal, weights).Map;
  const AreaPreservingMap again =
    areaPreservingDiskMap(bump.Mesh, bump.Conformal, weights, from(former)).Map;
  EXPECT_TRUE(again.WarmStarted);
  EXPECT_EQ(again.NewtonIterations, 0);
  EXPECT_LT((again.Positions - former.Positions).rowwise().norm().maxCoeff(), 1e-3);
}

TEST(WarmStart, SameBitsWhateverTheThreads)
{
  const Bump bump;
  const AreaPreservingMap former = areaPreservingDiskMap(bump.Mesh, bump.Conformal).Map;
  const auto warm = [&]
  {
    return areaPreservingDiskMap(bump.Mesh, bump.Conformal, bump.weights(2.0), from(former))
      .Map.Positions;
  };
  const Points2 expected = warm();
  for (const std::size_t threads : { 1, 4 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_TRUE((warm().array() == expected.array()).all()) << threads;
  }
}

// Without usable positions the map is the one that the power weights alone lead to, in every bit.
TEST(WarmStart, PositionsThatAreNoMapToTheDomainCountForNothing)
{
  const TriangleMesh mesh = ringMesh(sphericalCap(0.5 * Pi), 2000).Mesh;
  const Points2 conformal = conformalDiskMap(mesh).Positions;
  const AreaPreservingMap former = areaPreservingDiskMap(mesh, conformal).Map;
  AreaPreservingOptions options = from(former);
  options.Start.Positions.resize(0, 2);
  const Points2 expected = areaPreservingDiskMap(mesh, conformal, {}, options).Map.Positions;
  const int last = mesh.vertexCount() - 1; // on the boundary
  std::vector<Points2> bad(6, former.Positions);
  bad[0](3, 1) = std::numeric_limits<double>::quiet_NaN();
  bad[1] *= 1.01;
  bad[2].row(0) = Eigen::RowVector2d(0.9, 0.0);      // flips faces
  bad[3].row(last) = former.Positions.row(last - 1); // out of order
  bad[4].conservativeResize(last, 2);                // too few
  bad[5].col(0) *= -1.0;                             // mirrored
  for (std::size_t k = 0; k < bad.size(); ++k)
  {
    options.Start.Positions = bad[k];
    const AreaPreservingMap map = areaPreservingDiskMap(mesh, conformal, {}, options).Map;
    EXPECT_FALSE(map.WarmStarted) << k;
    EXPECT_TRUE((map.Positions.array() == expected.array()).all()) << k;
  }
  options = from(former);
  options.Refinement.AngleWeight = 0.3;
  EXPECT_FALSE(areaPreservingDiskMap(mesh, conformal, {}, options).Map.WarmStarted);
}

TEST(WarmStart, PolygonsKeepTheirCorners)
{
  const TriangleMesh mesh = ringMesh(sphericalCap(0.5 * Pi), 5000).Mesh;
  const Points2 conformal = conformalDiskMap(mesh).Positions;
  Points2 triangle(3, 2);
  triangle << 0.0, 0.0, 3.0, 0.0, 1.0, 2.0;
  const Points2 corners = domainPolygon(triangle).Corners;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(mesh.vertexCount());
  weights.head(mesh.vertexCount() / 20).setConstant(2.0); // around the pole
  for (const bool fixed : { false, true })
  {
    const auto map = [&](const Eigen::VectorXd& given, const AreaPreservingOptions& options)
    {
      return areaPreservingPolygonMap(mesh, conformal, UnitDisk(), { corners, fixed }, given, options)
        .Map;
    };
    const AreaPreservingMap warm = map(weights, from(map({}, {})));
    EXPECT_TRUE(warm.WarmStarted);
    EXPECT_TRUE(warm.Bijective);
    EXPECT_GE(
      summariseDistortion(measureDistortion(mesh, warm.Positions, weights)).FacesWithin2Percent, 99.0);
    for (Eigen::Index k = 0; fixed && k < 3; ++k)
    {
      EXPECT_LT((warm.Positions.rowwise() - corners.row(k)).rowwise().norm().minCoeff(), 1e-14);
    }
  }
}

// Faces inside and outside of the region are nearly right before any refinement.
TEST(WarmStart, IsCarriedByTheTransport)
{
  const Bump bump;
  const UnitDisk disk;
  const std::vector<int> loop = requireDisk(bump.Mesh);
  const Eigen::VectorXd weights = bump.weights(2.0);
  const AreaPreservingResult before = areaPreservingDiskMap(bump.Mesh, bump.Conformal);
  const AreaPreservingResult after =
    areaPreservingDiskMap(bump.Mesh, bump.Conformal, weights, from(before.Map));
  const TransportSites sites{ before.Diagram.sites(), before.SiteOfVertex };
  const auto transported = [&](const AreaPreservingResult& result) {
    return siteImages(result.Diagram, sites.sums(result.Map.TargetAreas), sites, { loop, {}, {} });
  };
  const Points2& positions = before.Map.Positions;
  const SiteImages start = transported(before);
  const auto within = [&](const Points2& flat)
  { return summariseDistortion(measureDistortion(bump.Mesh, flat, weights)).FacesWithin2Percent; };
  const Points2 carried = carriedMap(positions, sites, start, transported(after), loop, disk);
  std::cout << "faces within 2 %: " << within(positions) << ", carried " << within(carried) << "\n";
  EXPECT_GT(within(carried), 75.0);
  EXPECT_LT(within(positions), 50.0);
  EXPECT_LE(countFlippedFaces(carried, bump.Mesh.Faces), 0);
  for (const int v : loop)
  {
    EXPECT_NEAR(carried.row(v).norm(), 1.0, 1e-15);
  }
  const Points2 same = carriedMap(positions, sites, start, start, loop, disk);
  EXPECT_LT((same - positions).rowwise().norm().maxCoeff(), 1e-12);
}

} // namespace
