// SPDX-License-Identifier: GPL-3.0-or-later
/// Inputs for the tests of vtkSurfaceToDiskFilter, and what its output must be.
#pragma once

#include <vtkSurfaceToDiskFilter.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFeatureEdges.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkStripper.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace disk_tests
{

inline constexpr double Pi = 3.14159265358979323846;

inline vtkSmartPointer<vtkPolyData> sphere(int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkSmartPointer<vtkPolyData> result = source->GetOutput();
  result->GetPointData()->Initialize();
  return result;
}

// A square of n x n quads in [0,1]^2.
inline vtkSmartPointer<vtkPolyData> square(int n)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(0, 0, 0);
  source->SetPoint1(1, 0, 0);
  source->SetPoint2(0, 1, 0);
  source->SetResolution(n, n);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkSmartPointer<vtkPolyData> result = source->GetOutput();
  result->GetPointData()->Initialize();
  return result;
}

// Position as floating point numbers, the octant as a label and as a string; the cell's id squared.
inline void addAttributes(vtkPolyData* data)
{
  vtkNew<vtkDoubleArray> position;
  position->SetName("Position");
  position->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> octant;
  octant->SetName("Octant");
  vtkNew<vtkStringArray> name;
  name->SetName("Name");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    position->InsertNextTuple(x);
    octant->InsertNextValue(100 + (x[0] > 0) + 2 * (x[1] > 0) + 4 * (x[2] > 0));
    name->InsertNextValue("octant " + std::to_string(octant->GetValue(i)));
  }
  data->GetPointData()->AddArray(position);
  data->GetPointData()->SetScalars(octant);
  data->GetPointData()->AddArray(name);
  vtkNew<vtkFloatArray> number;
  number->SetName("CellNumber");
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    number->InsertNextValue(static_cast<float>(c + 1));
  }
  data->GetCellData()->AddArray(number);
}

inline double figure(vtkPolyData* output, const char* name)
{
  vtkDataArray* array = output->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() != 1)
  {
    ADD_FAILURE() << "no one-tuple field array " << name;
    return std::numeric_limits<double>::quiet_NaN();
  }
  return array->GetTuple1(0);
}

inline double areaOf(vtkPolyData* data)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(data);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(triangles->GetOutputPort());
  return mass->GetSurfaceArea();
}

// Euler number 1 and one closed boundary line, counted by VTK.
inline void expectDisk(vtkPolyData* output)
{
  ASSERT_GT(output->GetNumberOfCells(), 0);
  EXPECT_EQ(output->GetNumberOfPolys(), output->GetNumberOfCells());
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(output);
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOn();
  edges->ColoringOff();
  edges->BoundaryEdgesOff();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfLines(), 0);
  edges->BoundaryEdgesOn();
  edges->Update();
  const vtkIdType boundary = edges->GetOutput()->GetNumberOfLines();
  EXPECT_EQ(boundary, figure(output, "BoundaryVertices"));
  vtkNew<vtkStripper> loops;
  loops->SetInputConnection(edges->GetOutputPort());
  loops->SetMaximumLength(VTK_INT_MAX);
  loops->Update();
  EXPECT_EQ(loops->GetOutput()->GetNumberOfLines(), 1);
  const vtkIdType faces = output->GetNumberOfCells();
  EXPECT_EQ(output->GetNumberOfPoints() - (3 * faces + boundary) / 2 + faces, 1);
}

inline vtkSmartPointer<vtkPolyData> run(vtkSurfaceToDiskFilter* filter, vtkPolyData* input)
{
  filter->SetInputData(input);
  filter->Update();
  vtkNew<vtkPolyData> output;
  output->ShallowCopy(filter->GetOutput());
  return output;
}

} // namespace disk_tests
