// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/MovedPolyData.h"

#include "Internal/ArrayConversion.h"
#include "Internal/PolyDataConversion.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>
#include <vtkTriangleFilter.h>

namespace flattening
{
namespace
{

void movePoints(vtkPolyData* surface, const Eigen::Affine3d& transform)
{
  const Points3 moved =
    (pointsOf(surface) * transform.linear().transpose()).rowwise() + transform.translation().transpose();
  vtkNew<vtkPoints> points;
  points->SetData(newTuples<vtkDoubleArray>("Points", moved));
  surface->SetPoints(points);
}

// Normals turn by the inverse transpose, which keeps them on their side of a mirrored surface.
vtkSmartPointer<vtkDoubleArray> turned(vtkDataArray* normals, const Eigen::Affine3d& transform)
{
  Points3 rows = toMatrix<3>(normals) * transform.linear().inverse();
  rows.rowwise().normalize();
  return newTuples<vtkDoubleArray>(normals->GetName(), rows);
}

void turnNormals(vtkDataSetAttributes* attributes, const Eigen::Affine3d& transform)
{
  vtkDataArray* named = attributes->GetArray("Normals");
  vtkDataArray* active = attributes->GetNormals();
  if (named && named != active && named->GetNumberOfComponents() == 3)
  {
    attributes->AddArray(turned(named, transform));
  }
  if (active)
  {
    attributes->SetNormals(turned(active, transform));
  }
}

void reverseCells(vtkPolyData* surface)
{
  if (surface->GetNumberOfStrips() > 0) // vtkReverseSense turns only strips of an odd number of points
  {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(surface);
    triangles->Update();
    surface->ShallowCopy(triangles->GetOutput());
  }
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(surface);
  reverse->ReverseCellsOn();
  reverse->ReverseNormalsOff();
  reverse->Update();
  surface->ShallowCopy(reverse->GetOutput());
}

} // namespace

void movePolyData(vtkPolyData* surface, const Eigen::Affine3d& transform)
{
  if (transform.linear().determinant() < 0.0)
  {
    reverseCells(surface);
  }
  movePoints(surface, transform);
  turnNormals(surface->GetPointData(), transform);
  turnNormals(surface->GetCellData(), transform);
}

} // namespace flattening
