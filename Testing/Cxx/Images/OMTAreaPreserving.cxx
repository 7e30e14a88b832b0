// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkConformalDiskFilter.h>
#include <vtkOMTAreaPreservingFilter.h>

#include <vtkNew.h>
#include <vtkPoints.h>

#include <cmath>

namespace
{

using namespace flattening::analytic;
using namespace flattening::testing;

Image imageOfTiles(vtkPolyData* flat)
{
  colourBy(flat, "Tile", 0.0, 8.0);
  View view;
  view.Size = 300;
  return imageOf(flat, view);
}

class OMTAreaPreserving : public testing::Test
{
protected:
  OMTAreaPreserving()
  {
    const auto data = polyDataOf(this->Bump.Mesh);
    addTiles(data, 1.0 / 6.0);
    this->Conformal->SetInputData(data);
    this->Conformal->SetNormalizeToUnitDomain();
    // These two points determine the map, so that the image does not depend on the solver.
    this->Conformal->UseCenterPointOn();
    this->Conformal->SetCenterPoint(this->Bump.Mesh.Vertices.row(0).data());
    this->Conformal->UseBoundaryPointOn();
    this->Conformal->SetBoundaryPoint(
      this->Bump.Mesh.Vertices.row(this->Bump.FirstBoundaryVertex).data());
    this->Filter->SetInputConnection(this->Conformal->GetOutputPort());
    this->Filter->SetNormalizeToUnitDomain();
    this->Filter->FaceRefinementOff(); // the exact map of the transport alone is known
    this->Filter->Update();
  }

  vtkPolyData* flat() { return this->Filter->GetOutput(); }

  // Moves the points from (x, y) to what @p move makes of it.
  template <typename Move>
  void movePoints(vtkIdType begin, vtkIdType end, Move&& move)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      double x[3];
      this->flat()->GetPoint(i, x);
      move(x[0], x[1]);
      this->flat()->GetPoints()->SetPoint(i, x);
    }
  }

  void expectToShow(const char* wrong, double difference)
  {
    expectNotBaseline(imageOfTiles(this->flat()), "OMTAreaPreserving", wrong, difference);
  }

  SurfaceOfRevolution Surface = gaussianBump(1.0, 0.3);
  RevolutionMesh Bump = sunflowerMesh(Surface, 1000);
  vtkNew<vtkConformalDiskFilter> Conformal;
  vtkNew<vtkOMTAreaPreservingFilter> Filter;
};

TEST_F(OMTAreaPreserving, IsTheBaseline)
{
  expectBaseline(imageOfTiles(this->flat()), "OMTAreaPreserving");
  const auto radius = [this](double t) { return this->Surface.brenierRadius(t); };
  EXPECT_LT(distanceFromRadialMap(this->Bump, this->flat(), radius), 0.03) << "the size of a cell";
  EXPECT_EQ(figure(this->flat(), "FlippedFaces"), 0.0);
}

TEST_F(OMTAreaPreserving, AMapThatKeepsNoAreasShows)
{
  expectNotBaseline(
    imageOfTiles(this->Conformal->GetOutput()), "OMTAreaPreserving", "the conformal map", 100.0);
}

TEST_F(OMTAreaPreserving, AFewMovedPointsShow)
{
  this->movePoints(200,
    220,
    [](double& x, double& y)
    {
      x += 0.1;
      y -= 0.1;
    });
  this->expectToShow("20 moved points", 6.0);
}

TEST_F(OMTAreaPreserving, AMirroredMapShows)
{
  this->movePoints(0, this->flat()->GetNumberOfPoints(), [](double&, double& y) { y = -y; });
  this->expectToShow("a mirrored map", 100.0);
}

TEST_F(OMTAreaPreserving, ARotatedMapShows)
{
  this->movePoints(0,
    this->flat()->GetNumberOfPoints(),
    [](double& x, double& y)
    {
      const double angle = 0.08;
      const double before = x;
      x = std::cos(angle) * before - std::sin(angle) * y;
      y = std::sin(angle) * before + std::cos(angle) * y;
    });
  this->expectToShow("a map rotated by 0.08", 50.0);
}

} // namespace
