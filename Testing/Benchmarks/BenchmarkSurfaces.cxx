// SPDX-License-Identifier: GPL-3.0-or-later
#include "BenchmarkSurfaces.h"

#include "AnalyticSurfaces.h"
#include "Base/Errors.h"
#include "Disk/HolePlacement.h"
#include "Geodesics/DijkstraDistance.h"
#include "Mesh/DerivedMesh.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/IsotropicRemeshing.h"
#include "ScanSurface.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkClipPolyData.h>
#include <vtkImageData.h>
#include <vtkLinearSubdivisionFilter.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkSmartPointer.h>
#include <vtkSurfaceToDiskFilter.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <vector>

namespace flattening::benchmarks
{
namespace
{

// The whole brain is remeshed to this edge length, and its hole takes this share of the area.
constexpr double BrainEdgeLength = 1.465; // mm
constexpr double BrainHoleFraction = 0.0075;

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
  toDisk->SetCutModeToHole();
  if (holeFraction > 0.0)
  {
    toDisk->SetHoleAreaFraction(holeFraction);
  }
  return asDisk(toDisk, surface, edgeLength);
}

// Removes the triangles nearest to the position of the hole until they have the given share of the area,
// and as few more as make the rest a disk.
TriangleMesh withoutTriangles(const TriangleMesh& closed, double areaFraction)
{
  const SurfaceMesh surface = toSurfaceMesh(closed);
  const Eigen::VectorXd distances =
    distancesAlongEdges(surface, { SurfaceMesh::Vertex_index(geodesicCentre(closed)) });
  const Eigen::VectorXd areas = faceAreas(closed.Vertices, closed.Faces);
  std::vector<double> nearest(closed.faceCount());
  for (int f = 0; f < closed.faceCount(); ++f)
  {
    nearest[f] = std::min(
      { distances[closed.Faces(f, 0)], distances[closed.Faces(f, 1)], distances[closed.Faces(f, 2)] });
  }
  std::vector<int> order(closed.faceCount());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return nearest[a] < nearest[b]; });
  double removed = 0.0;
  for (auto rest = order.begin(); rest != order.end(); ++rest)
  {
    const bool isEnough = removed >= areaFraction * areas.sum();
    if (isEnough && nearest[*rest] > nearest[*(rest - 1)])
    {
      std::vector<int> kept(rest, order.end());
      std::sort(kept.begin(), kept.end());
      TriangleMesh mesh = extractFaces(closed, kept).Mesh;
      try
      {
        requireDisk(mesh);
        return mesh;
      }
      catch (const TopologyError&)
      {
      }
    }
    removed += areas[*rest];
  }
  throw TopologyError("no disk is left");
}

// The part of the surface on side 1 or -1 of the mid-plane.
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
  return asDisk(brainSurface(scan), BrainEdgeLength, BrainHoleFraction);
}

BenchmarkSurface remeshedBrainWithCoarseHole(const std::string& scan)
{
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputData(brainSurface(scan));
  largest->SetExtractionModeToLargestRegion();
  vtkNew<vtkCleanPolyData> used;
  used->SetInputConnection(largest->GetOutputPort());
  used->PointMergingOff();
  used->Update();
  const TriangleMesh remeshed = remeshIsotropically(meshOf(used->GetOutput()), BrainEdgeLength).Mesh;
  return { withoutTriangles(remeshed, BrainHoleFraction) };
}

BenchmarkSurface brainWithResolvedHole(const std::string& scan)
{
  return asDisk(brainSurface(scan), 0.0, BrainHoleFraction);
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

std::vector<NamedSurface> flattenedSurfaces(const std::string& scan)
{
  const auto remeshed = [scan](double edgeLength)
  { return [scan, edgeLength] { return remeshedHalfBrain(scan, edgeLength); }; };
  const auto split = [scan](int times)
  { return [scan, times] { return subdivided(halfBrain(scan), times); }; };
  return { { "hemisphere", hemisphere },
    { "Gaussian bump", gaussianSquare },
    { "half brain, edges of 7 mm", remeshed(7.0) },
    { "half brain, edges of 3.5 mm", remeshed(3.5) },
    { "half brain, remeshed", remeshed(1.2) },
    { "half brain, raw", [scan] { return halfBrain(scan); } },
    { "half brain, split once", split(1) },
    { "half brain, split twice", split(2), true },
    { "half brain, split three times", split(3), true },
    { "whole brain, remeshed", [scan] { return remeshedBrain(scan); } },
    { "whole brain, coarse hole", [scan] { return remeshedBrainWithCoarseHole(scan); } },
    { "whole brain, raw", [scan] { return brainWithResolvedHole(scan); } },
    { "whole brain, raw, hole 0.1 %", [scan] { return closedBrain(scan); } },
    { "whole brain, split once", [scan] { return subdivided(brainWithResolvedHole(scan), 1); }, true } };
}

} // namespace flattening::benchmarks
