// SPDX-License-Identifier: GPL-3.0-or-later
// Prints a checksum of every coordinate of the maps of the benchmark surfaces, with the figures that a
// change must not make worse. Two versions of the code whose checksums are equal give the same maps to
// the last bit.
//   MapChecksums [scan] [name of a surface ...]     without names: of all but the large ones
#include "Areas/AreaPreservingDisk.h"
#include "BenchmarkSurfaces.h"
#include "Conformal/ConformalDisk.h"
#include "FlatMap/DistortionSummary.h"
#include "Yardstick.h"

#include <algorithm>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace
{

using namespace flattening;

/// FNV-1a over the bytes of the coordinates.
template <typename Matrix>
std::uint64_t checksum(const Matrix& positions)
{
  std::uint64_t hash = 14695981039346656037ull;
  for (Eigen::Index row = 0; row < positions.rows(); ++row)
  {
    for (Eigen::Index column = 0; column < positions.cols(); ++column)
    {
      const double coordinate = positions(row, column);
      unsigned char bytes[sizeof coordinate];
      std::memcpy(bytes, &coordinate, sizeof coordinate);
      for (const unsigned char byte : bytes)
      {
        hash = (hash ^ byte) * 1099511628211ull;
      }
    }
  }
  return hash;
}

void printChecksums(const std::string& name, const benchmarks::BenchmarkSurface& surface)
{
  const TriangleMesh& mesh = surface.Mesh;
  const benchmarks::StopWatch watch;
  const ConformalDiskMap conformal = conformalDiskMap(mesh);
  const double conformalSeconds = watch.processorSeconds();
  const AreaPreservingResult flat = areaPreservingDiskMap(mesh, conformal.Positions, {}, {});
  const double seconds = watch.processorSeconds() - conformalSeconds;
  const auto faces = summariseDistortion(measureDistortion(mesh, flat.Map.Positions));
  std::printf("| %s | %d | %016" PRIx64 " | %016" PRIx64 " | %016" PRIx64
              " | %.2f | %.3f | %.2f | %d | %.2f | %.2f | %.2f |\n",
    name.c_str(),
    static_cast<int>(mesh.vertexCount()),
    checksum(mesh.Vertices),
    checksum(conformal.Positions),
    checksum(flat.Map.Positions),
    faces.FacesWithin2Percent,
    faces[Measure::AreaError].AreaWeightedMean,
    faces[Measure::AngleError].Mean,
    flat.Map.FlippedFaces,
    conformalSeconds,
    seconds,
    watch.seconds());
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  const std::string scan = argc > 1 ? argv[1] : "/usr/share/mricron/templates/ch2bet.nii.gz";
  const std::vector<std::string> chosen(argv + std::min(argc, 2), argv + argc);
  std::puts(
    "| surface | vertices | disk | conformal map | flat map | faces within 2 % | mean area error (%) | "
    "mean angle error (degrees) | flipped | conformal (processor s) | area (processor s) | both (s) |");
  std::puts("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
  for (const auto& [name, load, isLarge] : benchmarks::flattenedSurfaces(scan))
  {
    const bool isChosen = std::find(chosen.begin(), chosen.end(), name) != chosen.end();
    if (chosen.empty() ? !isLarge : isChosen)
    {
      printChecksums(name, load());
    }
  }
  return 0;
}
