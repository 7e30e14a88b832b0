// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/FreeOutline.h"

#include "Areas/DegreesOfFreedom.h"
#include "Areas/RefinementPatches.h"
#include "Areas/RefinementRounds.h"
#include "Areas/RefinementTerms.h"
#include "Areas/ShapeDistortion.h"
#include "Areas/SmoothDeformation.h"
#include "Areas/TargetAreas.h"
#include "Base/EigenVersions.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/OutlineCrossings.h"
#include "Mesh/VertexFaces.h"
#include "Untangling/MapUntangling.h"
#include "Untangling/TargetTriangles.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace flattening
{
namespace
{

// The deformations end when one lowers the distortion of shapes by less than LeastShapeGain of it, or
// after MostDeformations. A compromise: the next ones would gain less than a tenth of a degree each.
constexpr int MostDeformations = 10;
constexpr double LeastShapeGain = 0.01;
// The greatest weight of areas against shapes in a deformation. A choice: with more the deformations are
// small, with less the refinement has to correct more.
constexpr double GreatestAreaWeight = 300.0;
// The shares of a deformation to try: with the smaller ones fewer faces flip.
constexpr double Shares[] = { 1.0, 0.5, 0.25 };
// A deformation that flips a larger share of the faces is too much, and so is one that leaves faces
// flipped which only larger patches of vertices would untangle. Guards for the time.
constexpr double MostFlipped = 0.05;
constexpr int LargestUntangledPatch = 200;
// A limit of the time; the last rounds mostly end earlier, when they no longer help (RefinementRounds).
constexpr int LastRounds = 8;
// The share of the faces that may get worse than the tolerance after a deformation and the round that
// follows it. A choice: later rounds mostly make so many faces right again, and with 0.05 small meshes
// keep their domain.
constexpr double GreatestPassingLoss = 0.2;
// The weight of the share of wrong faces against the distortion of shapes, by which a deformation and
// the round after it are judged. A choice: with less, the last deformations of a surface with long folds
// gain little shape and leave areas wrong that no later round makes right.
constexpr double WrongFaceWeight = 0.1;
// Then steps of the whole mesh follow, unless the last rounds ended with such steps that brought little:
// a round at a time, until one lowers the energy by less than this share. One round sets regions right;
// more are worth their time where all shapes can be kept.
constexpr int LastWholeRounds = 20;
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
    , Targets(positiveTargets(faceTargets, area))
    , Terms(surface, loop, 1.0, shapeWeight)
    , Rounds(surface, this->Terms, this->FacesOf, this->Dofs, RefinementStart::Transport, true)
    , OnBoundary(surface.vertexCount(), 0)
    , Map{ positions, {} }
  {
    this->Terms.Gaps.clear();
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      this->Terms.Outline.push_back({ loop[k], loop[(k + 1) % loop.size()] });
      this->OnBoundary[loop[k]] = 1;
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
    const double distortionBefore = this->distortion();
    this->Map.Positions *= std::sqrt(this->Area / this->covered());
    const int deformations = this->deform(subrange(progress, 0.0, 0.7));
    if (deformations == 0)
    {
      return;
    }
    if (!this->Rounds.run(
          this->Map, LastRounds, RefinementRounds::Until::Enough, subrange(progress, 0.7, 0.9)))
    {
      this->Rounds.settle(this->Map, LeastRoundGain, LastWholeRounds, subrange(progress, 0.9, 1.0));
    }
    if (this->distortion() < distortionBefore)
    {
      this->Result.ShareOff = this->shareOff();
      this->Result.Positions = this->centred();
      this->Result.Rounds = this->Rounds.count();
      this->Result.Deformations = deformations;
    }
  }

  // The share of the faces whose area is off by more than the tolerance.
  double shareOff() const
  {
    return shareOfWrongFaces(
      this->Map.Positions, this->Surface.Faces, this->Targets, RefinementPatches::AreaTolerance);
  }

  double cost() const { return this->distortion() + WrongFaceWeight * this->shareOff(); }

  // Returns the number of deformations.
  int deform(const ProgressCallback& progress)
  {
    const double mostOff = this->shareOff() + GreatestPassingLoss;
    double before = this->distortion();
    for (int k = 0; k < MostDeformations; ++k)
    {
      const double begin = static_cast<double>(k) / MostDeformations;
      if (!this->deformOnce(mostOff, subrange(progress, begin, begin + 1.0 / MostDeformations)))
      {
        return k;
      }
      const double after = this->distortion();
      if (before - after < LeastShapeGain * before)
      {
        return k + 1;
      }
      before = after;
    }
    return MostDeformations;
  }

  // A round of the refinement follows the deformation, so that small errors do not add up. Returns
  // false, and leaves the map, if every share of the deformation leaves the outline crossed, faces
  // flipped or more than the share @p mostOff of the areas wrong, or costs more than it gains.
  bool deformOnce(double mostOff, const ProgressCallback& progress)
  {
    const Points2 before = this->Map.Positions;
    const double costBefore = this->cost();
    const Points2 whole = smoothlyDeformed(
      this->Terms, before, this->Targets, this->AreaWeight, subrange(progress, 0.0, 0.5));
    double begin = 0.5;
    for (const double share : Shares)
    {
      const double middle = begin + 0.5 / (2.0 * std::size(Shares));
      const double end = begin + 0.5 / std::size(Shares);
      this->Map.Positions = (1.0 - share) * before + share * whole;
      if (isSimpleOutline(this->Map.Positions, this->Loop) &&
          this->untangle(this->Map, subrange(progress, begin, middle)))
      {
        this->Rounds.favourShapes(1);
        this->Rounds.run(
          this->Map, 1, RefinementRounds::Until::AllRounds, subrange(progress, middle, end));
        if (this->shareOff() <= mostOff && this->cost() < costBefore)
        {
          return true;
        }
      }
      begin = end;
    }
    this->Map.Positions = before;
    return false;
  }

  // Faces that have no vertex inside can be untangled only if the outline moves: first in a round in
  // which all faces are free to flip and the outline keeps from crossing itself, then around the faces
  // that are still flipped, in a way that may cross it.
  bool untangle(DomainMap& map, const ProgressCallback& progress)
  {
    const int flipped = countFlippedFaces(map.Positions, this->Surface.Faces);
    if (flipped > MostFlipped * this->Surface.faceCount())
    {
      return false;
    }
    UntanglingOptions options;
    options.AreaWeight = UntanglingOptions::EqualAreaWeight;
    options.LargestPatch = LargestUntangledPatch;
    const TargetTriangles targets = trianglesOfArea(this->Surface, this->Targets);
    const auto untangled = [&](const std::vector<char>& fixed, double begin)
    {
      return untangleMap(this->Surface.Faces,
               fixed,
               targets,
               map.Positions,
               options,
               subrange(progress, begin, begin + 0.2))
               .FlippedFaces == 0;
    };
    if (untangled(this->OnBoundary, 0.0))
    {
      return true;
    }
    this->Rounds.setStage(this->Targets, RefinementRounds::FlippingEpsilon);
    this->Rounds.run(map, 1, RefinementRounds::Until::AllRounds, subrange(progress, 0.2, 0.6));
    this->Rounds.setStage(this->Targets, 0.0);
    return untangled(this->OnBoundary, 0.6) ||
           (untangled(this->onBoundaryFarFromFlipped(map.Positions), 0.8) &&
             isSimpleOutline(map.Positions, this->Loop));
  }

  std::vector<char> onBoundaryFarFromFlipped(const Points2& positions) const
  {
    std::vector<char> fixed = this->OnBoundary;
    const std::vector<signed char> orientations = faceOrientations(positions, this->Surface.Faces);
    for (int f = 0; f < this->Surface.faceCount(); ++f)
    {
      if (orientations[f] > 0)
      {
        continue;
      }
      for (const int corner : this->Surface.Faces.row(f))
      {
        for (const int face : this->FacesOf[corner])
        {
          for (const int v : this->Surface.Faces.row(face))
          {
            fixed[v] = 0;
          }
        }
      }
    }
    return fixed;
  }

  double distortion() const { return shapeDistortion(this->Terms, this->Map.Positions, this->Targets); }

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
  std::vector<char> OnBoundary;
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
