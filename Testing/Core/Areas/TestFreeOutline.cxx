// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/AreaPreservingDisk.h"
#include "Areas/FreeOutline.h"
#include "Base/Errors.h"
#include "Conformal/ConformalDisk.h"
#include "Disk/SurfaceToDisk.h"
#include "FlatMap/DistortionMeasures.h"
#include "FlatMap/DistortionSummary.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/OutlineCrossings.h"
#include "Support/RandomSurfaces.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

AreaPreservingMap diskMap(const TriangleMesh& surface, const Eigen::VectorXd& weights = {})
{
  return areaPreservingDiskMap(surface, conformalDiskMap(surface).Positions, weights).Map;
}

AreaPreservingMap freeMap(const TriangleMesh& surface,
  const Eigen::VectorXd& weights = {},
  const ProgressCallback& progress = {})
{
  AreaPreservingOptions options;
  options.FreeOutline = true;
  return areaPreservingDiskMap(surface, conformalDiskMap(surface).Positions, weights, options, progress)
    .Map;
}

DistortionSummary summaryOf(const TriangleMesh& surface,
  const Points2& positions,
  const Eigen::VectorXd& weights = {})
{
  return summariseDistortion(measureDistortion(surface, positions, weights));
}

// A rectangle of squares, each cut in two along alternating diagonals, in space.
TriangleMesh sheet(int columns, int rows, const std::function<Eigen::RowVector3d(double, double)>& place)
{
  TriangleMesh mesh;
  mesh.Vertices.resize((columns + 1) * (rows + 1), 3);
  mesh.Faces.resize(2 * columns * rows, 3);
  int face = 0;
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const int v = j * (columns + 1) + i;
      mesh.Vertices.row(v) = place(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
      if (i == columns || j == rows)
      {
        continue;
      }
      const int up = v + columns + 1;
      if ((i + j) % 2 == 0)
      {
        mesh.Faces.row(face++) << v, v + 1, up + 1;
        mesh.Faces.row(face++) << v, up + 1, up;
      }
      else
      {
        mesh.Faces.row(face++) << v, v + 1, up;
        mesh.Faces.row(face++) << v + 1, up + 1, up;
      }
    }
  }
  return mesh;
}

struct Developable
{
  std::string Name;
  TriangleMesh Surface;
};

std::vector<Developable> developables()
{
  const double turn = 2.0 * EIGEN_PI;
  const auto cone = [turn](double u, double v, double sine) -> Eigen::RowVector3d
  {
    const double r = 1.0 + v;
    return {
      sine * r * std::cos(turn * u), sine * r * std::sin(turn * u), -r * std::sqrt(1.0 - sine * sine)
    };
  };
  return { { "Sheet", sheet(30, 30, [](double u, double v) { return Eigen::RowVector3d(u, v, 0.0); }) },
    { "Strip", sheet(90, 15, [](double u, double v) { return Eigen::RowVector3d(6.0 * u, v, 0.0); }) },
    { "Cylinder", // cut along a straight seam, whose banks lie on each other
      sheet(60,
        20,
        [turn](double u, double v)
        { return Eigen::RowVector3d(std::cos(turn * u), std::sin(turn * u), 2.0 * v); }) },
    { "Cone", sheet(60, 20, [cone](double u, double v) { return cone(u, v, 0.5); }) },
    { "WideCone", sheet(80, 15, [cone](double u, double v) { return cone(u, v, 0.9); }) },
    { "FoldedPaper",
      sheet(30,
        30,
        [](double u, double v)
        {
          return u < 0.5 ? Eigen::RowVector3d(u, v, 0.0)
                         : Eigen::RowVector3d(0.5 + 0.6 * (u - 0.5), v, 0.8 * (u - 0.5));
        }) } };
}

// The greatest relative error of the length of an edge. The map has the area of the unit disk.
double greatestLengthError(const TriangleMesh& surface, const Points2& positions)
{
  const double scale = std::sqrt(faceAreas(surface.Vertices, surface.Faces).sum() / EIGEN_PI);
  double greatest = 0.0;
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = surface.Faces(f, k);
      const int b = surface.Faces(f, (k + 1) % 3);
      const double length = (surface.Vertices.row(a) - surface.Vertices.row(b)).norm();
      const double flat = scale * (positions.row(a) - positions.row(b)).norm();
      greatest = std::max(greatest, std::abs(flat / length - 1.0));
    }
  }
  return greatest;
}

class FreeOutlineOfADevelopable : public testing::TestWithParam<Developable>
{
};

// What can be unrolled is unrolled: every edge keeps its length. Its map to the disk does not.
TEST_P(FreeOutlineOfADevelopable, KeepsEveryLength)
{
  const TriangleMesh& surface = this->GetParam().Surface;
  const AreaPreservingMap map = freeMap(surface);
  EXPECT_TRUE(map.IsFree);
  EXPECT_TRUE(map.Bijective);
  EXPECT_LT(greatestLengthError(surface, map.Positions), 1e-5);
  EXPECT_GT(greatestLengthError(surface, diskMap(surface).Positions), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Surfaces,
  FreeOutlineOfADevelopable,
  testing::ValuesIn(developables()),
  [](const testing::TestParamInfo<Developable>& info) { return info.param.Name; });

// An accordion of 300 : 1 that no conformal disk holds: its ends would shrink to nothing. The map by
// mean values serves.
TEST(FreeOutline, UnrollsAStripThatNoDiskHolds)
{
  const int folds = 30;
  const TriangleMesh strip = sheet(1200,
    4,
    [folds](double u, double v)
    {
      const double along = 300.0 * u;
      const double inFold = std::fmod(along, 300.0 / folds);
      const double height = std::min(inFold, 300.0 / folds - inFold);
      return Eigen::RowVector3d(0.6 * along, v, 0.8 * height);
    });
  EXPECT_THROW(conformalDiskMap(strip), ConvergenceError);
  ConformalDiskOptions meanValue;
  meanValue.Method = ConformalMethod::MeanValue;
  AreaPreservingOptions options;
  options.FreeOutline = true;
  const AreaPreservingMap map =
    areaPreservingDiskMap(strip, conformalDiskMap(strip, meanValue).Positions, {}, options).Map;
  EXPECT_TRUE(map.IsFree);
  EXPECT_TRUE(map.Bijective);
  EXPECT_LT(greatestLengthError(strip, map.Positions), 1e-5);
}

// A bump on an ellipse, twice as long as wide.
TEST(FreeOutline, KeepsAreasAndBettersAngles)
{
  TriangleMesh surface = sunflowerMesh(gaussianBump(1.0, 0.35), 6000).Mesh;
  surface.Vertices.col(0) *= 2.0;
  const AreaPreservingMap map = freeMap(surface);
  EXPECT_TRUE(map.Bijective);
  EXPECT_EQ(map.FlippedFaces, 0);
  EXPECT_TRUE(isSimpleOutline(map.Positions, requireDisk(surface)));
  EXPECT_NEAR(signedFaceAreas(map.Positions, surface.Faces).sum(), EIGEN_PI, 1e-9);
  const DistortionSummary freed = summaryOf(surface, map.Positions);
  const DistortionSummary onDomain = summaryOf(surface, diskMap(surface).Positions);
  EXPECT_GE(freed.FacesWithin2Percent, 99.5);
  EXPECT_LE(freed[Measure::AngleError].Mean, 0.8 * onDomain[Measure::AngleError].Mean);
}

// From another map to the disk, the map has another rotation, and its cells are the same.
TEST(FreeOutline, CellsAreThoseOfTheMapItself)
{
  const TriangleMesh surface = sunflowerMesh(gaussianBump(1.0, 0.35), 2000).Mesh;
  const Points2 conformal = conformalDiskMap(surface).Positions;
  Points2 moved(conformal.rows(), 2); // by a Moebius transformation of the disk
  for (Eigen::Index v = 0; v < conformal.rows(); ++v)
  {
    const std::complex<double> z(conformal(v, 0), conformal(v, 1));
    const std::complex<double> image = (z - 0.4) / (1.0 - 0.4 * z);
    moved.row(v) << image.real(), image.imag();
  }
  AreaPreservingOptions options;
  options.FreeOutline = true;
  const AreaPreservingMap map = areaPreservingDiskMap(surface, conformal, {}, options).Map;
  const AreaPreservingMap other = areaPreservingDiskMap(surface, moved, {}, options).Map;
  ASSERT_TRUE(map.IsFree && other.IsFree);
  const Eigen::VectorXd weights = map.PowerWeights.array() - map.PowerWeights.mean();
  const Eigen::VectorXd others = other.PowerWeights.array() - other.PowerWeights.mean();
  EXPECT_GT(weights.norm(), 0.01);
  EXPECT_LT((weights - others).norm(), 1e-4 * weights.norm());
}

// An isosurface has no symmetry that the disk could share.
TEST(FreeOutline, OfAnUnevenSheetIsMuchBetterThanTheDisk)
{
  const TriangleMesh surface = sheet(80,
    25,
    [](double u, double v)
    {
      return Eigen::RowVector3d(
        4.0 * u, v + 0.3 * std::sin(6.0 * u), 0.15 * std::sin(9.0 * u) * std::cos(7.0 * v));
    });
  const AreaPreservingMap map = freeMap(surface);
  EXPECT_TRUE(map.Bijective);
  const DistortionSummary freed = summaryOf(surface, map.Positions);
  EXPECT_GE(freed.FacesWithin2Percent, 99.5);
  EXPECT_LE(freed[Measure::AngleError].Mean,
    0.25 * summaryOf(surface, diskMap(surface).Positions)[Measure::AngleError].Mean);
}

// A part grows beside the rest. Where that needs more room than a free outline can make, shapes may get
// worse for the sake of areas, or the map stays in the disk.
TEST(FreeOutline, TakesWeights)
{
  const RevolutionMesh mesh = sunflowerMesh(sphericalCap(1.2), 3000);
  for (const double factor : { 3.0, 30.0, 1e3, 1e6 })
  {
    Eigen::VectorXd weights(mesh.Mesh.vertexCount());
    for (int v = 0; v < mesh.Mesh.vertexCount(); ++v)
    {
      const Eigen::Vector2d place = mesh.Mesh.Vertices.row(v).head<2>();
      weights[v] = std::pow(factor, std::exp(-8.0 * (place - Eigen::Vector2d(0.4, 0.2)).squaredNorm()));
    }
    const AreaPreservingMap map = freeMap(mesh.Mesh, weights);
    EXPECT_TRUE(map.Bijective) << factor;
    const DistortionSummary freed = summaryOf(mesh.Mesh, map.Positions, weights);
    const Points2 onDisk = diskMap(mesh.Mesh, weights).Positions;
    const DistortionSummary onDomain = summaryOf(mesh.Mesh, onDisk, weights);
    EXPECT_GE(freed.FacesWithin2Percent, onDomain.FacesWithin2Percent - 1.0) << factor;
    EXPECT_LE(freed[Measure::AngleError].Mean, onDomain[Measure::AngleError].Mean + 1.5) << factor;
    const bool isOnDisk = (map.Positions.array() == onDisk.array()).all();
    EXPECT_EQ(isOnDisk, !map.IsFree) << factor << ": what is not freed is the map to the disk";
  }
}

TEST(FreeOutline, SameBitsWhateverTheThreads)
{
  const TriangleMesh surface = sunflowerMesh(gaussianBump(1.5, 0.35), 9000).Mesh;
  const Points2 expected = freeMap(surface).Positions;
  for (const std::size_t threads : { 1, 2, 4 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_TRUE((freeMap(surface).Positions.array() == expected.array()).all()) << threads;
  }
}

// Cancels maps before the transport to the disk; TestAreaPreservingDisk cancels that.
void expectCancellable(const TriangleMesh& surface, double step)
{
  std::vector<double> fractions;
  freeMap(surface,
    {},
    [&](double fraction, const char*)
    {
      if (fractions.empty() || fraction != fractions.back())
      {
        fractions.push_back(fraction);
      }
      return true;
    });
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
  double last = 0.0;
  for (const double stop : fractions)
  {
    if (stop >= last + step && stop < 0.7)
    {
      EXPECT_THROW(
        freeMap(surface, {}, [stop](double fraction, const char*) { return fraction < stop; }),
        Cancelled);
      last = stop;
    }
  }
  EXPECT_GT(last, 0.6);
}

// The second surface is large enough for a coarse disk.
TEST(FreeOutline, CancelsAnywhere)
{
  expectCancellable(sunflowerMesh(gaussianBump(1.0, 0.3), 300).Mesh, 0.02);
  expectCancellable(sunflowerMesh(gaussianBump(1.0, 0.3), 5000).Mesh, 0.06);
}

// Checks the map of a generated surface, which has some hundred or thousand points.
void expectFreed(int seed, double leastShare, double greatestError)
{
  const TriangleMesh surface = surfaceToDisk(samples::randomSurface(seed).Mesh, {}).Surface.Mesh;
  const AreaPreservingMap map = freeMap(surface);
  EXPECT_TRUE(map.IsFree) << seed;
  EXPECT_TRUE(map.Bijective) << seed;
  EXPECT_FALSE(map.WarmStarted) << seed;
  const DistortionSummary freed = summaryOf(surface, map.Positions);
  EXPECT_GE(freed.FacesWithin2Percent, leastShare) << seed;
  EXPECT_LE(freed[Measure::AngleError].Mean, greatestError) << seed;
}

// In the disk most of these surfaces have angle errors above 27 degrees. Parts of their outlines come
// near each other: without a scaffold these press against each other, and up to six tenths of the faces
// are wrong.
TEST(FreeOutline, DoesNotPressPartsOfTheOutlineTogether)
{
  for (const int seed : { 22, 36, 37, 81, 139, 175, 246 })
  {
    expectFreed(seed, 99.0, 16.0);
  }
  expectFreed(39, 99.0, 18.0);
  expectFreed(138, 99.0, 19.0);
}

// The map of an earlier run is the start for other targets, wherever it lies and however large it is.
// The result differs from that without a start, and is as good.
TEST(FreeOutline, GoesOnFromAnEarlierMap)
{
  const RevolutionMesh mesh = sunflowerMesh(gaussianBump(1.0, 0.35), 4000);
  const TriangleMesh& surface = mesh.Mesh;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(surface.vertexCount());
  for (int v = 0; v < surface.vertexCount(); ++v)
  {
    weights[v] = surface.Vertices(v, 0) > 0.5 ? 1.5 : 1.0;
  }
  const AreaPreservingMap once = freeMap(surface);
  AreaPreservingOptions options;
  options.FreeOutline = true;
  options.Start.Positions = 3.0 * once.Positions;
  const Points2 conformal = conformalDiskMap(surface).Positions;
  const AreaPreservingMap next = areaPreservingDiskMap(surface, conformal, weights, options).Map;
  EXPECT_TRUE(next.IsFree);
  EXPECT_TRUE(next.WarmStarted);
  EXPECT_TRUE(next.Bijective);
  const AreaPreservingMap cold = freeMap(surface, weights);
  EXPECT_FALSE(cold.WarmStarted);
  EXPECT_FALSE((next.Positions.array() == cold.Positions.array()).all());
  const DistortionSummary warm = summaryOf(surface, next.Positions, weights);
  const DistortionSummary anew = summaryOf(surface, cold.Positions, weights);
  EXPECT_GE(warm.FacesWithin2Percent, anew.FacesWithin2Percent - 0.5);
  EXPECT_LE(warm[Measure::AngleError].Mean, anew[Measure::AngleError].Mean + 0.5);
  // A map to the disk is no start.
  options.Start.Positions = diskMap(surface).Positions;
  EXPECT_FALSE(areaPreservingDiskMap(surface, conformal, weights, options).Map.WarmStarted);
}

TEST(FreeOutline, DoesNotBeginWithAMapThatIsNotOneToOne)
{
  const TriangleMesh surface = sunflowerMesh(gaussianBump(1.0, 0.35), 500).Mesh;
  const std::vector<int> loop = requireDisk(surface);
  Points2 positions = surface.Vertices.leftCols<2>();
  positions.row(0) += Eigen::RowVector2d(0.3, 0.0); // flips faces around the centre
  const auto map = [&](const Points2& before)
  {
    return freeOutlineMap(
      surface, loop, before, faceAreas(surface.Vertices, surface.Faces), EIGEN_PI, 1e-3);
  };
  const auto wrong = map(positions);
  const auto none = map({});
  ASSERT_TRUE(wrong && none);
  EXPECT_FALSE(wrong->WarmStarted);
  EXPECT_TRUE((wrong->Positions.array() == none->Positions.array()).all());
}

TEST(FreeOutline, NeedsTheFaceRefinement)
{
  const TriangleMesh surface = sunflowerMesh(flatDisk(), 500).Mesh;
  AreaPreservingOptions options;
  options.FreeOutline = true;
  options.RefineFaces = false;
  EXPECT_THROW(
    areaPreservingDiskMap(surface, surface.Vertices.leftCols<2>(), {}, options), InvalidInput);
}

} // namespace
