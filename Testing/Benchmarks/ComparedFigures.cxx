// SPDX-License-Identifier: GPL-3.0-or-later
// Prints, for the compared maps of one surface and ours, the figures that the authors of the methods
// state for theirs, as a Markdown table: docs/benchmarks.md has them side by side.
//   ComparedFigures <surface.obj>    a disk
#include "AuthalicEnergy.h"
#include "ScanSurface.h"
#include "StretchEnergy.h"
#include "SymmetricDirichlet.h"
#include "Yardstick.h"

#include "Areas/AreaPreservingDisk.h"
#include "Conformal/ConformalDisk.h"
#include "Conformal/NaturalOutline.h"
#include "FlatMap/DistortionSummary.h"
#include "Mesh/MeshTopology.h"

#include <vtkCleanPolyData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace
{

using namespace flattening;

// The reader makes a point for each pair of a vertex and a texture coordinate.
TriangleMesh readSurface(const char* file)
{
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(file);
  vtkNew<vtkCleanPolyData> joined;
  joined->SetInputConnection(reader->GetOutputPort());
  joined->SetTolerance(0.0);
  joined->Update();
  return benchmarks::meshOf(joined->GetOutput());
}

// The sum of a^2 / t over the squared sum of a, times the sum of t: 1 if all areas a on the map are in
// proportion to those t on the surface.
double relativeStretchEnergy(const TriangleMesh& mesh, const Points2& flat)
{
  const Eigen::VectorXd surface = faceAreas(mesh.Vertices, mesh.Faces);
  const Eigen::VectorXd map = signedFaceAreas(flat, mesh.Faces);
  return map.cwiseAbs2().cwiseQuotient(surface).sum() * surface.sum() / (map.sum() * map.sum());
}

void print(const char* name, const TriangleMesh& mesh, const Points2& flat, double seconds)
{
  const FaceDistortion distortion = measureDistortion(mesh, flat);
  const DistortionSummary faces = summariseDistortion(distortion);
  const double quasiConformal =
    distortion.SurfaceArea.dot(distortion.AngleDistortion.array().exp().matrix()) /
    distortion.SurfaceArea.sum();
  std::printf("| %s | %.2f | %.5f | %.4f | %.4f | %.5f | %.4f | %d |\n",
    name,
    seconds,
    relativeStretchEnergy(mesh, flat) - 1.0,
    0.01 * faces[Measure::AreaError].Mean,
    faces.SDAreaRatio,
    faces[Measure::SymmetricDirichlet].AreaWeightedMean,
    quasiConformal,
    faces.FlippedFaces);
}

template <typename Flatten>
void measure(const char* name, const TriangleMesh& mesh, const Flatten& flatten)
{
  const benchmarks::StopWatch watch;
  const Points2 flat = flatten();
  print(name, mesh, flat, watch.processorSeconds());
}

void printFigures(const TriangleMesh& mesh)
{
  std::printf("%d vertices, %d faces\n\n", mesh.vertexCount(), mesh.faceCount());
  std::puts(
    "| map | seconds | relative stretch energy - 1 | mean area error | SD of area ratio | symmetric "
    "Dirichlet energy | quasi-conformal distortion | flipped |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- |");
  std::vector<double> energies;
  measure("stretch energy",
    mesh,
    [&]
    {
      benchmarks::StretchEnergyMap map = benchmarks::stretchEnergyDiskMap(mesh, 10);
      energies = std::move(map.Energies);
      return map.Positions;
    });
  measure("authalic energy", mesh, [&] { return benchmarks::authalicEnergyDiskMap(mesh); });
  benchmarks::BalancedMap balanced;
  measure("distortion balancing",
    mesh,
    [&]
    {
      balanced = benchmarks::balancedDiskMap(mesh);
      return balanced.Positions;
    });
  measure("Boundary First",
    mesh,
    [&]
    {
      const std::vector<int> loop = requireDisk(mesh);
      NaturalOutlineMap map(mesh, loop);
      return map.extended(map.outline());
    });
  measure("symmetric Dirichlet", mesh, [&] { return benchmarks::symmetricDirichletMap(mesh, 100); });
  for (const bool isFree : { false, true })
  {
    measure(isFree ? "ours, free outline" : "ours, disk",
      mesh,
      [&]
      {
        AreaPreservingOptions options;
        options.FreeOutline = isFree;
        return areaPreservingDiskMap(mesh, conformalDiskMap(mesh).Positions, {}, options).Map.Positions;
      });
  }
  std::puts("\nStretch energies after each iteration:");
  for (const double energy : energies)
  {
    std::printf("%.6g ", energy);
  }
  std::printf("\n\nDistortion balancing: authalic energy %.6f, conformal energy %.6f\n",
    balanced.AuthalicEnergy,
    balanced.ConformalEnergy);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::fprintf(stderr, "ComparedFigures <surface.obj>\n");
    return 2;
  }
  try
  {
    printFigures(readSurface(argv[1]));
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
