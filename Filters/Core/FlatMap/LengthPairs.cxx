// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/LengthPairs.h"

#include "Base/Memory.h"
#include "FlatMap/LengthSources.h"
#include "Mesh/Halfedges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

constexpr const char* LocalStage = "Measuring local lengths";
constexpr const char* GlobalStage = "Measuring global lengths";

// The rings of mris_flatten, whose users quote the error of the distances within them.
constexpr int Rings = 7;

// The greatest number of vertices within the rings of a source whose distances are all measured. Rings
// without a vertex of hundreds of edges have about 170, and hardly ever more than 300. Through such a
// vertex they have much of the surface, and around it the time of a search grows with the square of the
// number of edges.
constexpr std::size_t MostInRings = 1000;

// One source out of so many is left where the radius reaches over the whole surface.
constexpr double WidestStride = 16.0;

// So many sources, and up to twice as many, tell how far all of them reach and how much memory they
// take.
constexpr double FirstSources = 16.0;

// Bytes of a pair of points: its ratio and weight in one kind of lengths, in a copy of them, and in a
// list of them that is sorted.
constexpr double BytesPerPair = 3 * 2 * sizeof(double);

// The greatest power of two that is no more than the number; 1 for a number below 1.
std::size_t powerOfTwoUpTo(double number)
{
  std::size_t power = 1;
  while (2.0 * static_cast<double>(power) <= number)
  {
    power *= 2;
  }
  return power;
}

// The multiples of step below count.
std::vector<std::size_t> multiplesOf(std::size_t step, std::size_t count)
{
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < count; i += step)
  {
    numbers.push_back(i);
  }
  return numbers;
}

// @throws InvalidInput if there is not as much memory as the lengths of so many sources take.
void requireMemoryOfSources(std::size_t sources, double pairsPerSource)
{
  requireMemory("measuring lengths from " + std::to_string(sources) + " points",
    BytesPerPair * pairsPerSource * static_cast<double>(sources),
    "lower LengthSamples or LengthRadius");
}

double pairsOf(const LocalLengths& lengths)
{
  return static_cast<double>(
    lengths.Local.Ratios.size() + lengths.WithinMap.Ratios.size() + lengths.Rings.Ratios.size());
}

} // namespace

LengthPairs::LengthPairs(const TriangleMesh& surface, const Points2& flat)
  : Surface(surface)
  , Flat(flat)
  , Areas(vertexAreas(surface))
  , Open(surface, Seams::Open)
  , Closed(surface, Seams::Closed)
  , Paper(surface.Faces, flat)
  , SearchesOfThreads(
      [this]
      {
        return Searches{ GeodesicSearch(this->Closed),
          GeodesicSearch(this->Open),
          MapPathSearch(this->Paper),
          std::vector<char>(this->Surface.vertexCount(), 0) };
      })
{
}

std::vector<int> LengthPairs::sources(int count) const
{
  return drawnByArea(this->Areas, std::min(count, this->Surface.vertexCount()));
}

std::vector<LocalLengths> LengthPairs::local(int samples,
  double radius,
  const ProgressCallback& progress)
{
  const std::vector<int> sources = this->sources(samples);
  std::vector<LocalLengths> lengths(sources.size());
  const SourceTask task([&](std::size_t i, Searches& searches, const GeodesicSearch::Checkpoint& check)
    { lengths[i] = this->localLengthsOf(sources[i], radius, searches, check); });

  const auto count = static_cast<double>(sources.size());
  const std::size_t widest = powerOfTwoUpTo(std::clamp(0.5 * count, 1.0, WidestStride));
  const std::vector<std::size_t> first =
    multiplesOf(std::max(widest, powerOfTwoUpTo(count / FirstSources)), sources.size());
  const double share = static_cast<double>(first.size()) / count;
  this->forEachSource(first, task, LocalStage, subrange(progress, 0.0, share));
  double reached = 0.0; // area
  double pairs = 0.0;
  for (const std::size_t i : first)
  {
    const std::vector<int>& others = lengths[i].Vertices;
    reached += this->Areas(others).sum() + this->Areas[sources[i]];
    pairs += pairsOf(lengths[i]);
  }
  const auto firstCount = static_cast<double>(first.size());
  const double reach = reached / (firstCount * this->Areas.sum());
  const std::size_t stride = std::min(widest, powerOfTwoUpTo(1.0 + static_cast<double>(widest) * reach));
  const std::vector<std::size_t> kept = multiplesOf(stride, sources.size());
  requireMemoryOfSources(kept.size(), pairs / firstCount);

  std::vector<std::size_t> rest;
  std::set_difference(kept.begin(), kept.end(), first.begin(), first.end(), std::back_inserter(rest));
  this->forEachSource(rest, task, LocalStage, subrange(progress, share, 1.0));
  std::vector<LocalLengths> result;
  for (const std::size_t i : kept)
  {
    result.push_back(std::move(lengths[i]));
  }
  return result;
}

std::vector<SourceLengths> LengthPairs::global(int samples, const ProgressCallback& progress)
{
  const std::vector<int> sources = this->sources(samples);
  std::vector<SourceLengths> lengths(sources.size());
  this->forEachSource(multiplesOf(1, sources.size()),
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

void LengthPairs::forEachSource(const std::vector<std::size_t>& sources,
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

LocalLengths LengthPairs::localLengthsOf(int source,
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
  const std::vector<ReachedVertex> nearOnOpen =
    this->Closed.HasClosedSeams ? searches.Open.within(radius, source, check) : near;
  this->addWithinMap(source, nearOnOpen, searches.Map, check, lengths.WithinMap);
  for (const ReachedVertex& other : this->inRings(source, nearOnOpen, searches, check))
  {
    this->add(other, this->straight(source, other), 1.0, lengths.Rings);
  }
  return lengths;
}

// Adds a pair and its straight line on the map. Returns false for a pair that has no length on the
// surface, or no area.
bool LengthPairs::addStraight(int source, const ReachedVertex& other, SourceLengths& lengths) const
{
  return this->add(other, this->straight(source, other), this->Areas[other.Vertex], lengths);
}

double LengthPairs::straight(int source, const ReachedVertex& other) const
{
  return (this->Flat.row(other.Vertex) - this->Flat.row(source)).norm();
}

void LengthPairs::addWithinMap(int source,
  const std::vector<ReachedVertex>& near,
  MapPathSearch& map,
  const GeodesicSearch::Checkpoint& check,
  SourceLengths& lengths) const
{
  std::vector<int> targets(near.size());
  std::transform(
    near.begin(), near.end(), targets.begin(), [](const ReachedVertex& other) { return other.Vertex; });
  const std::vector<double> onMap = map.to(targets, source, check);
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    this->add(near[i], onMap[i], this->Areas[near[i].Vertex], lengths);
  }
}

// The others of the pairs in Rings. @p near are the vertices within the radius.
std::vector<ReachedVertex> LengthPairs::inRings(int source,
  const std::vector<ReachedVertex>& near,
  Searches& searches,
  const GeodesicSearch::Checkpoint& check) const
{
  std::vector<int> others = this->ringsAround(source, searches.IsFound);
  std::vector<ReachedVertex> reached;
  if (others.size() > MostInRings)
  {
    std::sort(others.begin(), others.end());
    std::copy_if(near.begin(),
      near.end(),
      std::back_inserter(reached),
      [&others](const ReachedVertex& other)
      { return std::binary_search(others.begin(), others.end(), other.Vertex); });
    return reached;
  }
  const std::vector<double> distances = searches.Open.to(others, source, check);
  for (std::size_t i = 0; i < others.size(); ++i)
  {
    reached.push_back({ others[i], distances[i] });
  }
  return reached;
}

// The vertices that are no more than Rings edges away, by the number of edges. @p isFound has a 0 for
// every vertex, before and after.
std::vector<int> LengthPairs::ringsAround(int source, std::vector<char>& isFound) const
{
  std::vector<int> found{ source };
  isFound[source] = 1;
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
          if (!isFound[vertex])
          {
            isFound[vertex] = 1;
            found.push_back(vertex);
          }
        }
      }
    }
    begin = end;
  }
  for (const int vertex : found)
  {
    isFound[vertex] = 0;
  }
  return found;
}

bool LengthPairs::add(const ReachedVertex& other,
  double onMap,
  double weight,
  SourceLengths& lengths) const
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

} // namespace flattening
