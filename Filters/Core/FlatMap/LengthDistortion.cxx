// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/LengthDistortion.h"

#include "Base/Errors.h"
#include "FlatMap/LengthPairs.h"
#include "Mesh/CoordinateFrame.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// A source of global lengths takes about forty times as long as one of local lengths, so this share of
// the sources must do. Lengths over the whole surface vary less from source to source.
constexpr int SamplesPerGlobalSample = 20;

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
  LengthPairs pairs(normalSurface, normalFlat);

  std::vector<LocalLengths> lengths = pairs.local(
    options.Samples, frame.normalisedLength(options.Radius), subrange(progress, 0.0, LocalShare));
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
  result.Global = lengthErrors(pairs.global(globalSamples, subrange(progress, LocalShare, 1.0)));

  const double unit = frame.restoredLength(1.0) / std::sqrt(flatFrame.restoredArea(1.0));
  for (LengthErrors* errors : { &result.Local, &result.WithinMap, &result.Global })
  {
    errors->Scale *= unit;
  }
  return result;
}

} // namespace flattening
