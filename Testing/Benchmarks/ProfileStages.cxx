// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how long each stage takes on a surface, how often it is begun and how much memory it needs, as
// Markdown tables. The stages are those of the progress that users see: the time from one report to the
// next counts for the stage of the first, and the memory is all that the process has.
//   ProfileStages <folder of scans> [name of a surface ...]     without names: prints the names
#include "Areas/AreaPreservingDisk.h"
#include "BenchmarkSurfaces.h"
#include "Conformal/ConformalDisk.h"
#include "Disk/SurfaceToDisk.h"
#include "PeakMemory.h"
#include "ScanSurface.h"
#include "Yardstick.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace
{

using namespace flattening;

class StageProfile
{
public:
  /// To be called with every report of progress.
  void enter(const std::string& stage)
  {
    if (stage != this->Current)
    {
      this->leave();
      this->Current = stage;
      ++this->stageOf(stage).Times;
    }
  }

  /// Ends the last stage and prints the table.
  void print(const std::string& title)
  {
    this->leave();
    std::printf("%s\n\n| stage | times | seconds | of the processor | peak memory (GB) |\n"
                "| --- | --- | --- | --- | --- |\n",
      title.c_str());
    Stage all;
    for (const Stage& stage : this->Stages)
    {
      print(stage);
      all.Seconds += stage.Seconds;
      all.ProcessorSeconds += stage.ProcessorSeconds;
      all.PeakMemory = std::max(all.PeakMemory, stage.PeakMemory);
    }
    all.Name = "all";
    all.Times = 1;
    print(all);
    std::puts("");
    std::fflush(stdout);
  }

private:
  struct Stage
  {
    std::string Name;
    int Times = 0;
    double Seconds = 0.0;
    double ProcessorSeconds = 0.0;
    double PeakMemory = 0.0;
  };

  static void print(const Stage& stage)
  {
    std::printf("| %s | %d | %.2f | %.2f | %.2f |\n",
      stage.Name.c_str(),
      stage.Times,
      stage.Seconds,
      stage.ProcessorSeconds,
      stage.PeakMemory);
  }

  Stage& stageOf(const std::string& name)
  {
    const auto found = std::find_if(this->Stages.begin(),
      this->Stages.end(),
      [&name](const Stage& stage) { return stage.Name == name; });
    return found != this->Stages.end() ? *found : this->Stages.emplace_back(Stage{ name });
  }

  // Counts the time and the memory since the last call for the current stage.
  void leave()
  {
    Stage& stage = this->stageOf(this->Current);
    stage.Seconds += this->Watch.seconds();
    stage.ProcessorSeconds += this->Watch.processorSeconds();
    stage.PeakMemory = std::max(stage.PeakMemory, benchmarks::peakMemory());
    benchmarks::resetPeakMemory();
    this->Watch = {};
  }

  std::vector<Stage> Stages;
  std::string Current = "before the first report";
  benchmarks::StopWatch Watch;
};

template <typename Work>
void profile(const std::string& title, const Work& work)
{
  benchmarks::resetPeakMemory();
  StageProfile stages;
  work(
    [&stages](double, const char* stage)
    {
      stages.enter(stage);
      return true;
    });
  stages.print(title);
}

void profileMaps(const benchmarks::NamedSurface& surface)
{
  const TriangleMesh mesh = surface.Load().Mesh;
  const std::string title = surface.Name + ", " + std::to_string(mesh.vertexCount()) + " vertices: ";
  ConformalDiskMap conformal;
  profile(title + "conformal map",
    [&](const ProgressCallback& progress) { conformal = conformalDiskMap(mesh, {}, progress); });
  profile(title + "transport and refinement",
    [&](const ProgressCallback& progress)
    { areaPreservingDiskMap(mesh, conformal.Positions, {}, {}, progress); });
}

void profileSurfaceToDisk(const benchmarks::NamedScan& scan)
{
  const TriangleMesh soup =
    benchmarks::meshOf(benchmarks::scanSurface(scan.File, scan.Sigma, scan.Isovalue));
  for (const bool isRemeshed : { false, true })
  {
    SurfaceToDiskOptions options;
    options.Remesh = isRemeshed;
    profile(scan.name() + ", " + std::to_string(soup.vertexCount()) + " vertices: Surface To Disk" +
              (isRemeshed ? " with Remesh" : ""),
      [&](const ProgressCallback& progress) { surfaceToDisk(soup, options, progress); });
  }
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::fprintf(stderr, "ProfileStages <folder of scans> [name of a surface ...]\n");
    return 2;
  }
  const std::string folder = argv[1];
  const std::vector<std::string> chosen(argv + 2, argv + argc);
  const auto isChosen = [&chosen](const std::string& name)
  {
    if (chosen.empty())
    {
      std::puts(name.c_str());
    }
    return std::find(chosen.begin(), chosen.end(), name) != chosen.end();
  };
  for (const benchmarks::NamedScan& scan : benchmarks::scansWithHandles(folder))
  {
    if (isChosen(scan.name()))
    {
      profileSurfaceToDisk(scan);
    }
  }
  for (const benchmarks::NamedSurface& surface :
    benchmarks::flattenedSurfaces(folder + "/ch2bet.nii.gz"))
  {
    if (isChosen(surface.Name))
    {
      profileMaps(surface);
    }
  }
  return 0;
}
