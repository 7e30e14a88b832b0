// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/FreeOutline.h"

#include "Areas/AreaApproach.h"
#include "Areas/DegreesOfFreedom.h"
#include "Areas/RefinementPatches.h"
#include "Areas/RefinementRounds.h"
#include "Areas/RefinementTerms.h"
#include "Areas/RoughFreeMap.h"
#include "Areas/TargetAreas.h"
#include "Areas/WrongFaces.h"
#include "Base/EigenVersions.h"
#include "Conformal/NaturalOutline.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/OutlineCrossings.h"
#include "Mesh/VertexFaces.h"

#include <cmath>
#include <optional>
#include <utility>

namespace flattening
{
namespace
{

// The share of the faces that a free outline may leave wrong beyond those that are wrong in the domain.
constexpr double GreatestLoss = 0.01;
// A limit of the time; the rounds mostly end earlier, when they no longer help (RefinementRounds). A
// head of 650,000 points with many narrow protrusions has 0.7 % of its faces off with 16 and 0.6 %
// with 24.
constexpr int MostRounds = 24;
// Rounds in which shapes count more. A choice: with 4 instead of 2, the mean angle error of half a brain
// is 8.5 instead of 8.6 degrees.
constexpr int ShapeRounds = 4;
// Areas that are nearer than this to their targets (AreaApproach) are brought to them by the rounds
// alone. A choice.
constexpr double Negligible = 0.02;
// A map whose distortion of shapes is below NearlyKept is taken for that of a surface that can be
// unrolled; the halves of a brain have 0.08. Such a map is brought to the last digits by steps of the
// whole mesh: at most MostWholeRounds rounds of them, until one lowers the energy by less than the share
// LeastRoundGain.
constexpr double NearlyKept = 0.005;
constexpr int MostWholeRounds = 20;
constexpr double LeastRoundGain = 0.1;

class OutlineFreeing
{
public:
  OutlineFreeing(const TriangleMesh& surface,
    const std::vector<int>& loop,
    const Points2& start,
    const Eigen::VectorXd& faceTargets,
    double area,
    double shapeWeight)
    : Surface(surface)
    , Loop(loop)
    , Area(area)
    , FacesOf(surface.Faces, surface.vertexCount())
    , Dofs(surface.vertexCount())
    , Targets(scaledTargets(faceTargets, area))
    , Terms(surface, loop, 1.0, shapeWeight)
    , Rounds(surface,
        this->Terms,
        this->FacesOf,
        this->Dofs,
        start,
        faceTargets,
        RefinementStart::Transport,
        true)
    , Map{ start, {} }
  {
    this->Terms.freeBoundaryWithoutNeedles(loop);
    this->Rounds.setStage(this->Targets, 0.0);
  }

  FreeOutlineMap run(const ProgressCallback& progress)
  {
    this->Map.Positions *= std::sqrt(this->Area / this->covered());
    this->Rounds.favourShapes(ShapeRounds);
    this->Rounds.run(
      this->Map, MostRounds, RefinementRounds::Until::Enough, subrange(progress, 0.0, 0.6));
    this->Rounds.balance(
      this->Map, RefinementRounds::FinalRegionTolerance, subrange(progress, 0.6, 0.7));
    this->Rounds.polish(this->Map, subrange(progress, 0.7, 0.9));
    if (this->Rounds.distortion(this->Map) < NearlyKept)
    {
      this->Rounds.settle(this->Map, LeastRoundGain, MostWholeRounds, subrange(progress, 0.9, 1.0));
    }
    FreeOutlineMap result;
    result.ShareOff = this->shareOff();
    result.Positions = this->centred();
    result.Rounds = this->Rounds.count();
    result.FlippedFaces = countFlippedFaces(result.Positions, this->Surface.Faces);
    result.Bijective = result.FlippedFaces == 0 && isSimpleOutline(result.Positions, this->Loop);
    return result;
  }

private:
  // The share of the faces whose area is off by more than the tolerance.
  double shareOff() const
  {
    return shareOfWrongFaces(
      this->Map.Positions, this->Surface.Faces, this->Targets, RefinementPatches::AreaTolerance);
  }

  double covered() const { return signedFaceAreas(this->Map.Positions, this->Surface.Faces).sum(); }

  // The map with its centroid in the origin and its whole area.
  Points2 centred() const
  {
    const Eigen::VectorXd areas = signedFaceAreas(this->Map.Positions, this->Surface.Faces);
    Eigen::RowVector2d moment = Eigen::RowVector2d::Zero();
    for (int f = 0; f < this->Surface.faceCount(); ++f)
    {
      moment += areas[f] / 3.0 *
                this->Map.Positions(this->Surface.Faces.row(f), flattening::all).colwise().sum();
    }
    const Eigen::RowVector2d centroid = moment / areas.sum();
    return std::sqrt(this->Area / areas.sum()) * (this->Map.Positions.rowwise() - centroid);
  }

  const TriangleMesh& Surface;
  const std::vector<int>& Loop;
  double Area;
  VertexFaces FacesOf;
  DegreesOfFreedom Dofs;
  Eigen::VectorXd Targets;
  RefinementTerms Terms;
  RefinementRounds Rounds;
  DomainMap Map;
};

} // namespace

bool FreeOutlineMap::keepsAreas(double shareOff) const
{
  return this->Bijective && this->ShareOff <= shareOff + GreatestLoss;
}

std::optional<FreeOutlineMap> freeOutlineMap(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& before,
  const Eigen::VectorXd& faceTargets,
  double area,
  double shapeWeight,
  const ProgressCallback& progress)
{
  const bool isWarm = before.rows() == surface.vertexCount() &&
                      countFlippedFaces(before, surface.Faces) == 0 && isSimpleOutline(before, loop);
  constexpr double startEnd = 0.1; // of the progress
  constexpr double roughEnd = 0.4;
  std::optional<Points2> positions;
  if (isWarm)
  {
    positions = before;
  }
  else
  {
    MapsNearNaturalOutline starts(surface, loop, subrange(progress, 0.0, 0.5 * startEnd));
    positions = starts.next(subrange(progress, 0.5 * startEnd, startEnd));
  }
  if (positions && AreaApproach(*positions, surface.Faces, faceTargets).distance() > Negligible)
  {
    positions = roughFreeMap(
      surface, loop, *positions, faceTargets, shapeWeight, subrange(progress, startEnd, roughEnd));
  }
  if (!positions)
  {
    return std::nullopt;
  }
  OutlineFreeing freeing(surface, loop, *positions, faceTargets, area, shapeWeight);
  FreeOutlineMap map = freeing.run(subrange(progress, roughEnd, 1.0));
  map.WarmStarted = isWarm;
  return map;
}

} // namespace flattening
