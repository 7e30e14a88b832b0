// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/PartwiseRemeshing.h"

#include "Base/InterruptibleCall.h"
#include "Mesh/MeshMeasures.h"
#include "Remeshing/SurfaceLayers.h"
#include "Remeshing/SurfaceParts.h"

#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// A surface with fewer faces takes a few seconds as a whole: a convention.
constexpr int FewestFacesForParts = 300000;
// A layer has about so many faces: a convention. Smaller layers have more borders, at which the
// triangles are a little less regular; larger ones leave processors without work.
constexpr int FacesPerLayer = 75000;
// Half a layer is at least so many edges of the old surface and of the new one wide, so that the borders
// between layers lie well inside of the other layers: a convention.
constexpr int LeastOldEdges = 16;
constexpr int LeastNewEdges = 2;

constexpr const char* Stage = "remeshing";

// The parts, the wishes for them, and the progress. A job that was abandoned goes on with its own parts.
struct PartwiseJob
{
  std::shared_ptr<const SurfaceWithWalk> Surface;
  std::vector<SurfacePart> Parts;
  double Length = 0.0;
  VertexLimit Limit;
  int Rounds = 0;
  bool FlipsAfterwards = false;
  std::atomic<long> Done{ 0 }; // of this many for each part:
  static constexpr double DonePerPart = 1e6;
  std::atomic<bool> IsAborted{ false };

  double fraction() const
  {
    return static_cast<double>(this->Done) / DonePerPart / static_cast<double>(this->Parts.size());
  }
};

// Called in several threads. @throws Cancelled if the job is aborted.
void remeshPart(PartwiseJob& job, SurfacePart& part)
{
  if (part.Surface.Places.empty())
  {
    return;
  }
  const std::shared_ptr<const ClosestPointWalk> walk(job.Surface, &job.Surface->Walk);
  MeshOnSurface surface(walk, part.Surface, part.Kept);
  IsotropicRemesher remesher(
    surface, job.Length, { job.Limit.Most, job.Limit.Share / static_cast<double>(job.Parts.size()) });
  long done = 0;
  const ProgressCallback progress = [&job, &done](double fraction, const char*)
  {
    const long now = static_cast<long>(fraction * PartwiseJob::DonePerPart);
    job.Done += now - done;
    done = now;
    return !job.IsAborted;
  };
  for (int i = 0; i < job.Rounds; ++i)
  {
    const double rounds = job.Rounds;
    remesher.iterate(subrange(progress, i / rounds, (i + 1) / rounds));
  }
  if (job.FlipsAfterwards)
  {
    remesher.flipToDelaunay({});
  }
  part = remeshedPart(part, surface);
}

// Remeshes the parts of the present surface and joins them.
PlacedMesh remeshed(const PlacedMesh& present,
  const std::vector<int>& partOfFace,
  const std::shared_ptr<PartwiseJob>& job,
  const ProgressCallback& progress)
{
  report(progress, 0.0, Stage);
  const int count = 1 + *std::max_element(partOfFace.begin(), partOfFace.end());
  job->Parts = cutIntoParts(present, partOfFace, count);
  const ProgressCallback progressOfJob = progress ? [&progress, &job](double, const char* stage)
  { return progress(job->fraction(), stage); }
                                                  : ProgressCallback();
  try
  {
    callInterruptibly(
      [job]
      {
        tbb::parallel_for_each(
          job->Parts.begin(), job->Parts.end(), [&job](SurfacePart& part) { remeshPart(*job, part); });
      },
      progressOfJob,
      0.0,
      Stage);
  }
  catch (const Cancelled&)
  {
    job->IsAborted = true;
    throw;
  }
  return joinedParts(std::exchange(job->Parts, {}), present.Mesh.vertexCount());
}

// The levels of a surface's faces, and those at which its layers and their middles begin.
struct Layers
{
  std::vector<int> LevelsOfFaces;
  std::vector<int> Halves; // where each half of a layer but the first begins; empty without layers

  bool empty() const { return this->Halves.empty(); }

  // Per face the number of its layer. If fromMiddles, the layers begin in the middle of the others.
  std::vector<int> numbersOf(const PlacedMesh& present, bool fromMiddles) const
  {
    std::vector<int> begins;
    for (std::size_t i = fromMiddles ? 0 : 1; i < this->Halves.size(); i += 2)
    {
      begins.push_back(this->Halves[i]);
    }
    std::vector<int> layers(present.Mesh.faceCount());
    for (int f = 0; f < present.Mesh.faceCount(); ++f)
    {
      int level = this->LevelsOfFaces[present.Places[present.Mesh.Faces(f, 0)].Face];
      for (int k = 1; k < 3; ++k)
      {
        level = std::min(level, this->LevelsOfFaces[present.Places[present.Mesh.Faces(f, k)].Face]);
      }
      layers[f] =
        static_cast<int>(std::upper_bound(begins.begin(), begins.end(), level) - begins.begin());
    }
    return layers;
  }
};

Layers layersOf(const TriangleMesh& mesh, double length)
{
  Layers layers;
  if (mesh.faceCount() < FewestFacesForParts)
  {
    return layers;
  }
  layers.LevelsOfFaces = levelsOfFaces(mesh);
  const double leastWidth =
    std::max<double>(LeastOldEdges, LeastNewEdges * length / meanEdgeLength(mesh));
  for (int count = mesh.faceCount() / FacesPerLayer; count > 1; count -= std::max(1, count / 4))
  {
    layers.Halves = firstLevels(layers.LevelsOfFaces, 2 * count);
    const auto tooNear = std::adjacent_find(layers.Halves.begin(),
      layers.Halves.end(),
      [leastWidth](int a, int b) { return b - a < leastWidth; });
    if (tooNear == layers.Halves.end())
    {
      return layers;
    }
  }
  layers.Halves.clear();
  return layers;
}

} // namespace

std::optional<PlacedMesh> remeshedInParts(const std::shared_ptr<const SurfaceWithWalk>& surface,
  double length,
  const VertexLimit& limit,
  int rounds,
  const ProgressCallback& progress)
{
  const Layers layers = rounds > 0 ? layersOf(surface->Mesh, length) : Layers();
  if (layers.empty())
  {
    return std::nullopt;
  }
  const auto job = std::make_shared<PartwiseJob>();
  job->Surface = surface;
  job->Length = length;
  job->Limit = limit;
  job->Rounds = std::max(1, rounds - 1);
  const double share = static_cast<double>(job->Rounds) / rounds;
  PlacedMesh present = placedOnItself(surface->Walk);
  present = remeshed(present, layers.numbersOf(present, false), job, subrange(progress, 0.0, share));
  job->Rounds = 1;
  job->FlipsAfterwards = true;
  job->Done = 0;
  return remeshed(present, layers.numbersOf(present, true), job, subrange(progress, share, 1.0));
}

} // namespace flattening
