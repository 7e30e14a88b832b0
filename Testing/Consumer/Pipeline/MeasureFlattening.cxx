// SPDX-License-Identifier: GPL-3.0-or-later
// A C++ pipeline of another project: a disk, flattened by doubling its size, keeps every area share.
#include <vtkDiskSource.h>
#include <vtkDistortionMetrics.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkTriangleFilter.h>

#include <cmath>
#include <iostream>

int main()
{
  vtkNew<vtkDiskSource> disk;
  disk->SetInnerRadius(0.2);
  disk->SetOuterRadius(1.0);
  disk->SetCircumferentialResolution(32);
  disk->SetRadialResolution(4);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(disk->GetOutputPort());
  triangles->Update();

  vtkPolyData* flattened = triangles->GetOutput();
  vtkNew<vtkDoubleArray> surfacePoints;
  surfacePoints->SetName("SurfacePoints");
  surfacePoints->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < flattened->GetNumberOfPoints(); ++i)
  {
    double x[3];
    flattened->GetPoint(i, x);
    surfacePoints->InsertNextTuple3(x[0], x[1], x[2]);
    flattened->GetPoints()->SetPoint(i, 2.0 * x[0], 2.0 * x[1], 0.0);
  }
  flattened->GetPointData()->AddArray(surfacePoints);

  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flattened);
  metrics->Update();
  vtkTable* summary = metrics->GetSummary();
  const double worst = summary->GetValueByName(0, "MaxAreaError").ToDouble();
  const double growth = summary->GetValueByName(0, "FlatArea").ToDouble() /
                        summary->GetValueByName(0, "SurfaceArea").ToDouble();
  std::cout << "largest area error " << worst << " %, flat area / surface area " << growth << "\n";
  return summary->GetNumberOfRows() == 1 && worst < 1e-4 && std::abs(growth - 4.0) < 1e-5 ? 0 : 1;
}
