// SPDX-License-Identifier: GPL-3.0-or-later
/// How much each face of a flattening is distorted.
///
/// Gamma >= gamma are the singular values of the affine map from the flat triangle to the surface
/// triangle, after both surfaces are scaled to the same total area (the paper, section 5, calls them
/// eigenvalues). If the flattening was asked for other areas than those of the surface, the surface
/// triangle is first scaled to its target area, so that every measure is relative to the request.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Measures per face, all of length m. A face is degenerate if its surface triangle or its flat triangle
/// has no area: it has no shape, and its measures hold the values of an undistorted face. The one
/// exception is AreaRatio, which is 0 where only the flat triangle is degenerate.
struct FaceDistortion
{
  Eigen::VectorXd SurfaceArea;       ///< in SurfaceAreaUnit
  Eigen::VectorXd TargetArea;        ///< requested area, up to one common factor
  Eigen::VectorXd FlatArea;          ///< in FlatAreaUnit; < 0 if oriented against the whole map
  Eigen::VectorXd AreaRatio;         ///< |flat / total flat| / (target / total target); 1 is perfect
  Eigen::VectorXd AreaDistortion;    ///< Upsilon = log(Gamma gamma) = -log(AreaRatio); 0 is perfect
  Eigen::VectorXd AngleDistortion;   ///< Lambda = log(Gamma / gamma) >= 0; 0 is perfect
  Eigen::VectorXd BeltramiMagnitude; ///< |mu| = (K - 1) / (K + 1), K = Gamma / gamma; 0 is perfect
  Eigen::VectorXd StretchL2;         ///< sqrt((Gamma^2 + gamma^2) / 2), Sander et al. 2001; 1 is perfect
  Eigen::VectorXd SymmetricDirichlet;  ///< Gamma^2 + gamma^2 + Gamma^-2 + gamma^-2; 4 is perfect
  Eigen::VectorXd AngleError;          ///< mean over the corners of |flat - surface angle|, degrees
  std::vector<char> Flipped;           ///< 1 if the flat triangle is clockwise or has no area (exact)
  std::vector<char> SurfaceDegenerate; ///< 1 if the surface triangle has no area (exact)
  std::vector<char> FlatDegenerate;    ///< 1 if the flat triangle has no area, exact or after rounding
  /// Input units squared. It is 1 but for surfaces of extreme size, whose areas in input units double
  /// precision may not hold: it is then infinite or 0.
  double SurfaceAreaUnit = 1.0;
  double FlatAreaUnit = 1.0;    ///< the same of the flat surface
  double TotalTargetArea = 0.0; ///< sum of TargetArea
  double TotalFlatArea = 0.0;   ///< sum of FlatArea, the area that the boundary encloses

  int faceCount() const { return static_cast<int>(this->AreaRatio.size()); }
  bool degenerate(int face) const { return this->SurfaceDegenerate[face] || this->FlatDegenerate[face]; }
};

/// Measures the distortion of the map from @p surface to the positions @p flat (n x 2).
/// @param vertexWeights factors by which the area around each vertex should grow, up to one common
/// factor (n, dimensionless, > 0). The target area of a face is its area times the mean weight of its
/// corners. Default: empty, all areas should be kept.
/// @throws InvalidInput if a coordinate is not finite, a weight is not finite and positive, or if the
/// surface or the flat mesh has zero total area.
FaceDistortion measureDistortion(const TriangleMesh& surface,
  const Points2& flat,
  const Eigen::VectorXd& vertexWeights = {});

} // namespace flattening
