// SPDX-License-Identifier: GPL-3.0-or-later
#include "BenchmarkSurfaces.h"

#include "AnalyticSurfaces.h"
#include "ScanSurface.h"

#include <vtkCellArray.h>
#include <vtkClipPolyData.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkLinearSubdivisionFilter.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSurfaceToDiskFilter.h>

#include <chrono>
#include <cmath>

namespace flattening::benchmarks
{
namespace
{

TriangleMesh meshOf(vtkPolyData* data)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(data->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, mesh.Vertices.row(i).data());
  }
  mesh.Faces.resize(data->GetNumberOfPolys(), 3);
  vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < data->GetNumberOfPolys(); ++f)
  {
    data->GetPolys()->GetCellAtId(f, corners);
    mesh.Faces.row(f) << static_cast<int>(corners->GetId(0)), static_cast<int>(corners->GetId(1)),
      static_cast<int>(corners->GetId(2));
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> brainSurface(const std::string& scan)
{
  return scanSurface(scan, 2.0, 40.0);
}

BenchmarkSurface asDisk(vtkPolyData* surface, double edgeLength)
{
  vtkNew<vtkSurfaceToDiskFilter> toDisk;
  toDisk->SetInputData(surface);
  toDisk->SetRemesh(edgeLength > 0.0);
  toDisk->SetTargetEdgeLength(edgeLength);
  const auto start = std::chrono::steady_clock::now();
  toDisk->Update();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return { meshOf(toDisk->GetOutput()), seconds };
}

BenchmarkSurface half(const std::string& scan, double edgeLength)
{
  const vtkSmartPointer<vtkPolyData> brain = brainSurface(scan);
  double bounds[6];
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(scan.c_str());
  reader->Update();
  reader->GetOutput()->GetBounds(bounds);
  vtkNew<vtkPlane> midPlane;
  midPlane->SetOrigin(0.5 * (bounds[0] + bounds[1]), 0.0, 0.0);
  midPlane->SetNormal(1.0, 0.0, 0.0);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(brain);
  clip->SetClipFunction(midPlane);
  clip->Update();
  return asDisk(clip->GetOutput(), edgeLength);
}

} // namespace

BenchmarkSurface hemisphere()
{
  return { analytic::ringMesh(analytic::sphericalCap(0.5 * EIGEN_PI), 6817).Mesh };
}

BenchmarkSurface gaussianSquare()
{
  constexpr int side = 101;
  BenchmarkSurface surface;
  surface.Mesh.Vertices.resize(side * side, 3);
  surface.Mesh.Faces.resize(2 * (side - 1) * (side - 1), 3);
  int face = 0;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const double x = 2.0 * i / (side - 1) - 1.0;
      const double y = 2.0 * j / (side - 1) - 1.0;
      const int v = j * side + i;
      surface.Mesh.Vertices.row(v) << x, y, std::exp(-4.0 * (x * x + y * y));
      if (i + 1 < side && j + 1 < side)
      {
        surface.Mesh.Faces.row(face++) << v, v + 1, v + side + 1;
        surface.Mesh.Faces.row(face++) << v, v + side + 1, v + side;
      }
    }
  }
  return surface;
}

BenchmarkSurface closedBrain(const std::string& scan)
{
  return asDisk(brainSurface(scan), 0.0);
}

BenchmarkSurface halfBrain(const std::string& scan)
{
  return half(scan, 0.0);
}

BenchmarkSurface fineHalfBrain(const std::string& scan)
{
  const TriangleMesh coarse = halfBrain(scan).Mesh;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int v = 0; v < coarse.vertexCount(); ++v)
  {
    points->InsertNextPoint(coarse.Vertices.row(v).data());
  }
  vtkNew<vtkCellArray> faces;
  for (int f = 0; f < coarse.faceCount(); ++f)
  {
    faces->InsertNextCell({ coarse.Faces(f, 0), coarse.Faces(f, 1), coarse.Faces(f, 2) });
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(faces);
  vtkNew<vtkLinearSubdivisionFilter> subdivision;
  subdivision->SetInputData(surface);
  subdivision->SetNumberOfSubdivisions(2);
  subdivision->Update();
  return { meshOf(subdivision->GetOutput()) };
}

BenchmarkSurface fineBrain(const std::string& scan)
{
  return asDisk(scanSurface(scan, 1.0, 60.0), 0.0);
}

BenchmarkSurface remeshedHalfBrain(const std::string& scan)
{
  return half(scan, 1.2);
}

} // namespace flattening::benchmarks
