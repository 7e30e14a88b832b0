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

vtkSmartPointer<vtkPolyData> polyDataOf(const TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    points->InsertNextPoint(mesh.Vertices.row(v).data());
  }
  vtkNew<vtkCellArray> faces;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    faces->InsertNextCell({ mesh.Faces(f, 0), mesh.Faces(f, 1), mesh.Faces(f, 2) });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(faces);
  return data;
}

vtkSmartPointer<vtkPolyData> brainSurface(const std::string& scan)
{
  return scanSurface(scan, 2.0, 40.0);
}

// Edge length 0: not remeshed.
BenchmarkSurface asDisk(vtkSurfaceToDiskFilter* toDisk, vtkPolyData* surface, double edgeLength)
{
  toDisk->SetInputData(surface);
  toDisk->SetRemesh(edgeLength > 0.0);
  toDisk->SetTargetEdgeLength(edgeLength);
  const auto start = std::chrono::steady_clock::now();
  toDisk->Update();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return { meshOf(toDisk->GetOutput()), seconds };
}

// Hole fraction 0: the filter's default.
BenchmarkSurface asDisk(vtkPolyData* surface, double edgeLength, double holeFraction = 0.0)
{
  vtkNew<vtkSurfaceToDiskFilter> toDisk;
  if (holeFraction > 0.0)
  {
    toDisk->SetHoleAreaFraction(holeFraction);
  }
  return asDisk(toDisk, surface, edgeLength);
}

// What lies on side 1 or -1 of the mid-plane.
BenchmarkSurface half(const std::string& scan, double edgeLength, int side = 1)
{
  const vtkSmartPointer<vtkPolyData> brain = brainSurface(scan);
  double bounds[6];
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(scan.c_str());
  reader->Update();
  reader->GetOutput()->GetBounds(bounds);
  vtkNew<vtkPlane> midPlane;
  midPlane->SetOrigin(0.5 * (bounds[0] + bounds[1]), 0.0, 0.0);
  midPlane->SetNormal(side, 0.0, 0.0);
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
  BenchmarkSurface surface = squareGrid(101, 101);
  surface.Mesh.Vertices.col(2) =
    (-4.0 * surface.Mesh.Vertices.leftCols<2>().rowwise().squaredNorm().array()).exp();
  return surface;
}

BenchmarkSurface squareGrid(int columns, int rows)
{
  BenchmarkSurface surface;
  TriangleMesh& mesh = surface.Mesh;
  mesh.Vertices.resize(columns * rows, 3);
  mesh.Faces.resize(2 * (columns - 1) * (rows - 1), 3);
  int face = 0;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const int v = j * columns + i;
      mesh.Vertices.row(v) << 2.0 * i / (columns - 1) - 1.0, 2.0 * j / (rows - 1) - 1.0, 0.0;
      if (i + 1 < columns && j + 1 < rows)
      {
        mesh.Faces.row(face++) << v, v + 1, v + columns + 1;
        mesh.Faces.row(face++) << v, v + columns + 1, v + columns;
      }
    }
  }
  return surface;
}

BenchmarkSurface closedBrain(const std::string& scan)
{
  return asDisk(brainSurface(scan), 0.0);
}

BenchmarkSurface remeshedBrain(const std::string& scan)
{
  return asDisk(brainSurface(scan), 1.465, 0.0075);
}

BenchmarkSurface brainWithResolvedHole(const std::string& scan)
{
  return asDisk(brainSurface(scan), 0.0, 0.0075);
}

BenchmarkSurface unrolled(const TriangleMesh& tube, double edgeLength)
{
  vtkNew<vtkSurfaceToDiskFilter> toDisk;
  toDisk->SetCutModeToSeam();
  return asDisk(toDisk, polyDataOf(tube), edgeLength);
}

BenchmarkSurface subdivided(const BenchmarkSurface& coarse, int times)
{
  vtkNew<vtkLinearSubdivisionFilter> subdivision;
  subdivision->SetInputData(polyDataOf(coarse.Mesh));
  subdivision->SetNumberOfSubdivisions(times);
  subdivision->Update();
  return { meshOf(subdivision->GetOutput()), coarse.SurfaceToDiskSeconds };
}

BenchmarkSurface halfBrain(const std::string& scan)
{
  return half(scan, 0.0);
}

BenchmarkSurface otherHalfBrain(const std::string& scan)
{
  return half(scan, 0.0, -1);
}

BenchmarkSurface fineBrain(const std::string& scan)
{
  return asDisk(scanSurface(scan, 1.0, 60.0), 0.0);
}

BenchmarkSurface remeshedHalfBrain(const std::string& scan, double edgeLength)
{
  return half(scan, edgeLength);
}

} // namespace flattening::benchmarks
