// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "FilterTest.h"
#include "PassedGrid.h"

#include <vtkConformalDiskFilter.h>
#include <vtkFlatMapSlab.h>

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace
{

using namespace flattening;
using namespace flattening::testing;

constexpr double Pi = 3.14159265358979323846;
constexpr double Radius = 20.0;
constexpr double HalfSide = 30.0; // of the volume, around the sphere's centre

vtkSmartPointer<vtkPolyData> flatHemisphere()
{
  TriangleMesh mesh = analytic::sunflowerMesh(analytic::sphericalCap(0.5 * Pi), 4000).Mesh;
  mesh.Vertices *= Radius;
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(polyDataOf(mesh));
  conformal->Update();
  return conformal->GetOutput();
}

template <typename Array>
vtkSmartPointer<vtkImageData> volumeOf(const std::string& name,
  const std::function<double(double, double, double)>& value)
{
  auto volume = vtkSmartPointer<vtkImageData>::New();
  volume->SetDimensions(61, 61, 61);
  volume->SetOrigin(-HalfSide, -HalfSide, -HalfSide);
  volume->SetSpacing(1.0, 1.0, 1.0);
  vtkNew<Array> array;
  array->SetName(name.c_str());
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    double x[3];
    volume->GetPoint(i, x);
    array->InsertNextTuple1(value(x[0], x[1], x[2]));
  }
  volume->GetPointData()->SetScalars(array);
  return volume;
}

double distance(double x, double y, double z)
{
  return std::hypot(x, y, z);
}

void setDepths(vtkFlatMapSlab* slab, const std::vector<double>& depths)
{
  slab->ClearDepths();
  for (const double depth : depths)
  {
    slab->AddDepth(depth);
  }
}

class FlatMapSlab : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    Map = flatHemisphere();
    Distance = volumeOf<vtkDoubleArray>("Distance", distance);
  }
  static void TearDownTestSuite() { Map = Distance = nullptr; }
  static vtkSmartPointer<vtkDataObject> Map;
  static vtkSmartPointer<vtkDataObject> Distance;

  static void connect(vtkFlatMapSlab* slab)
  {
    slab->SetInputDataObject(0, Map);
    slab->SetInputDataObject(1, Distance);
  }
};

vtkSmartPointer<vtkDataObject> FlatMapSlab::Map;
vtkSmartPointer<vtkDataObject> FlatMapSlab::Distance;

// Linear interpolation of the distance is off by 1 / (4 r) at most in voxels of 1.
constexpr double InterpolationError = 0.017;

TEST_F(FlatMapSlab, AtEachDepthBelowASphereIsTheRadiusLessTheDepth)
{
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  const std::vector<double> depths{ 0.0, 1.0, 2.5, 5.0, -2.0 };
  setDepths(slab, depths);
  slab->Update();
  vtkPolyData* output = slab->GetOutput();
  vtkDataArray* values = output->GetPointData()->GetArray("DistanceSlab");
  ASSERT_NE(values, nullptr);
  ASSERT_EQ(values->GetNumberOfComponents(), 5);
  EXPECT_EQ(std::string(values->GetComponentName(2)), "2.5");
  double greatest = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    for (int d = 0; d < 5; ++d)
    {
      greatest = std::max(greatest, std::abs(values->GetComponent(i, d) - (Radius - depths[d])));
    }
  }
  std::cout << "greatest difference from radius - depth: " << greatest << " voxels\n";
  EXPECT_LT(greatest, InterpolationError);
  EXPECT_EQ(figure(output, "OutsideSamples"), 0);
  EXPECT_EQ(slab->GetDepth(2), 2.5);
  EXPECT_TRUE(std::isnan(slab->GetDepth(5)));
  EXPECT_EQ(output->GetFieldData()->GetArray("Depths")->GetTuple1(3), 5.0);

  slab->OutwardsOn();
  slab->Update();
  EXPECT_NEAR(output->GetPointData()->GetArray("DistanceSlab")->GetComponent(7, 3), 25.0, 0.017);
}

// In every layer of the stack, depth below the sphere.
void expectDistances(vtkImageData* stack, int size, int layers)
{
  ASSERT_EQ(stack->GetNumberOfPoints(), size * size * layers);
  vtkDataArray* values = stack->GetPointData()->GetArray("Distance");
  vtkDataArray* inside = stack->GetPointData()->GetArray("InVolume");
  double greatest = 0.0;
  int seen = 0;
  for (vtkIdType i = 0; i < stack->GetNumberOfPoints(); ++i)
  {
    double x[3];
    stack->GetPoint(i, x);
    ASSERT_EQ(inside->GetTuple1(i) == 1, !std::isnan(values->GetTuple1(i)));
    if (inside->GetTuple1(i) == 1)
    {
      greatest = std::max(greatest, std::abs(values->GetTuple1(i) - (Radius - x[2])));
      ++seen;
    }
  }
  // Triangles of edges up to 1.5 lie up to 1.5^2 / (6 R) below the sphere.
  std::cout << "greatest difference from radius - depth in the stack: " << greatest << " voxels\n";
  EXPECT_LT(greatest, InterpolationError + 0.02);
  EXPECT_NEAR(seen, layers * 0.25 * Pi * size * size, layers * size * 5 / 6);
}

// Voxels that are marked as hidden, as Resample To Image marks those without values, are sampled like
// all others by every version of VTK, and their marks are an array like the others.
TEST_F(FlatMapSlab, HiddenVoxelsKeepTheirValues)
{
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  vtkNew<vtkImageData> volume;
  volume->DeepCopy(Distance);
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    marks->InsertNextValue(i % 3 == 0 ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  volume->GetPointData()->AddArray(marks);
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  slab->SetInputDataObject(1, volume);
  setDepths(slab, { 0.0, 1.0 });
  slab->Update();
  vtkDataArray* values = slab->GetOutput()->GetPointData()->GetArray("DistanceSlab");
  ASSERT_NE(values, nullptr);
  double greatest = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    greatest = std::max(greatest, std::abs(values->GetComponent(i, 0) - Radius));
  }
  EXPECT_LT(greatest, InterpolationError);
}

TEST_F(FlatMapSlab, TheStackHasALayerPerDepth)
{
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  setDepths(slab, { 0.5, 1.0, 1.5, 2.0 });
  slab->SetStackSize(120);
  slab->Update();
  vtkImageData* stack = slab->GetStack();
  expectDistances(stack, 120, 4);

  // Steps that are not equal: one pixel apart.
  setDepths(slab, { 0.0, 1.0, 3.0 });
  slab->Update();
  EXPECT_EQ(stack->GetDimensions()[2], 3);
  EXPECT_DOUBLE_EQ(stack->GetSpacing()[2], stack->GetSpacing()[0]);
  EXPECT_EQ(stack->GetFieldData()->GetArray("Depths")->GetTuple1(2), 3.0);

  slab->SetStackSize(0);
  slab->Update();
  EXPECT_EQ(stack->GetNumberOfPoints(), 0);
}

TEST_F(FlatMapSlab, ImageFiltersSeeThePixelsOfTheStack)
{
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  setDepths(slab, { 0.5, 1.0, 1.5, 2.0 });
  slab->SetStackSize(50);
  expectGridPassedOn(slab->GetOutputPort(1), "InVolume");
  EXPECT_EQ(slab->GetStack()->GetSpacing()[2], 0.5);
}

TEST_F(FlatMapSlab, ImageFiltersSeeTheValuesOfTheStack)
{
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  setDepths(slab, { 0.5, 1.0 });
  slab->SetStackSize(30);
  const auto shorts =
    volumeOf<vtkShortArray>("Ramp", [](double x, double y, double) { return x + 100.0 * y; });
  for (const bool isNearest : { false, true })
  {
    for (vtkDataObject* volume : { Distance.Get(), static_cast<vtkDataObject*>(shorts) })
    {
      slab->SetNearestVoxel(isNearest);
      slab->SetInputDataObject(1, volume);
      expectScalarsPassedOn(slab->GetOutputPort(1));
    }
  }
}

// The stack has more pixels than are sampled at once.
TEST_F(FlatMapSlab, ALargeStackIsSampledInParts)
{
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  setDepths(slab, { 0.5, 2.0 });
  slab->SetStackSize(700);
  slab->Update();
  expectDistances(slab->GetStack(), 700, 2);
}

TEST_F(FlatMapSlab, OutsideOfTheVolumeIsMaskedAndCounted)
{
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  setDepths(slab, { 0.0, -15.0 });
  slab->Update();
  vtkPolyData* output = slab->GetOutput();
  vtkDataArray* values = output->GetPointData()->GetArray("DistanceSlab");
  vtkDataArray* mask = output->GetPointData()->GetArray("InVolume");
  vtkDataArray* surface = output->GetPointData()->GetArray("SurfacePoints");
  int outside = 0;
  int doubtful = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetTuple3(i);
    const double reach = 35.0 / Radius * std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
    doubtful += std::abs(reach - HalfSide) < 0.1;
    EXPECT_TRUE(
      std::abs(reach - HalfSide) < 0.1 || (reach < HalfSide) == (mask->GetComponent(i, 1) == 1));
    EXPECT_EQ(mask->GetComponent(i, 0), 1);
    EXPECT_EQ(std::isnan(values->GetComponent(i, 1)), mask->GetComponent(i, 1) == 0);
    outside += mask->GetComponent(i, 1) == 0;
  }
  EXPECT_LT(doubtful, 200);
  EXPECT_GT(outside, 500);
  EXPECT_EQ(figure(output, "OutsideSamples"), outside);
}

TEST_F(FlatMapSlab, OutsideOfThinVoxelsIsOutside)
{
  vtkNew<vtkImageData> sheet; // two voxels of 0.003 between z = 10 and 10.006, each 30 wide
  sheet->SetDimensions(3, 3, 3);
  sheet->SetOrigin(-HalfSide, -HalfSide, 10.0);
  sheet->SetSpacing(HalfSide, HalfSide, 0.003);
  sheet->AllocateScalars(VTK_FLOAT, 1);
  sheet->GetPointData()->GetScalars()->SetName("Value");
  sheet->GetPointData()->GetScalars()->Fill(7.0);
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  slab->SetInputDataObject(1, sheet);
  setDepths(slab, { 0.0 });
  slab->Update();
  vtkPolyData* output = slab->GetOutput();
  vtkDataArray* mask = output->GetPointData()->GetArray("InVolume");
  vtkDataArray* surface = output->GetPointData()->GetArray("SurfacePoints");
  int near = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double z = surface->GetComponent(i, 2);
    near += std::abs(z - 10.003) < 0.04;
    EXPECT_EQ(mask->GetTuple1(i), z >= 10.0 && z <= 10.006 ? 1.0 : 0.0) << z;
  }
  EXPECT_GT(near, 10); // a thousandth of a voxel's diagonal
}

TEST_F(FlatMapSlab, IntegersAreInterpolatedAndLabelsAreNot)
{
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  slab->SetVolumeData(volumeOf<vtkShortArray>("Ramp", [](double x, double, double) { return x; }));
  setDepths(slab, { 0.0 });
  slab->SetStackSize(0);
  slab->Update();
  vtkDataArray* ramp = slab->GetOutput()->GetPointData()->GetArray("RampSlab");
  vtkDataArray* surface = slab->GetOutput()->GetPointData()->GetArray("SurfacePoints");
  for (vtkIdType i = 0; i < ramp->GetNumberOfTuples(); ++i)
  {
    ASSERT_NEAR(ramp->GetTuple1(i), surface->GetComponent(i, 0), 1e-5);
  }

  slab->SetVolumeData(volumeOf<vtkShortArray>(
    "Label", [](double x, double y, double z) { return distance(x, y, z) < Radius ? 4.0 : 9.0; }));
  slab->NearestVoxelOn();
  slab->Update();
  vtkDataArray* labels = slab->GetOutput()->GetPointData()->GetArray("LabelSlab");
  int of[2] = { 0, 0 };
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    ASSERT_TRUE(labels->GetTuple1(i) == 4.0 || labels->GetTuple1(i) == 9.0) << labels->GetTuple1(i);
    ++of[labels->GetTuple1(i) == 9.0];
  }
  EXPECT_GT(std::min(of[0], of[1]), labels->GetNumberOfTuples() / 4);

  constexpr double large = 614454277.0; // more than single precision holds
  slab->SetVolumeData(
    volumeOf<vtkUnsignedIntArray>("Label", [](double, double, double) { return large; }));
  slab->SetStackSize(16);
  slab->Update();
  EXPECT_EQ(slab->GetOutput()->GetPointData()->GetArray("LabelSlab")->GetTuple1(7), large);
  EXPECT_EQ(slab->GetStack()->GetPointData()->GetArray("Label")->GetTuple1(8 * 16 + 8), large);
}

// With this spacing and origin, the centres of voxels are rounded, and VTK interpolates there.
TEST_F(FlatMapSlab, LabelsAreThoseOfVoxelsAtAnySpacing)
{
  const auto label = [](double x, double y, double z)
  { return std::fmod(std::abs(x + y + z), 2.0) < 0.5 ? 1017.0 : 2000.0; }; // neighbours all differ
  const auto volume = volumeOf<vtkIntArray>("Label", label);
  constexpr double voxel = 0.7;
  volume->SetSpacing(voxel, voxel, voxel);
  volume->SetOrigin(-voxel * HalfSide, -voxel * HalfSide, -voxel * HalfSide);
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  slab->SetVolumeData(volume);
  slab->NearestVoxelOn();
  setDepths(slab, { 0.0 });
  slab->SetStackSize(40);
  slab->Update();
  vtkDataArray* found = slab->GetOutput()->GetPointData()->GetArray("LabelSlab");
  vtkDataArray* surface = slab->GetOutput()->GetPointData()->GetArray("SurfacePoints");
  for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
  {
    double index[3];
    bool isClear = true; // whether one voxel is nearer than all others by more than rounding
    for (int k = 0; k < 3; ++k)
    {
      const double exact = surface->GetComponent(i, k) / voxel;
      index[k] = std::round(exact);
      isClear &= std::abs(exact - index[k]) < 0.5 - 1e-9;
    }
    ASSERT_TRUE(!isClear || found->GetTuple1(i) == label(index[0], index[1], index[2]))
      << found->GetTuple1(i);
  }
  vtkDataArray* stack = slab->GetStack()->GetPointData()->GetArray("Label");
  for (vtkIdType i = 0; i < stack->GetNumberOfTuples(); ++i)
  {
    const double value = stack->GetTuple1(i);
    ASSERT_TRUE(value == 1017.0 || value == 2000.0 || std::isnan(value)) << value;
  }
}

TEST_F(FlatMapSlab, EmptyInputGivesEmptyOutputs)
{
  vtkNew<vtkFlatMapSlab> slab;
  connect(slab);
  ErrorLog errors(slab);
  slab->SetInputData(vtkNew<vtkPolyData>());
  slab->Update();
  EXPECT_EQ(slab->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(slab->GetStack()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(errors.messages().empty());
}

TEST_F(FlatMapSlab, ReportsWhatIsWrong)
{
  vtkNew<vtkFlatMapSlab> slab;
  const auto expectMessage = [&slab](const std::string& words)
  {
    ErrorLog errors(slab);
    slab->Update();
    ASSERT_EQ(errors.messages().size(), 1u) << words;
    EXPECT_NE(errors.messages().front().find(words), std::string::npos) << errors.messages().front();
    EXPECT_EQ(slab->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_EQ(slab->GetStack()->GetNumberOfPoints(), 0);
  };
  connect(slab);
  slab->ClearDepths();
  expectMessage("no depth");
  setDepths(slab, { 1.0, 1.0 });
  expectMessage("given twice");
  setDepths(slab, { std::numeric_limits<double>::quiet_NaN() });
  expectMessage("not a number");
  setDepths(slab, { -100.0 });
  expectMessage("no sample lies in the volume");
  setDepths(slab, { 0.0 });
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 4);
  slab->SetVolumeData(bare);
  expectMessage("no numbers at its points");
  vtkNew<vtkImageData> thin;
  thin->DeepCopy(Distance);
  thin->SetSpacing(1.0, 1.0, 0.0);
  slab->SetVolumeData(thin);
  expectMessage("a voxel has the size 0 along axis 3");
  connect(slab);
  slab->SetInputData(polyDataOf(analytic::ringMesh(analytic::flatDisk(), 100).Mesh));
  expectMessage("no point array SurfacePoints");
  vtkNew<vtkPolyData> bent;
  bent->DeepCopy(Map);
  bent->GetPoints()->SetPoint(3, 0.0, 0.0, 1.0);
  slab->SetInputData(bent);
  slab->SetStackSize(16);
  expectMessage("the input is not flat");
  vtkNew<vtkPolyData> shrunk;
  shrunk->DeepCopy(Map);
  for (vtkIdType i = 0; i < shrunk->GetNumberOfPoints(); ++i)
  {
    shrunk->GetPoints()->SetPoint(i, i, 0.0, 0.0);
  }
  slab->SetInputData(shrunk);
  expectMessage("the flat map or its surface has no area");
  slab->SetStackSize(0);
  connect(slab);
  ErrorLog errors(slab);
  slab->Update();
  EXPECT_TRUE(errors.messages().empty());
  EXPECT_GT(slab->GetOutput()->GetNumberOfCells(), 1000);
}

// The names are those of the arrays that ParaView's Resample To Image, this filter and its probe add.
TEST_F(FlatMapSlab, AVolumeMayHaveAnArrayOfAnyName)
{
  const auto volume = volumeOf<vtkDoubleArray>("Distance", distance);
  for (const char* name : { "vtkValidPointMask", "InVolume", "0" })
  {
    vtkNew<vtkUnsignedCharArray> mask;
    mask->SetName(name);
    mask->SetNumberOfTuples(volume->GetNumberOfPoints());
    mask->FillValue(7);
    volume->GetPointData()->AddArray(mask);
  }
  vtkNew<vtkFlatMapSlab> slab;
  slab->SetInputData(flatHemisphere());
  slab->SetVolumeData(volume);
  slab->SetStackSize(16);
  slab->Update();
  auto* map = vtkPolyData::SafeDownCast(slab->GetOutputDataObject(0));
  for (const char* name : { "vtkValidPointMaskSlab", "InVolumeSlab", "0Slab" })
  {
    vtkDataArray* array = map->GetPointData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    EXPECT_EQ(array->GetComponent(5, 1), 7.0) << name;
  }
  EXPECT_NEAR(map->GetPointData()->GetArray("DistanceSlab")->GetComponent(5, 1), Radius - 1.0, 0.02);
  EXPECT_EQ(map->GetPointData()->GetArray("InVolume")->GetComponent(5, 1), 1.0);
}

// Two maps and two volumes go together block by block; one volume serves all maps.
TEST_F(FlatMapSlab, BlocksGoTogether)
{
  const auto map = flatHemisphere();
  vtkNew<vtkMultiBlockDataSet> maps;
  vtkNew<vtkMultiBlockDataSet> volumes;
  for (unsigned int block = 0; block < 2; ++block)
  {
    maps->SetBlock(block, map);
    volumes->SetBlock(
      block, volumeOf<vtkDoubleArray>("Block", [block](double, double, double) { return block + 3.0; }));
  }
  vtkNew<vtkFlatMapSlab> slab;
  ErrorLog errors(slab);
  slab->SetStackSize(8);
  slab->SetInputDataObject(0, maps);
  slab->SetInputDataObject(1, volumes);
  const auto valueIn = [&slab](unsigned int block)
  {
    auto* output = vtkMultiBlockDataSet::SafeDownCast(slab->GetOutputDataObject(0));
    auto* data = output ? vtkPolyData::SafeDownCast(output->GetBlock(block)) : nullptr;
    return data ? data->GetPointData()->GetArray("BlockSlab")->GetComponent(7, 0) : -1.0;
  };
  slab->Update();
  EXPECT_EQ(vtkMultiBlockDataSet::SafeDownCast(slab->GetOutputDataObject(0))->GetNumberOfBlocks(), 2u);
  EXPECT_EQ(valueIn(0), 3.0);
  EXPECT_EQ(valueIn(1), 4.0);
  auto* stacks = vtkMultiBlockDataSet::SafeDownCast(slab->GetOutputDataObject(1));
  ASSERT_NE(vtkImageData::SafeDownCast(stacks->GetBlock(1)), nullptr);
  EXPECT_EQ(vtkImageData::SafeDownCast(stacks->GetBlock(1))->GetDimensions()[0], 8);
  slab->SetInputDataObject(1, volumes->GetBlock(1));
  slab->Update();
  EXPECT_EQ(valueIn(0), 4.0);
  EXPECT_EQ(valueIn(1), 4.0);
  EXPECT_TRUE(errors.messages().empty());

  volumes->SetBlock(0, map);
  slab->SetInputDataObject(1, volumes);
  slab->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(
    errors.messages().front().find("it is a vtkPolyData, not an image: remove"), std::string::npos)
    << errors.messages().front();
  EXPECT_EQ(valueIn(0), -1.0);
  EXPECT_EQ(valueIn(1), 4.0);
}

} // namespace
