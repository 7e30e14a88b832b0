// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../Core/Support/SampleSurfaces.h"
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkSurfaceToDiskFilter.h>

#include <vtkCellData.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPolyDataConnectivityFilter.h>

#include <cmath>

namespace
{

using namespace flattening;
using namespace flattening::testing;

// A ring whose tube is narrow at one place, where a handle is cut: radius 2, of the tube 0.6 at x = 2,
// 0.25 at x = -2.
vtkSmartPointer<vtkPolyData> narrowedRing()
{
  constexpr int Around = 48;
  constexpr int Across = 24;
  TriangleMesh mesh = samples::torus(Around, Across);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double u = 2.0 * samples::Pi * (v / Across) / Around;
    const double w = 2.0 * samples::Pi * (v % Across) / Across;
    const double tube = 0.425 + 0.175 * std::cos(u);
    const double radius = 2.0 + tube * std::cos(w);
    mesh.Vertices.row(v) << radius * std::cos(u), radius * std::sin(u), tube * std::sin(w);
  }
  auto data = polyDataOf(mesh);
  addTiles(data, 0.5);
  return data;
}

Image imageOfArray(vtkPolyData* surface, const char* array)
{
  colourBy(surface, array, 0.0, 8.0);
  return imageOf(surface, { {}, { 0.0, -0.5, 1.0 }, { 0.0, 1.0, 0.0 }, 2.8 });
}

int boundaryLoops(vtkPolyData* surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->NonManifoldEdgesOff();
  vtkNew<vtkPolyDataConnectivityFilter> loops;
  loops->SetInputConnection(edges->GetOutputPort());
  loops->SetExtractionModeToAllRegions();
  loops->Update();
  return loops->GetNumberOfExtractedRegions();
}

TEST(SurfaceToDisk, CutsAHandleAndAHole)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetInputData(narrowedRing());
  filter->UseHolePointOn();
  filter->SetHolePoint(2.0, 0.0, 0.6);
  filter->SetHoleAreaFraction(0.06);
  filter->Update();
  vtkPolyData* disk = filter->GetOutput();
  expectBaseline(imageOfArray(disk, "Tile"), "SurfaceToDisk");

  EXPECT_EQ(figure(disk, "Genus"), 1.0);
  EXPECT_EQ(figure(disk, "RemovedHandles"), 1.0);
  EXPECT_NEAR(figure(disk, "HandleLoopLengths"), 2.0 * samples::Pi * 0.25, 0.02);
  EXPECT_NEAR(figure(disk, "RemovedArea") / (figure(disk, "RemovedArea") + figure(disk, "SurfaceArea")),
    0.06,
    0.01);
  EXPECT_EQ(boundaryLoops(disk), 1);

  expectNotBaseline(imageOfArray(disk, "Filled"), "SurfaceToDisk", "another array");
  filter->SetHolePoint(0.0, 2.0, 0.425);
  filter->Update();
  expectNotBaseline(
    imageOfArray(filter->GetOutput(), "Tile"), "SurfaceToDisk", "a hole at another place");
}

} // namespace
