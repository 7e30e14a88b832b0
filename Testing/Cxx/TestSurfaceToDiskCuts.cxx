// SPDX-License-Identifier: GPL-3.0-or-later
/// The second output of vtkSurfaceToDiskFilter: the cuts as lines, and the numbers of the seams.
#include "FilterTest.h"
#include "SurfaceToDiskChecks.h"

#include <vtkConformalDiskFilter.h>
#include <vtkFeatureEdges.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace disk_tests;

// A sphere of radius 10 with four fingers.
vtkSmartPointer<vtkPolyData> fingers()
{
  const double tips[4][3] = {
    { 0.0, 0.6, 0.8 }, { 0.94, 0.28, -0.19 }, { -0.57, 0.77, -0.28 }, { -0.31, -0.8, -0.51 }
  };
  auto result = sphere(80);
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    double x[3];
    result->GetPoint(i, x);
    double radius = 20.0; // that of the source is 0.5
    for (const auto& tip : tips)
    {
      const double angle =
        std::acos(std::clamp(2.0 * (x[0] * tip[0] + x[1] * tip[1] + x[2] * tip[2]), -1.0, 1.0));
      radius += 16.0 * std::exp(-angle * angle / 0.09);
    }
    result->GetPoints()->SetPoint(i, radius * x[0], radius * x[1], radius * x[2]);
  }
  return result;
}

vtkSmartPointer<vtkPolyData> half(vtkPolyData* surface)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToPlane();
  filter->SetPlaneNormal(0.0, 0.3, 1.0);
  return run(filter, surface);
}

double total(vtkPolyData* cuts, bool ofSeams)
{
  double length = 0.0;
  for (vtkIdType c = 0; c < cuts->GetNumberOfCells(); ++c)
  {
    const bool isSeam = cuts->GetCellData()->GetArray("SeamId")->GetTuple1(c) != 0.0;
    length += isSeam == ofSeams ? cuts->GetCellData()->GetArray("Length")->GetTuple1(c) : 0.0;
  }
  return length;
}

// The greatest distance of a point of one set from the nearest one of the other.
double distanceFrom(vtkPolyData* from, vtkPolyData* to)
{
  double greatest = 0.0;
  for (vtkIdType i = 0; i < from->GetNumberOfPoints(); ++i)
  {
    double x[3];
    from->GetPoint(i, x);
    double y[3];
    to->GetPoint(to->FindPoint(x), y);
    greatest = std::max(greatest, std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
  }
  return greatest;
}

void expectCuts(vtkPolyData* output, vtkPolyData* cuts, const char* name)
{
  ASSERT_GT(cuts->GetNumberOfLines(), 0) << name;
  EXPECT_EQ(cuts->GetNumberOfLines(), cuts->GetNumberOfCells()) << name;
  const double length = figure(output, "BoundaryLength");
  EXPECT_NEAR(total(cuts, true), figure(output, "SeamLength"), 1e-12 * length) << name;
  EXPECT_NEAR(2.0 * total(cuts, true) + total(cuts, false), length, 1e-12 * length) << name;
  EXPECT_EQ(figure(cuts, "SeamLength"), figure(output, "SeamLength")) << name;
  // Every point has the number of the smallest line that it is on.
  vtkNew<vtkIdList> points;
  std::map<vtkIdType, int> smallest;
  int before = 0;
  for (vtkIdType c = 0; c < cuts->GetNumberOfCells(); ++c)
  {
    const auto id = static_cast<int>(cuts->GetCellData()->GetArray("SeamId")->GetTuple1(c));
    EXPECT_TRUE(id == before + 1 || id == 0) << name << ": numbered in order, then the borders";
    before = id;
    cuts->GetCellPoints(c, points);
    for (vtkIdType k = 0; k < points->GetNumberOfIds() && id > 0; ++k)
    {
      int& entry = smallest.emplace(points->GetId(k), id).first->second;
      entry = std::min(entry, id);
    }
  }
  for (vtkIdType i = 0; i < cuts->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(cuts->GetPointData()->GetArray("SeamId")->GetTuple1(i), smallest[i]) << name;
  }
}

TEST(SurfaceToDiskCuts, AreTheBoundaryOfTheDisk)
{
  const auto closed = fingers();
  const auto open = half(closed);
  struct Case
  {
    const char* Name;
    vtkPolyData* Surface;
    int Cut;
    int Handles;
    bool HasSeam;
    bool HasBorder;
  };
  const auto ring = torus(60, 30);
  using Filter = vtkSurfaceToDiskFilter;
  for (const Case& test : { Case{ "hole", closed, Filter::HOLE, 0, false, true },
         Case{ "plane", closed, Filter::PLANE, 0, false, true },
         Case{ "seam", closed, Filter::SEAM, 0, true, false },
         Case{ "relief", closed, Filter::RELIEF, 0, true, false },
         Case{ "automatic", closed, Filter::AUTOMATIC, 0, true, false },
         Case{ "open", open, Filter::HOLE, 0, false, true },
         Case{ "relief of an open one", open, Filter::RELIEF, 0, true, true },
         Case{ "handle", ring, Filter::HOLE, Filter::CUT_HANDLES, true, false },
         Case{ "handle and relief", ring, Filter::RELIEF, Filter::CUT_HANDLES, true, false } })
  {
    vtkNew<vtkSurfaceToDiskFilter> filter;
    filter->SetCutMode(test.Cut);
    filter->SetHandleMode(test.Handles);
    const auto output = run(filter, test.Surface);
    expectDisk(output);
    expectCuts(output, filter->GetCuts(), test.Name);
    EXPECT_EQ(total(filter->GetCuts(), true) > 0.0, test.HasSeam) << test.Name;
    EXPECT_EQ(total(filter->GetCuts(), false) > 0.0, test.HasBorder) << test.Name;
  }
}

// Cut along the lines of an automatic cut, the surface is cut alike: within the edges of the mesh, which
// are up to 1.5 long on the fingers, as the cut leaves out points of the lines that are closer to each
// other. Borders are left out.
// On this sphere all ways from pole to pole are equally short.
TEST(SurfaceToDiskCuts, ASeamGetsTheVerticesAskedForOnASymmetricSurface)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(20);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetCutMode(vtkSurfaceToDiskFilter::SEAM);
  for (const int vertices : { 128, 300, 400, 800 })
  {
    flattening::testing::ErrorLog errors(filter);
    filter->SetMinimumBoundaryVertices(vertices);
    filter->Update();
    EXPECT_TRUE(errors.messages().empty()) << vertices;
    EXPECT_GE(figure(filter->GetOutput(), "BoundaryVertices"), vertices);
    EXPECT_LT(filter->GetOutput()->GetNumberOfCells(), 20000);
  }
}

// Coordinates are normalised beyond 2^33.
TEST(SurfaceToDiskCuts, TheHoleIsWhereItIsWhateverTheSize)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(20);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetCutMode(vtkSurfaceToDiskFilter::HOLE);
  filter->Update();
  const vtkIdType expected = filter->GetOutput()->GetNumberOfPoints();
  for (const int exponent : { -33, -32, 31, 32 })
  {
    sphere->SetRadius(0.5 * std::ldexp(1.9, exponent));
    filter->Update();
    EXPECT_NEAR(filter->GetOutput()->GetNumberOfPoints(), expected, 20) << exponent;
  }
}

TEST(SurfaceToDiskCuts, CanBeCutAlongAgain)
{
  const auto closed = fingers();
  const auto open = half(closed);
  for (vtkPolyData* surface : { closed.Get(), open.Get() })
  {
    vtkNew<vtkSurfaceToDiskFilter> automatic;
    automatic->SetCutModeToRelief();
    const auto first = run(automatic, surface);
    vtkNew<vtkSurfaceToDiskFilter> again;
    again->SetCutModeToSeam();
    again->SetSeamLinesConnection(automatic->GetOutputPort(1));
    const auto second = run(again, surface);
    expectDisk(second);
    EXPECT_EQ(figure(second, "ChosenCut"), vtkSurfaceToDiskFilter::SEAM);
    vtkPolyData* before = automatic->GetCuts();
    vtkPolyData* after = again->GetCuts();
    ASSERT_EQ(after->GetNumberOfCells(), before->GetNumberOfCells());
    constexpr double Edge = 1.5;
    for (vtkIdType c = 0; c < after->GetNumberOfCells(); ++c)
    {
      const double length = before->GetCellData()->GetArray("Length")->GetTuple1(c);
      EXPECT_NEAR(after->GetCellData()->GetArray("Length")->GetTuple1(c), length, 0.5) << c;
    }
    EXPECT_LT(distanceFrom(before, after), Edge);
    EXPECT_LT(distanceFrom(after, before), Edge);
    EXPECT_NEAR(
      figure(second, "SeamLength"), figure(first, "SeamLength"), 0.005 * figure(first, "SeamLength"));
  }
}

// The numbers start at the first point.
TEST(SurfaceToDiskCuts, StartAtTheFirstSeamPoint)
{
  const double ends[2][3] = { { 0.5, 0.0, 0.0 }, { 0.0, 0.3, 0.4 } };
  for (const int first : { 0, 1 })
  {
    vtkNew<vtkSurfaceToDiskFilter> filter;
    filter->SetCutModeToSeam();
    filter->UseSeamPointsOn();
    for (const int end : { first, 1 - first })
    {
      filter->AddSeamPoint(ends[end][0], ends[end][1], ends[end][2]);
    }
    const auto output = run(filter, sphere(60));
    vtkPolyData* cuts = filter->GetCuts();
    ASSERT_EQ(cuts->GetNumberOfCells(), 1);
    double x[3];
    cuts->GetPoint(0, x);
    EXPECT_LT(std::hypot(x[0] - ends[first][0], x[1] - ends[first][1], x[2] - ends[first][2]), 0.01);
    double range[2];
    output->GetPointData()->GetArray("SeamDistance")->GetRange(range);
    EXPECT_EQ(range[0], 0.0);
    EXPECT_NEAR(range[1], figure(output, "SeamLength"), 1e-12);
  }
}

// The boundary of a flat map has both banks of each piece: as many edges with the same numbers and
// distances, which differ in place.
TEST(SurfaceToDiskCuts, AreFoundOnTheFlatMap)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetInputData(fingers());
  filter->SetCutModeToRelief();
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputConnection(filter->GetOutputPort());
  vtkNew<vtkOMTAreaPreservingFilter> flat;
  flat->SetInputConnection(conformal->GetOutputPort());
  vtkNew<vtkFeatureEdges> boundary;
  boundary->SetInputConnection(flat->GetOutputPort());
  boundary->FeatureEdgesOff();
  boundary->NonManifoldEdgesOff();
  boundary->Update();
  vtkPolyData* banks = boundary->GetOutput();
  vtkDataArray* ids = banks->GetPointData()->GetArray("SeamId");
  vtkDataArray* distances = banks->GetPointData()->GetArray("SeamDistance");
  ASSERT_TRUE(ids && distances);
  std::map<std::pair<double, double>, int> copies; // by number and distance
  for (vtkIdType i = 0; i < banks->GetNumberOfPoints(); ++i)
  {
    EXPECT_GE(ids->GetTuple1(i), 1.0);
    ++copies[{ ids->GetTuple1(i), distances->GetTuple1(i) }];
  }
  vtkPolyData* cuts = filter->GetCuts();
  EXPECT_EQ(static_cast<vtkIdType>(copies.size()), cuts->GetNumberOfPoints());
  std::map<vtkIdType, int> meeting; // edges of the cuts at each of their points
  vtkNew<vtkIdList> line;
  for (vtkIdType c = 0; c < cuts->GetNumberOfCells(); ++c)
  {
    cuts->GetCellPoints(c, line);
    for (vtkIdType k = 0; k + 1 < line->GetNumberOfIds(); ++k)
    {
      ++meeting[line->GetId(k)];
      ++meeting[line->GetId(k + 1)];
    }
  }
  for (vtkIdType i = 0; i < cuts->GetNumberOfPoints(); ++i)
  {
    const double id = cuts->GetPointData()->GetArray("SeamId")->GetTuple1(i);
    const double distance = cuts->GetPointData()->GetArray("SeamDistance")->GetTuple1(i);
    EXPECT_EQ((copies[{ id, distance }]), meeting[i]);
  }
}

TEST(SurfaceToDiskCuts, OfBlocksAreBlocks)
{
  vtkNew<vtkMultiBlockDataSet> surfaces;
  surfaces->SetBlock(0, fingers());
  surfaces->SetBlock(2, half(fingers()));
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToRelief();
  filter->SetInputData(surfaces);
  filter->Update();
  EXPECT_EQ(filter->GetCuts(), nullptr);
  auto* disks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* cuts = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_TRUE(disks && cuts);
  ASSERT_EQ(cuts->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(cuts->GetBlock(1), nullptr);
  for (const unsigned int block : { 0u, 2u })
  {
    auto* lines = vtkPolyData::SafeDownCast(cuts->GetBlock(block));
    ASSERT_TRUE(lines) << block;
    expectCuts(vtkPolyData::SafeDownCast(disks->GetBlock(block)), lines, "block");
  }

  // Each block is cut along its own lines.
  vtkNew<vtkSurfaceToDiskFilter> again;
  again->SetCutModeToSeam();
  again->SetInputData(surfaces);
  again->SetSeamLinesConnection(filter->GetOutputPort(1));
  again->Update();
  auto* second = vtkMultiBlockDataSet::SafeDownCast(again->GetOutputDataObject(1));
  for (const unsigned int block : { 0u, 2u })
  {
    auto* lines = vtkPolyData::SafeDownCast(second->GetBlock(block));
    ASSERT_TRUE(lines) << block;
    EXPECT_EQ(
      lines->GetNumberOfCells(), vtkPolyData::SafeDownCast(cuts->GetBlock(block))->GetNumberOfCells());
  }
}

} // namespace
