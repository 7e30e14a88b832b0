// SPDX-License-Identifier: GPL-3.0-or-later
/// Statistics of the distortion of the faces of a region or of the whole flattening.
#pragma once

#include "FlatMap/DistortionMeasures.h"

#include <array>
#include <vector>

namespace flattening
{

/// Statistics of one measure over the faces that are not degenerate. All are 0 if there are none.
struct MeasureStatistics
{
  double Mean = 0.0;             ///< every face counts the same
  double AreaWeightedMean = 0.0; ///< every face counts by its surface area
  double P95 = 0.0;              ///< 95th percentile over the faces (nearest rank)
  double P99 = 0.0;              ///< 99th percentile over the faces (nearest rank)
  double Max = 0.0;
};

/// The measures that have statistics, in the order of DistortionSummary::Measures.
enum class Measure
{
  AreaError,          ///< 100 |AreaRatio - 1|, percent
  AreaDistortion,     ///< |Upsilon|
  AngleDistortion,    ///< Lambda
  BeltramiMagnitude,  ///< |mu|
  StretchL2,          ///< of Sander et al.
  SymmetricDirichlet, ///< at least 4
  AngleError          ///< degrees
};
inline constexpr int MeasureCount = 7;
/// Names of the measures, for array and column names.
inline constexpr std::array<const char*, MeasureCount> MeasureNames = { "AreaError",
  "AreaDistortion",
  "AngleDistortion",
  "BeltramiMagnitude",
  "StretchL2",
  "SymmetricDirichlet",
  "AngleError" };

struct DistortionSummary
{
  int Faces = 0;
  double SurfaceArea = 0.0; ///< input units squared
  /// Area that the outer boundary of the faces encloses (flat units squared). Flipped faces, which lie
  /// on top of others, count negative.
  double FlatArea = 0.0;
  /// Percent by which the share of these faces in the flat area differs from their share in the target
  /// area. Errors of single faces that cancel within the region do not show here.
  double AreaErrorPercent = 0.0;
  /// Percent of the faces, except those without surface area, that are not flipped and whose AreaRatio
  /// is within 0.02 of 1.
  double FacesWithin2Percent = 0.0;
  int FlippedFaces = 0;               ///< number of faces that are clockwise or have no area on the map
  int DegenerateFaces = 0;            ///< number of faces without area on the surface or on the map
  double RootMeanSquareStretch = 0.0; ///< area-weighted, Sander et al. 2001; 1 is perfect
  /// Standard deviation of AreaRatio over the faces that have area on the surface, each counted once; 0
  /// is perfect.
  double SDAreaRatio = 0.0;
  /// The same of its natural logarithm, over the faces that are not degenerate.
  double SDLogAreaRatio = 0.0;
  std::array<MeasureStatistics, MeasureCount> Measures;

  const MeasureStatistics& operator[](Measure measure) const
  {
    return this->Measures[static_cast<int>(measure)];
  }
};

/// Sums up the distortion of the given faces. The statistics leave out degenerate faces; only AreaError
/// counts faces with area on the surface and none on the map, with 100 percent.
DistortionSummary summariseDistortion(const FaceDistortion& distortion, const std::vector<int>& faces);

/// Sums up the distortion of all faces.
DistortionSummary summariseDistortion(const FaceDistortion& distortion);

} // namespace flattening
