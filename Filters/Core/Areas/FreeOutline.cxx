// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/FreeOutline.h"

#include "Areas/DegreesOfFreedom.h"
#include "Areas/RefinementPatches.h"
#include "Areas/RefinementRounds.h"
#include "Areas/RefinementTerms.h"
#include "Areas/SmoothDeformation.h"
#include "Areas/TargetAreas.h"
#include "Base/EigenVersions.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/OutlineCrossings.h"
#include "Mesh/VertexFaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{

// The greatest weight of areas against shapes in the deformations. A choice: with more the deformations
// are small, with less the refinement has to correct more.
constexpr double GreatestAreaWeight = 300.0;
// Deformations on a lattice end after MostDeformations, or when one and the round after it lower the
// distortion of shapes by less than LeastDeformationGain of it. A compromise: on half a brain, 0.01
// makes the mean angle error 8.2 instead of 8.3 degrees and takes a fifth more time.
constexpr int MostDeformations = 10;
constexpr double LeastDeformationGain = 0.05;
// The greatest fineness of the lattice of the deformations (smoothlyDeformed). The lattice becomes twice
// as fine when deformations on it end, unless the first one on the finer lattice hardly helped either.
// Measured: white matter with the cut of Automatic has 18.9 and 18.1 degrees of mean angle error with 2
// and 4, and half a brain without a relief gains nothing.
constexpr int GreatestFineness = 4;
// A limit of the time; the rounds mostly end earlier, when they no longer help (RefinementRounds). A head
// of 650,000 points with many narrow protrusions has 2.1 % of its faces off with 16 and 1.8 % with 24.
constexpr int MostRounds = 24;
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
    const Points2& positions,
    const Eigen::VectorXd& faceTargets,
    double area,
    double shapeWeight)
    : Surface(surface)
    , Loop(loop)
    , Area(area)
    , AreaWeight(std::min(GreatestAreaWeight, 1.0 / shapeWeight))
    , FacesOf(surface.Faces, surface.vertexCount())
    , Dofs(surface.vertexCount())
    , Targets(scaledTargets(faceTargets, area))
    , Terms(surface, loop, 1.0, shapeWeight)
    , Rounds(surface,
        this->Terms,
        this->FacesOf,
        this->Dofs,
        positions,
        faceTargets,
        RefinementStart::Transport,
        true)
    , Map{ positions, {} }
  {
    this->Terms.Gaps.clear();
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      this->Terms.Outline.push_back({ loop[k], loop[(k + 1) % loop.size()] });
    }
    this->Rounds.setStage(this->Targets, 0.0);
  }

  FreeOutlineResult run(const ProgressCallback& progress)
  {
    this->Result.Positions = this->Map.Positions;
    if (this->isOneToOne(this->Map.Positions))
    {
      this->free(progress);
    }
    this->Result.FlippedFaces = countFlippedFaces(this->Result.Positions, this->Surface.Faces);
    this->Result.Bijective =
      this->Result.FlippedFaces == 0 && isSimpleOutline(this->Result.Positions, this->Loop);
    return std::move(this->Result);
  }

private:
  bool isOneToOne(const Points2& positions) const
  {
    return countFlippedFaces(positions, this->Surface.Faces) == 0 &&
           isSimpleOutline(positions, this->Loop);
  }

  // Leaves the result as it is if the map with a free outline would gain nothing.
  void free(const ProgressCallback& progress)
  {
    this->Result.ShareOff = this->shareOff();
    const double distortionBefore = this->Rounds.distortion(this->Map);
    this->Map.Positions *= std::sqrt(this->Area / this->covered());
    const int deformations = this->deform(subrange(progress, 0.0, 0.6));
    if (deformations == 0)
    {
      return;
    }
    this->refine(subrange(progress, 0.6, 1.0));
    if (this->Rounds.distortion(this->Map) < distortionBefore)
    {
      this->Result.ShareOff = this->shareOff();
      this->Result.Positions = this->centred();
      this->Result.Rounds = this->Rounds.count();
      this->Result.Deformations = deformations;
    }
  }

  // Deforms the map on finer and finer lattices. Returns the number of deformations.
  int deform(const ProgressCallback& progress)
  {
    const int vertices = this->Surface.vertexCount();
    int count = 0;
    for (int fineness = 1; fineness <= GreatestFineness; fineness *= 2)
    {
      const bool isFirst = fineness == 1;
      if (!isFirst && latticeSquares(vertices, fineness) == latticeSquares(vertices, fineness / 2))
      {
        break;
      }
      const double begin = 1.0 - 1.0 / fineness;
      this->Rounds.setFineness(fineness);
      const int done = this->deformOnLattices(subrange(progress, begin, 0.5 * (begin + 1.0)));
      count += done;
      if (done < (isFirst ? 1 : 2))
      {
        break;
      }
    }
    this->Rounds.setFineness(1);
    return count;
  }

  // Deforms the map on lattices of the same fineness until one of the deformations hardly helps. A round
  // of the refinement follows each: otherwise errors of areas and stretched faces would add up and keep
  // the next one from going on. Returns the number of deformations.
  int deformOnLattices(const ProgressCallback& progress)
  {
    double before = this->Rounds.distortion(this->Map);
    for (int k = 0; k < MostDeformations; ++k)
    {
      const double begin = static_cast<double>(k) / MostDeformations;
      const ProgressCallback part = subrange(progress, begin, begin + 1.0 / MostDeformations);
      if (this->Rounds.lowerDistortion(this->Map, this->AreaWeight, 1, subrange(part, 0.0, 0.5)) == 0)
      {
        return k;
      }
      this->Rounds.favourShapes(1);
      this->Rounds.run(this->Map, 1, RefinementRounds::Until::AllRounds, subrange(part, 0.5, 1.0));
      const double after = this->Rounds.distortion(this->Map);
      if (before - after < LeastDeformationGain * before)
      {
        return k + 1;
      }
      before = after;
    }
    return MostDeformations;
  }

  void refine(const ProgressCallback& progress)
  {
    this->Rounds.run(
      this->Map, MostRounds, RefinementRounds::Until::Enough, subrange(progress, 0.0, 0.6));
    this->Rounds.balance(
      this->Map, RefinementRounds::FinalRegionTolerance, subrange(progress, 0.6, 0.7));
    this->Rounds.polish(this->Map, subrange(progress, 0.7, 0.9));
    if (this->Rounds.distortion(this->Map) < NearlyKept)
    {
      this->Rounds.settle(this->Map, LeastRoundGain, MostWholeRounds, subrange(progress, 0.9, 1.0));
    }
  }

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
  double AreaWeight;
  VertexFaces FacesOf;
  DegreesOfFreedom Dofs;
  Eigen::VectorXd Targets;
  RefinementTerms Terms;
  RefinementRounds Rounds;
  DomainMap Map;
  FreeOutlineResult Result;
};

} // namespace

FreeOutlineResult freeOutline(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& positions,
  const Eigen::VectorXd& faceTargets,
  double area,
  double shapeWeight,
  const ProgressCallback& progress)
{
  return OutlineFreeing(surface, loop, positions, faceTargets, area, shapeWeight).run(progress);
}

} // namespace flattening
