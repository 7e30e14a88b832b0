// SPDX-License-Identifier: GPL-3.0-or-later
/// Rounds of face refinement: passes over the patches, and steps of the whole mesh where area must go
/// farther.
#pragma once

#include "Areas/DegreesOfFreedom.h"
#include "Areas/RefinementDescent.h"
#include "Areas/RefinementEnergy.h"
#include "Areas/RefinementPatches.h"
#include "Areas/RefinementTerms.h"
#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"
#include "Mesh/VertexFaces.h"

#include <Eigen/Core>

#include <optional>

namespace flattening
{

/// Of one surface, whose flat map it takes from stage to stage.
class RefinementRounds
{
public:
  /// When to stop before the greatest number of rounds.
  enum class Until
  {
    Enough,   ///< so few faces are off, or rounds in a row bring so little, that more do not pay
    AllRounds ///< never
  };

  /// From where the rounds begin.
  enum class Start
  {
    Transported, ///< shapes count more in the first rounds
    Refined      ///< a map that was refined before: few faces are off, and most of these at once mended
  };

  /// The arguments must live as long as this does.
  RefinementRounds(const TriangleMesh& surface,
    const RefinementTerms& terms,
    const VertexFaces& facesOf,
    const DegreesOfFreedom& unknowns,
    Start start);

  /// @p targets (m, > 0) in sum the area of the domain. @p epsilon as in FaceAreaEnergy: 0 keeps all
  /// faces positive, which they must be then.
  void setStage(const Eigen::VectorXd& targets, double epsilon);

  /// In the next rounds shapes count more, as in the first ones, and steps of the whole mesh begin with
  /// as little damping: faces that lie across each other come apart.
  void startAgain();

  /// @throws Cancelled, ConvergenceError.
  void run(FlatState& state, int most, Until until, const ProgressCallback& progress);

  /// Steps of the whole mesh, if a region of the size of a patch is off by more than @p tolerance, a
  /// share of its area. @throws Cancelled, ConvergenceError.
  void balance(FlatState& state, double tolerance, const ProgressCallback& progress);

  int count() const { return this->Count; } ///< of the rounds so far

private:
  struct WrongFaces;
  WrongFaces wrongFaces(const FlatState& state);
  Eigen::VectorXd presentTargets(const FlatState& state);
  double imbalance(const FlatState& state, const Eigen::VectorXd& targets) const;

  const TriangleMesh& Surface;
  const DegreesOfFreedom& Unknowns;
  RefinementEnergy Energy;
  RefinementPatches Patches;
  std::optional<RefinementDescent> Descent; // of the whole mesh
  Start Begin;
  double Epsilon = 0.0;
  int Count = 0;
  int LastShapeRound;
};

} // namespace flattening
