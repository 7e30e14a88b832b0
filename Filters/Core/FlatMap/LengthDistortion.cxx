// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/LengthDistortion.h"

#include "Base/Memory.h"
#include "FlatMap/LengthSources.h"
#include "FlatMap/MapPaths.h"
#include "Geodesics/GeodesicSearch.h"
#include "Mesh/CoordinateFrame.h"
#include "Mesh/Halfedges.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

constexpr const char* LocalStage = "Measuring local lengths";
constexpr const char* GlobalStage = "Measuring global lengths";

// The rings of mris_flatten, whose users quote the error of the distances within them.
constexpr int Rings = 7;

// A source of global lengths takes about forty times as long as one of local lengths, so this share of
// the sources must do. Lengths over the whole surface vary less from source to source.
constexpr int SamplesPerGlobalSample = 20;

// Bytes of a pair of points: its ratio and weight in one kind of lengths, in a copy of them, and in a
// list of them that is sorted.
constexpr double BytesPerPair = 3 * 2 * sizeof(double);

// So many sources tell how much memory all sources take. They are spread over the surface, and their
// mean is right to a tenth or so.
constexpr std::size_t FirstSources = 32;

// The share of local lengths in the progress.
constexpr double LocalShare = 0.3;

constexpr double Percent = 100.0;

void requireValid(const TriangleMesh& surface, const Points2& flat, const LengthOptions& options)
{
  if (!(options.Radius > 0.0) || !std::isfinite(options.Radius))
  {
    throw InvalidInput("the LengthRadius is " + formatted(options.Radius) +
                       ": set it to a positive length in the units of the surface");
  }
  if (options.Samples < 2)
  {
    throw InvalidInput("LengthSamples is " + std::to_string(options.Samples) +
                       ": a standard error needs 2 source points or more");
  }
  if (!surface.Vertices.allFinite() || !flat.allFinite())
  {
    throw InvalidInput("a coordinate of the flattened surface is not finite: run the flattening again");
  }
}

// The part of the surface that a search needs, for each thread.
struct Searches
{
  GeodesicSearch Closed;
  GeodesicSearch Open;
  MapPathSearch Map;
};

// Lengths of one source on the surface and on the map.
struct LocalLengths
{
  std::vector<int> Vertices; // the others of the pairs in Local
  SourceLengths Local;
  SourceLengths WithinMap;
  SourceLengths Rings;
};

std::vector<std::size_t> numbersBelow(std::size_t count)
{
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

// @throws InvalidInput if there is not as much memory as the lengths of all sources take.
// @param share  of the sources, whose lengths are known
void requireMemoryOfPairs(const std::vector<LocalLengths>& known, double share)
{
  const double pairs = std::accumulate(known.begin(),
    known.end(),
    0.0,
    [](double sum, const LocalLengths& lengths)
    {
      return sum + static_cast<double>(lengths.Local.Ratios.size() + lengths.WithinMap.Ratios.size() +
                                       lengths.Rings.Ratios.size());
    });
  requireMemory("measuring lengths from " + std::to_string(known.size()) + " points",
    BytesPerPair * pairs / share,
    "lower LengthSamples or LengthRadius");
}

class LengthMeasurement
{
public:
  LengthMeasurement(const TriangleMesh& surface, const Points2& flat)
    : Surface(surface)
    , Flat(flat)
    , Areas(vertexAreas(surface))
    , Open(surface, Seams::Open)
    , Closed(surface, Seams::Closed)
    , Paper(surface.Faces, flat)
    , SearchesOfThreads(
        [this]
        {
          return Searches{
            GeodesicSearch(this->Closed), GeodesicSearch(this->Open), MapPathSearch(this->Paper)
          };
        })
  {
  }

  std::vector<int> sources(int count) const
  {
    return drawnByArea(this->Areas, std::min(count, this->Surface.vertexCount()));
  }

  std::vector<LocalLengths> localLengths(const std::vector<int>& sources,
    double radius,
    const ProgressCallback& progress)
  {
    std::vector<LocalLengths> lengths(sources.size());
    const SourceTask task([&](std::size_t i, Searches& searches, const GeodesicSearch::Checkpoint& check)
      { lengths[i] = this->localLengthsOf(sources[i], radius, searches, check); });
    // A few of the sources come first and tell how much memory all of them take.
    const std::size_t step = std::max<std::size_t>(1, sources.size() / FirstSources);
    std::vector<std::size_t> order = numbersBelow(sources.size());
    const auto rest =
      std::stable_partition(order.begin(), order.end(), [step](std::size_t i) { return i % step == 0; });
    const std::vector<std::size_t> first(order.begin(), rest);
    order.erase(order.begin(), rest);
    const double share = static_cast<double>(first.size()) / static_cast<double>(sources.size());
    this->forEachSource(first, task, LocalStage, subrange(progress, 0.0, share));
    requireMemoryOfPairs(lengths, share);
    this->forEachSource(order, task, LocalStage, subrange(progress, share, 1.0));
    return lengths;
  }

  std::vector<SourceLengths> globalLengths(const std::vector<int>& sources,
    const ProgressCallback& progress)
  {
    std::vector<SourceLengths> lengths(sources.size());
    this->forEachSource(numbersBelow(sources.size()),
      SourceTask(
        [&](std::size_t i, Searches& searches, const GeodesicSearch::Checkpoint& check)
        {
          const std::vector<ReachedVertex> reached =
            searches.Closed.within(std::numeric_limits<double>::infinity(), sources[i], check);
          for (const ReachedVertex& other : reached)
          {
            this->addStraight(sources[i], other, lengths[i]);
          }
        }),
      GlobalStage,
      progress);
    return lengths;
  }

private:
  using SourceTask = std::function<void(std::size_t, Searches&, const GeodesicSearch::Checkpoint&)>;

  void forEachSource(const std::vector<std::size_t>& sources,
    const SourceTask& task,
    const char* stage,
    const ProgressCallback& progress)
  {
    SourceProgress state(progress, stage, sources.size());
    tbb::parallel_for(
      std::size_t(0),
      sources.size(),
      [&](std::size_t i)
      {
        task(sources[i], this->SearchesOfThreads.local(), [&state] { state.check(); });
        state.finishOne();
      },
      tbb::simple_partitioner());
  }

  LocalLengths localLengthsOf(int source,
    double radius,
    Searches& searches,
    const GeodesicSearch::Checkpoint& check) const
  {
    LocalLengths lengths;
    const std::vector<ReachedVertex> near = searches.Closed.within(radius, source, check);
    for (const ReachedVertex& other : near)
    {
      if (this->addStraight(source, other, lengths.Local))
      {
        lengths.Vertices.push_back(other.Vertex);
      }
    }
    this->addWithinMap(source,
      this->Closed.HasClosedSeams ? searches.Open.within(radius, source, check) : near,
      searches.Map,
      check,
      lengths.WithinMap);
    this->addRings(source, searches.Open, check, lengths.Rings);
    return lengths;
  }

  // Adds a pair and its straight line on the map. Returns false for a pair that has no length on the
  // surface, or no area.
  bool addStraight(int source, const ReachedVertex& other, SourceLengths& lengths) const
  {
    return this->add(other,
      (this->Flat.row(other.Vertex) - this->Flat.row(source)).norm(),
      this->Areas[other.Vertex],
      lengths);
  }

  void addWithinMap(int source,
    const std::vector<ReachedVertex>& near,
    MapPathSearch& map,
    const GeodesicSearch::Checkpoint& check,
    SourceLengths& lengths) const
  {
    std::vector<int> targets(near.size());
    std::transform(near.begin(),
      near.end(),
      targets.begin(),
      [](const ReachedVertex& other) { return other.Vertex; });
    const std::vector<double> onMap = map.to(targets, source, check);
    for (std::size_t i = 0; i < near.size(); ++i)
    {
      this->add(near[i], onMap[i], this->Areas[near[i].Vertex], lengths);
    }
  }

  void addRings(int source,
    GeodesicSearch& search,
    const GeodesicSearch::Checkpoint& check,
    SourceLengths& lengths) const
  {
    const std::vector<int> others = this->ringsAround(source);
    const std::vector<double> distances = search.to(others, source, check);
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      const double straight = (this->Flat.row(others[i]) - this->Flat.row(source)).norm();
      this->add({ others[i], distances[i] }, straight, 1.0, lengths);
    }
  }

  // The vertices that are no more than Rings edges away, by the number of edges.
  std::vector<int> ringsAround(int source) const
  {
    std::vector<int> found{ source };
    std::vector<int> sorted{ source };
    std::size_t begin = 0;
    for (int ring = 0; ring < Rings; ++ring)
    {
      const std::size_t end = found.size();
      for (std::size_t i = begin; i < end; ++i)
      {
        for (int c = this->Open.CornerStarts[found[i]]; c < this->Open.CornerStarts[found[i] + 1]; ++c)
        {
          const int h = this->Open.Corners[c];
          for (const int next : { nextHalfedge(h), previousHalfedge(h) })
          {
            const int vertex = this->Open.Origin[next];
            const auto place = std::lower_bound(sorted.begin(), sorted.end(), vertex);
            if (place == sorted.end() || *place != vertex)
            {
              sorted.insert(place, vertex);
              found.push_back(vertex);
            }
          }
        }
      }
      begin = end;
    }
    return found;
  }

  bool add(const ReachedVertex& other, double onMap, double weight, SourceLengths& lengths) const
  {
    const double ratio = onMap / other.Distance;
    if (!(other.Distance > 0.0) || !(weight > 0.0) || !std::isfinite(ratio))
    {
      return false;
    }
    lengths.Ratios.push_back(ratio);
    lengths.Weights.push_back(weight);
    return true;
  }

  const TriangleMesh& Surface;
  const Points2& Flat;
  Eigen::VectorXd Areas; // of the surface around the vertices
  UnfoldableFaces Open;
  UnfoldableFaces Closed;
  MapPaper Paper;
  tbb::enumerable_thread_specific<Searches> SearchesOfThreads;
};

Eigen::VectorXd vertexErrors(const std::vector<LocalLengths>& sources, double scale, int vertexCount)
{
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(vertexCount);
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(vertexCount);
  for (const LocalLengths& source : sources)
  {
    for (std::size_t i = 0; i < source.Vertices.size(); ++i)
    {
      errors[source.Vertices[i]] += Percent * std::abs(scale * source.Local.Ratios[i] - 1.0);
      ++counts[source.Vertices[i]];
    }
  }
  return (counts.array() > 0).select(errors.array() / counts.cast<double>().array(), -1.0);
}

// Moves one kind of lengths out of all sources.
std::vector<SourceLengths> taken(std::vector<LocalLengths>& sources, SourceLengths LocalLengths::*kind)
{
  std::vector<SourceLengths> result;
  result.reserve(sources.size());
  for (LocalLengths& source : sources)
  {
    result.push_back(std::move(source.*kind));
  }
  return result;
}

// All pairs as one source: each counts the same.
SourceLengths joined(const std::vector<SourceLengths>& sources)
{
  SourceLengths all;
  for (const SourceLengths& source : sources)
  {
    all.Ratios.insert(all.Ratios.end(), source.Ratios.begin(), source.Ratios.end());
    all.Weights.insert(all.Weights.end(), source.Weights.begin(), source.Weights.end());
  }
  return all;
}

} // namespace

LengthDistortion measureLengths(const TriangleMesh& surface,
  const Points2& flat,
  const LengthOptions& options,
  const ProgressCallback& progress)
{
  requireValid(surface, flat, options);
  const CoordinateFrame frame(surface);
  const PlaneFrame flatFrame(flat);
  const TriangleMesh normalSurface = frame.normalised(surface);
  const Points2 normalFlat = flatFrame.normalised(flat);
  LengthMeasurement measurement(normalSurface, normalFlat);

  std::vector<LocalLengths> lengths = measurement.localLengths(measurement.sources(options.Samples),
    frame.normalisedLength(options.Radius),
    subrange(progress, 0.0, LocalShare));
  LengthDistortion result;
  const SourceLengths rings = joined(taken(lengths, &LocalLengths::Rings));
  result.RingDistanceError = lengthErrors({ rings }).Mean;
  result.WithinMap = lengthErrors(taken(lengths, &LocalLengths::WithinMap));
  std::vector<SourceLengths> local;
  for (const LocalLengths& source : lengths)
  {
    local.push_back(source.Local);
  }
  result.Local = lengthErrors(local);
  result.VertexErrors = vertexErrors(lengths, result.Local.Scale, surface.vertexCount());
  if (result.VertexErrors.maxCoeff() < 0.0)
  {
    throw InvalidInput("no two points of the surface are as near to each other as the LengthRadius of " +
                       formatted(options.Radius) + ": enlarge it to several lengths of an edge");
  }
  lengths.clear();

  const int globalSamples = std::max(2, options.Samples / SamplesPerGlobalSample);
  result.Global = lengthErrors(
    measurement.globalLengths(measurement.sources(globalSamples), subrange(progress, LocalShare, 1.0)));

  const double unit = frame.restoredLength(1.0) / std::sqrt(flatFrame.restoredArea(1.0));
  for (LengthErrors* errors : { &result.Local, &result.WithinMap, &result.Global })
  {
    errors->Scale *= unit;
  }
  return result;
}

} // namespace flattening
