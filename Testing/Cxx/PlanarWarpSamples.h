// SPDX-License-Identifier: GPL-3.0-or-later
/// Planar meshes and what lies on them, for the tests of Planar Warp.
#pragma once

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <array>
#include <vector>

namespace flattening::testing
{

/// [0, 2] x [0, 1] at z = @p height in triangles.
inline vtkSmartPointer<vtkPolyData> plane(int resolution, double height = 0.0)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetOrigin(0, 0, height);
  source->SetPoint1(2, 0, height);
  source->SetPoint2(0, 1, height);
  source->SetResolution(2 * resolution, resolution);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

/// The same, each point moved from (x, y) to what @p move makes of it.
template <typename Move>
vtkSmartPointer<vtkPolyData> deformed(vtkPolyData* mesh, Move&& move)
{
  auto flat = vtkSmartPointer<vtkPolyData>::New();
  flat->DeepCopy(mesh);
  vtkNew<vtkDoubleArray> surface;
  surface->DeepCopy(mesh->GetPoints()->GetData());
  surface->SetName("SurfacePoints");
  flat->GetPointData()->Initialize();
  flat->GetPointData()->AddArray(surface);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    move(x);
    flat->GetPoints()->SetPoint(i, x[0], x[1], 0.0);
  }
  return flat;
}

inline vtkSmartPointer<vtkPolyData> doubled(double height = 0.0)
{
  return deformed(plane(5, height),
    [](double* x)
    {
      x[0] *= 2.0;
      x[1] *= 2.0;
    });
}

/// To a curve: a straight line across bends.
inline void bend(double* x)
{
  x[1] += 0.25 * x[0] * (2.0 - x[0]);
}

inline vtkSmartPointer<vtkPolyData> polyline(const std::vector<std::array<double, 3>>& corners)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(corners.size()));
  vtkNew<vtkDoubleArray> length;
  length->SetName("Length");
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  for (const auto& corner : corners)
  {
    const vtkIdType id = points->InsertNextPoint(corner.data());
    line->InsertCellPoint(id);
    length->InsertNextValue(10.0 * static_cast<double>(id));
    label->InsertNextValue(static_cast<int>(id));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(line);
  data->GetPointData()->AddArray(length);
  data->GetPointData()->AddArray(label);
  vtkNew<vtkIntArray> street;
  street->SetName("Street");
  street->InsertNextValue(42);
  data->GetCellData()->AddArray(street);
  return data;
}

/// 101 x 51 pixels on [0, 2] x [0, 1]: one array linear in x and y, one of labels, one per cell.
inline vtkSmartPointer<vtkImageData> picture()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(101, 51, 1);
  image->SetSpacing(0.02, 0.02, 1.0);
  vtkNew<vtkDoubleArray> ramp;
  ramp->SetName("Ramp");
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    ramp->InsertNextValue(x[0] + 10.0 * x[1]);
    label->InsertNextValue(x[0] < 0.69 ? 3 : 900);
  }
  image->GetPointData()->SetScalars(ramp);
  image->GetPointData()->AddArray(label);
  vtkNew<vtkIntArray> column;
  column->SetName("Column");
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    column->InsertNextValue(static_cast<int>(cell % 100));
  }
  image->GetCellData()->AddArray(column);
  return image;
}

} // namespace flattening::testing
