// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilterTest.h"
#include "FormulaVolumes.h"

#include <vtkBitArray.h>
#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::testing;

constexpr double Pi = 3.14159265358979323846;
struct Measures
{
  double Area = 0.0;
  double Volume = 0.0;
};

// By triangles and, for the volume, by the divergence theorem.
Measures measured(vtkPolyData* surface)
{
  Measures result;
  vtkNew<vtkIdList> corners;
  for (vtkIdType face = 0; face < surface->GetNumberOfCells(); ++face)
  {
    surface->GetCellPoints(face, corners);
    Eigen::Vector3d p[3];
    for (int k = 0; k < 3; ++k)
    {
      p[k] = Eigen::Vector3d(surface->GetPoint(corners->GetId(k)));
    }
    const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
    result.Area += 0.5 * normal.norm();
    result.Volume += p[0].dot(normal) / 6.0;
  }
  return result;
}

// The area of the ellipsoid with these half axes, by the midpoint rule over its parameters.
double ellipsoidArea(const Eigen::Vector3d& h)
{
  constexpr int N = 1000;
  double area = 0.0;
  for (int i = 0; i < N; ++i)
  {
    const double theta = Pi * (i + 0.5) / N;
    for (int j = 0; j < N; ++j)
    {
      const double phi = 2.0 * Pi * (j + 0.5) / N;
      const Eigen::Vector3d n(
        std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      // The cofactors of the map from the sphere scale normals by the products of the other two axes.
      const Eigen::Vector3d scaled(n[0] * h[1] * h[2], n[1] * h[0] * h[2], n[2] * h[0] * h[1]);
      area += scaled.norm() * std::sin(theta);
    }
  }
  return area * 2.0 * Pi * Pi / (static_cast<double>(N) * N);
}

TEST(VolumeToSurface, AnEllipsoidHasItsAreaAndVolume)
{
  const Eigen::Vector3d h(20.0, 16.0, 24.0);
  const auto volume = volumeOf(Eigen::Vector3d(60, 60, 64),
    [&h](const Eigen::Vector3d& p) { return 100.0 * (2.0 - p.cwiseQuotient(h).norm()); });
  const auto filter = filterAt(100.0, 0.0, volume);
  filter->Update();
  const Measures found = measured(filter->GetOutput());
  // A chord's sagitta is of second order: 2^2 / (8 x 16) of a voxel's length 2 at a radius of 16.
  EXPECT_NEAR(found.Area / ellipsoidArea(h), 1.0, 0.004);
  EXPECT_NEAR(found.Volume / (4.0 / 3.0 * Pi * h.prod()), 1.0, 0.004);
  EXPECT_EQ(figure(filter->GetOutput(), "Isovalue"), 100.0);
  EXPECT_EQ(figure(filter->GetOutput(), "IsosurfaceComponents"), 1);
  EXPECT_NEAR(ellipsoidArea(Eigen::Vector3d(3, 3, 3)), 36.0 * Pi, 1e-3); // the oracle itself
}

TEST(VolumeToSurface, SmoothingIsALengthWhateverTheShapeOfTheVoxels)
{
  // A Gaussian of standard deviation s adds s^2 / 2 times the Laplacian, here -5 x 2 / r: the surface of
  // a ball moves inwards by s^2 / r, the same along all axes.
  const double radius = 20.0;
  const double s = 3.0;
  const auto volume = volumeOf(
    Eigen::Vector3d(80, 80, 80), [radius](const Eigen::Vector3d& p) { return ball(p, radius); });
  const auto filter = filterAt(100.0, s, volume);
  filter->Update();
  double bounds[6];
  filter->GetOutput()->GetBounds(bounds);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(bounds[2 * k + 1] - bounds[2 * k], 2.0 * (radius - s * s / radius), 0.1) << k;
  }
  filter->AutomaticSmoothingOn();
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "SmoothingLength"), 2.0 * std::cbrt(1.0 * 1.25 * 2.0), 1e-12);
}

// VTK's filters write beyond their memory where a margin leaves the range of integers.
TEST(VolumeToSurface, VoxelsMayBeCountedFromTheLeastInteger)
{
  const auto volume =
    volumeOf(Eigen::Vector3d(60, 60, 60), [](const Eigen::Vector3d& p) { return ball(p, 20.0); });
  const auto filter = filterAt(100.0, 2.0, volume);
  filter->Update();
  const Measures expected = measured(filter->GetOutput());
  EXPECT_GT(expected.Area, 1000.0);

  vtkNew<vtkImageData> shifted;
  shifted->ShallowCopy(volume);
  const int least = std::numeric_limits<int>::min();
  const int* size = volume->GetDimensions();
  shifted->SetExtent(least, least + size[0] - 1, least, least + size[1] - 1, least, least + size[2] - 1);
  Eigen::Vector3d origin(volume->GetOrigin());
  origin -= static_cast<double>(least) * Eigen::Vector3d(VoxelSizes);
  shifted->SetOrigin(origin.data());
  filter->SetInputData(shifted);
  ErrorLog errors(filter);
  filter->Update();
  EXPECT_TRUE(errors.messages().empty());
  const Measures found = measured(filter->GetOutput());
  EXPECT_EQ(found.Area, expected.Area);
  EXPECT_EQ(found.Volume, expected.Volume) << "the voxels are where they were";
}

// The axes of a volume may be turned, and mirrored too.
TEST(VolumeToSurface, TheDirectionsOfTheAxesAreKept)
{
  const Eigen::Vector3d centre(5.0, 2.0, -4.0);
  const auto volume = volumeOf(Eigen::Vector3d(60, 60, 60),
    [&centre](const Eigen::Vector3d& p) {
      return 100.0 - 5.0 * ((p - centre).cwiseQuotient(Eigen::Vector3d(1.0, 1.2, 0.8)).norm() - 16.0);
    });
  const auto filter = filterAt(100.0, 2.0, volume);
  filter->Update();
  const Measures expected = measured(filter->GetOutput());
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  const Eigen::Vector3d origin(volume->GetOrigin());
  for (const double sign : { 1.0, -1.0 })
  {
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> direction = turned;
    direction.col(0) *= sign;
    volume->SetDirectionMatrix(direction.data());
    filter->Update();
    const Measures found = measured(filter->GetOutput());
    EXPECT_NEAR(found.Area, expected.Area, 1e-4 * expected.Area);
    EXPECT_NEAR(found.Volume, expected.Volume, 1e-4 * expected.Volume) << "and its outside is outside";
    double bounds[6];
    filter->GetOutput()->GetBounds(bounds);
    const Eigen::Vector3d place = origin + direction * (centre - origin);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(0.5 * (bounds[2 * k] + bounds[2 * k + 1]), place[k], 0.1);
    }
    // The first normal points away from the centre, too.
    const Eigen::Vector3d first(filter->GetOutput()->GetPoint(0));
    const Eigen::Vector3d normal(filter->GetOutput()->GetPointData()->GetNormals()->GetTuple3(0));
    EXPECT_GT(normal.dot((first - place).normalized()), 0.8);
  }
}

// A Gaussian that is wider than the volume has more voxels than fit in an integer. It leaves the mean.
TEST(VolumeToSurface, TheSmoothingMayBeWiderThanTheVolume)
{
  const auto volume =
    volumeOf(Eigen::Vector3d(60, 60, 60), [](const Eigen::Vector3d& p) { return ball(p, 20.0); });
  for (const double smoothing : { 100.0, 1e12, 1e300 })
  {
    const auto filter = filterAt(100.0, smoothing, volume);
    ErrorLog errors(filter);
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u) << smoothing;
    EXPECT_NE(
      errors.messages()[0].find("is not between the least and greatest value of the smoothed volume"),
      std::string::npos)
      << errors.messages()[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

// The greatest variance between two classes over all splits of the sorted values, and its split.
std::array<double, 3> bestSplit(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  double whole = 0.0;
  for (const double value : values)
  {
    whole += value;
  }
  double sum = 0.0;
  double greatest = 0.0;
  double low = 0.0;
  double high = 0.0;
  const auto n = static_cast<double>(values.size());
  for (std::size_t i = 0; i + 1 < values.size(); ++i)
  {
    sum += values[i];
    const double below = static_cast<double>(i) + 1.0;
    const double difference = sum / below - (whole - sum) / (n - below);
    const double variance = below / n * (1.0 - below / n) * difference * difference;
    if (variance > greatest)
    {
      greatest = variance;
      low = values[i];
      high = values[i + 1];
    }
  }
  double total = 0.0;
  for (const double value : values)
  {
    total += (value - whole / n) * (value - whole / n) / n;
  }
  return { low, high, greatest / total };
}

TEST(VolumeToSurface, TheSuggestedIsovalueIsOtsusThreshold)
{
  std::mt19937 random(7);
  std::normal_distribution<double> dark(-900.0, 60.0);
  std::normal_distribution<double> bright(80.0, 150.0);
  std::vector<double> values;
  const auto field = [&](const Eigen::Vector3d& p)
  {
    values.push_back(p.norm() < 14.0 ? bright(random) : dark(random));
    return values.back();
  };
  const auto volume = volumeOf(Eigen::Vector3d(40, 40, 40), field);
  vtkNew<vtkVolumeToSurface> filter;
  filter->SetInputData(volume);
  filter->Update();
  const auto [low, high, separation] = bestSplit(values);
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double bin = (*greatest - *least) / 1024.0;
  vtkPolyData* output = filter->GetOutput();
  EXPECT_GT(figure(output, "Isovalue"), low - bin);
  EXPECT_LT(figure(output, "Isovalue"), high + bin);
  EXPECT_NEAR(figure(output, "ClassSeparation"), separation, 1e-3);
  EXPECT_NEAR(figure(output, "MeanBelow"), -900.0, 5.0);
  EXPECT_NEAR(figure(output, "MeanAbove"), 80.0, 5.0);
  const auto brighter = std::count_if(
    values.begin(), values.end(), [&](double value) { return value > figure(output, "Isovalue"); });
  EXPECT_NEAR(figure(output, "ShareBelow"),
    1.0 - static_cast<double>(brighter) / static_cast<double>(values.size()),
    1e-3);
  // The histogram has every voxel once, on its side.
  vtkTable* histogram = filter->GetHistogram();
  double count = 0.0;
  for (vtkIdType row = 0; row < histogram->GetNumberOfRows(); ++row)
  {
    const bool below = histogram->GetValueByName(row, "Value").ToDouble() < figure(output, "Isovalue");
    EXPECT_EQ(histogram->GetValueByName(row, below ? "VoxelsAbove" : "VoxelsBelow").ToDouble(), 0.0);
    count += histogram->GetValueByName(row, below ? "VoxelsBelow" : "VoxelsAbove").ToDouble();
  }
  EXPECT_EQ(count, static_cast<double>(values.size()));
}

TEST(VolumeToSurface, WholeNumbersArePartedHalfway)
{
  const auto volume = volumeOf<vtkShortArray>(
    Eigen::Vector3d(40, 40, 40), [](const Eigen::Vector3d& p) { return p.norm() < 14.0 ? 100 : 20; });
  const auto filter = filterAt(50.0, 0.0, volume);
  filter->AutomaticIsovalueOn();
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "Isovalue"), 60.0, 0.5);
  EXPECT_NEAR(figure(filter->GetOutput(), "ClassSeparation"), 1.0, 1e-12);
  // Without smoothing, an isovalue that voxels have is moved down: they are inside.
  const auto exact = filterAt(100.0, 0.0, volume);
  exact->Update();
  EXPECT_EQ(figure(exact->GetOutput(), "Isovalue"), 99.5);
  exact->SetIsovalue(50.1);
  exact->Update();
  EXPECT_EQ(figure(exact->GetOutput(), "Isovalue"), 50.1) << "no voxel has it";
}

TEST(VolumeToSurface, AMarginClosesTheSurfaceAndVoxelsThatAreNotFiniteAreAir)
{
  // The ball reaches beyond the volume.
  const auto volume = volumeOf(Eigen::Vector3d(40, 40, 32),
    [](const Eigen::Vector3d& p)
    {
      return std::abs(p[0]) < 2.0 && std::abs(p[1]) < 2.0 && std::abs(p[2]) < 2.0 ? std::nan("")
                                                                                  : ball(p, 18.0);
    });
  const auto filter = filterAt(100.0, 0.0, volume);
  const auto openEdges = [](vtkPolyData* surface)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, int> faces;
    vtkNew<vtkIdList> corners;
    for (vtkIdType face = 0; face < surface->GetNumberOfCells(); ++face)
    {
      surface->GetCellPoints(face, corners);
      for (int k = 0; k < 3; ++k)
      {
        ++faces[std::minmax(corners->GetId(k), corners->GetId((k + 1) % 3))];
      }
    }
    return std::count_if(faces.begin(), faces.end(), [](const auto& edge) { return edge.second == 1; });
  };
  filter->Update();
  EXPECT_EQ(openEdges(filter->GetOutput()), 0);
  EXPECT_EQ(figure(filter->GetOutput(), "NotFiniteVoxels"), 3 * 3 * 1);
  EXPECT_EQ(figure(filter->GetOutput(), "IsosurfaceComponents"), 2); // one around the hole in it
  // Between 16, the last voxel, and the margin's first at 18.
  EXPECT_GT(filter->GetOutput()->GetBounds()[5], 16.0);
  EXPECT_LT(filter->GetOutput()->GetBounds()[5], 18.0);
  filter->SetMargin(0);
  filter->Update();
  EXPECT_GT(openEdges(filter->GetOutput()), 20);
}

TEST(VolumeToSurface, AVolumeOfBitsIsOneOfNumbers)
{
  const auto inside = [](const Eigen::Vector3d& p) { return ball(p, 6.0) > 100.0 ? 1.0 : 0.0; };
  const Eigen::Vector3d size(20, 20, 20);
  const auto bits = filterAt(0.5, 1.0, volumeOf<vtkBitArray>(size, inside));
  const auto bytes = filterAt(0.5, 1.0, volumeOf<vtkUnsignedCharArray>(size, inside));
  bits->Update();
  bytes->Update();
  ASSERT_EQ(bits->GetOutput()->GetNumberOfPoints(), bytes->GetOutput()->GetNumberOfPoints());
  ASSERT_GT(bits->GetOutput()->GetNumberOfPoints(), 100);
  for (vtkIdType i = 0; i < bits->GetOutput()->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(
      Eigen::Vector3d(bits->GetOutput()->GetPoint(i)), Eigen::Vector3d(bytes->GetOutput()->GetPoint(i)));
  }
}

TEST(VolumeToSurface, TheLargestComponentIsTheOneOfTheGreatestArea)
{
  const Eigen::Vector3d small(-12.0, 0.0, 0.0);
  const auto volume = volumeOf(Eigen::Vector3d(60, 40, 40),
    [&small](const Eigen::Vector3d& p)
    { return std::max(ball(p - Eigen::Vector3d(10, 0, 0), 12.0), ball(p - small, 6.0)); });
  const auto filter = filterAt(100.0, 0.0, volume);
  std::string warning;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&warning);
  listener->SetCallback([](vtkObject*, unsigned long, void* client, void* text)
    { *static_cast<std::string*>(client) = static_cast<const char*>(text); });
  filter->AddObserver(vtkCommand::WarningEvent, listener);
  filter->Update();
  const double big = 4.0 * Pi * 144.0;
  EXPECT_NEAR(measured(filter->GetOutput()).Area / big, 1.0, 0.02);
  EXPECT_EQ(figure(filter->GetOutput(), "IsosurfaceComponents"), 2);
  EXPECT_NEAR(figure(filter->GetOutput(), "LeftOutArea") / (4.0 * Pi * 36.0), 1.0, 0.03);
  EXPECT_NE(warning.find("1 other component of the isosurface, with an area of "), std::string::npos)
    << warning;
  EXPECT_NE(warning.find("was left out"), std::string::npos) << warning;
  warning.clear();
  filter->SetComponentModeToAll();
  filter->Update();
  EXPECT_NEAR(measured(filter->GetOutput()).Area / (big + 4.0 * Pi * 36.0), 1.0, 0.02);
  EXPECT_EQ(figure(filter->GetOutput(), "LeftOutArea"), 0.0);
  EXPECT_EQ(warning, "");
}

TEST(VolumeToSurface, AMirroringMatrixLeavesTheOutsideOutside)
{
  const auto volume =
    volumeOf(Eigen::Vector3d(40, 40, 40), [](const Eigen::Vector3d& p) { return ball(p, 12.0); });
  vtkNew<vtkDoubleArray> matrix;
  matrix->SetName("PatientMatrix");
  matrix->SetNumberOfComponents(16);
  const double rows[16] = { -1, 0, 0, 100, 0, 1, 0, 50, 0, 0, 1, 0, 0, 0, 0, 1 };
  matrix->InsertNextTuple(rows);
  volume->GetFieldData()->AddArray(matrix);
  const auto filter = filterAt(100.0, 0.0, volume);
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "InPatientSpace"), 1);
  EXPECT_NEAR(filter->GetOutput()->GetBounds()[0], 88.0, 0.2);
  EXPECT_NEAR(filter->GetOutput()->GetBounds()[3], 62.0, 0.2);
  EXPECT_GT(measured(filter->GetOutput()).Volume, 0.0);
  filter->PatientSpaceOff();
  filter->Update();
  EXPECT_NEAR(filter->GetOutput()->GetBounds()[0], -12.0, 0.2);
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("InPatientSpace"));
}

TEST(VolumeToSurface, BlocksAreDoneOneByOneAndAnAbortLeavesNothing)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(2);
  for (int k = 0; k < 2; ++k)
  {
    blocks->SetBlock(k,
      volumeOf(
        Eigen::Vector3d(40, 40, 40), [k](const Eigen::Vector3d& p) { return ball(p, 10.0 + 2.0 * k); }));
  }
  vtkNew<vtkVolumeToSurface> filter;
  filter->AutomaticIsovalueOff();
  filter->SetIsovalue(100.0);
  filter->AutomaticSmoothingOff();
  filter->SetSmoothing(0.0);
  filter->SetInputDataObject(blocks);
  filter->Update();
  auto* surfaces = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(surfaces, nullptr);
  for (int k = 0; k < 2; ++k)
  {
    const double radius = 10.0 + 2.0 * k;
    const Measures found = measured(vtkPolyData::SafeDownCast(surfaces->GetBlock(k)));
    EXPECT_NEAR(found.Area / (4.0 * Pi * radius * radius), 1.0, 0.02);
  }

  const auto single = filterAt(100.0, 1.0, vtkImageData::SafeDownCast(blocks->GetBlock(0)));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* running = vtkAlgorithm::SafeDownCast(caller);
      if (running->GetProgress() > 0.3)
      {
        running->SetAbortExecute(1);
      }
    });
  single->AddObserver(vtkCommand::ProgressEvent, stop);
  ErrorLog errors(single);
  single->Update();
  EXPECT_EQ(single->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(errors.messages().empty());
}

} // namespace
