// SPDX-License-Identifier: GPL-3.0-or-later
/// Rounds of face refinement: passes over the patches, and deformations of the domain or steps of the
/// whole mesh where area must move farther than a patch reaches.
#pragma once

#include "Areas/DegreesOfFreedom.h"
#include "Areas/MapDeformation.h"
#include "Areas/RefinementDescent.h"
#include "Areas/RefinementEnergy.h"
#include "Areas/RefinementPatches.h"
#include "Areas/RefinementTerms.h"
#include "Areas/WarmStart.h"
#include "Areas/WrongFaces.h"
#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"
#include "Mesh/VertexFaces.h"

#include <Eigen/Core>

#include <optional>

namespace flattening
{

/// The rounds of one surface. The caller sets a stage and runs its rounds on the flat map.
class RefinementRounds
{
public:
  /// When to stop before the greatest number of rounds.
  enum class Until
  {
    Enough,   ///< when few faces are off, or when rounds in a row bring too little
    AllRounds ///< never
  };

  /// The epsilon of FaceAreaEnergy where faces may flip: how far, in target areas. A choice: less makes
  /// flipped faces stiff, more leaves more of them flipped.
  static constexpr double FlippingEpsilon = 0.1;

  /// From the transport on, shapes count more in the first rounds. After a warm start they do not, and
  /// the rounds end earlier. @p asksForAreas: whether shapes count only as far as areas leave them free.
  /// @p chart: see RefinementPatches. @p targets (m, >= 0): the areas that the faces should have, up to
  /// a common factor (faceCounts). The arguments except @p targets must live as long as this does.
  RefinementRounds(const TriangleMesh& surface,
    const RefinementTerms& terms,
    const VertexFaces& facesOf,
    const DegreesOfFreedom& dofs,
    const Points2& chart,
    const Eigen::VectorXd& targets,
    RefinementStart start,
    bool asksForAreas);

  /// @p targets (m, > 0): the areas of the faces, with the domain's area as their sum. @p epsilon >= 0,
  /// see FaceAreaEnergy: with 0 faces do not flip, and all of them must be positive at the start.
  void setStage(const Eigen::VectorXd& targets, double epsilon);

  /// Lets shapes count more in the next @p rounds, as in the first ones, and resets the damping of the
  /// steps of the whole mesh: faces that lie across each other come apart.
  void favourShapes(int rounds);
  static constexpr int FirstShapeRounds = 2; ///< how many first rounds those are

  /// The region error above which a refinement ends with deformations (balance): regions are what people
  /// measure. With it the errors of the demo's regions are 0.02 %.
  static constexpr double FinalRegionTolerance = 2e-4;

  /// Runs at most @p most rounds. @throws Cancelled, ConvergenceError.
  void run(DomainMap& map, int most, Until until, const ProgressCallback& progress);

  /// Deforms the map smoothly, at most @p most times, until that hardly lowers the distortion of shapes
  /// any more. @p areaWeight (> 0) is the weight of areas against shapes. Returns the number of
  /// deformations: 0 if angles are asked for, or thin faces would flip. @throws Cancelled.
  int lowerDistortion(DomainMap& map, double areaWeight, int most, const ProgressCallback& progress);

  /// The distortion of shapes (shapeDistortion).
  double distortion(const DomainMap& map) const;

  /// Whether few faces are off, as few as end a stage, and no region of the size of a patch by as much
  /// as in the rounds: a map for the same weights is.
  bool isNearlyRight(const DomainMap& map);

  /// Deforms the map, or makes steps of the whole mesh where it cannot be deformed, if the area of a
  /// region of the size of a patch is off by more than the share @p tolerance.
  /// @throws Cancelled, ConvergenceError.
  void balance(DomainMap& map, double tolerance, const ProgressCallback& progress);

  /// Makes steps of the whole mesh, at most @p most rounds of them, until a round lowers the energy by
  /// less than the share @p leastGain. @throws Cancelled, ConvergenceError.
  void settle(DomainMap& map, double leastGain, int most, const ProgressCallback& progress);

  /// Makes the last rounds, with shapes at half their weight. Only vertices near faces that are off by
  /// more than 0.4 % move, or near wrong faces after a warm start: the areas of these faces come nearer
  /// to their targets than in rounds that end with the tolerance, and those that balance() has left off
  /// come right. If the area weights have a wide range, steps of the whole mesh (settle) come first, but
  /// not after a warm start. @throws Cancelled, ConvergenceError.
  void polish(DomainMap& map, const ProgressCallback& progress);

  int count() const { return this->Count; } ///< number of rounds so far

private:
  WrongFaces wrongFaces(const DomainMap& map, double tolerance = RefinementPatches::AreaTolerance);
  std::vector<char> nearWrongFaces(const DomainMap& map, double tolerance, int rings);
  double imbalance(const DomainMap& map);
  bool deform(DomainMap& map,
    DeformationEnergy::Shapes shapes,
    double areaWeight,
    const ProgressCallback& progress);
  bool isFree() const { return this->Dofs.loop().empty(); } // the boundary
  bool isWarm() const { return this->Start == RefinementStart::WarmStart; }
  RefinementPatches::Pass pass(const DomainMap& map);
  int runPatches(RefinementPatches::Pass& pass, DomainMap& map, const ProgressCallback& progress);
  double descend(DomainMap& map, const ProgressCallback& progress);

  const TriangleMesh& Surface;
  const RefinementTerms& Terms;
  const VertexFaces& FacesOf;
  const DegreesOfFreedom& Dofs;
  const Points2& Chart;
  RefinementEnergy Energy;
  MapDeformation Deformation;
  std::optional<RefinementDescent> Descent; // of the whole mesh
  RefinementStart Start;
  bool AsksForAreas;
  Eigen::VectorXd AreaWeights;
  Eigen::VectorXd Counts;
  double Epsilon = 0.0;
  bool FlipsIfDeformed = false; // as found at some deformation
  int Count = 0;
  int Passes = 0; // over the patches
  int LastShapeRound;
};

} // namespace flattening
