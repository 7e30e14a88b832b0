// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/OutlineScaffold.h"

#include "Mesh/OutlineGaps.h"

#include <vector>

namespace flattening
{
namespace
{

// The weights of the areas and of the shapes of gaps. A choice: far less than those of faces, and enough
// for gaps not to become thin.
constexpr double ScaffoldWeight = 0.01;
// How much a gap counts, in faces of mean area. A choice: with 0.1 and 1, a skull has a mean angle error
// of 13.5 and 13.6 degrees, and the former takes half more time.
constexpr double ScaffoldCount = 1.0;
// The least area of a gap, in mean areas of faces. A guard: the inverses of smaller ones mean nothing.
constexpr double LeastGapArea = 1e-12;

template <typename Matrix>
Matrix joined(const Matrix& first, const Matrix& second)
{
  Matrix all(first.rows() + second.rows(), first.cols());
  all << first, second;
  return all;
}

FaceMatrix gapsOf(const std::vector<FlatEdge>& outline,
  const Points2& positions,
  double leastArea,
  OutlineScaffold::ShallowBays bays)
{
  FaceMatrix gaps = outlineGaps(positions, outline);
  if (bays == OutlineScaffold::ShallowBays::Open)
  {
    gaps = withoutShallowBays(gaps, positions, outline);
  }
  const Eigen::VectorXd areas = signedFaceAreas(positions, gaps);
  Eigen::Index count = 0;
  for (Eigen::Index gap = 0; gap < gaps.rows(); ++gap)
  {
    if (areas[gap] >= leastArea)
    {
      gaps.row(count++) = gaps.row(gap).eval();
    }
  }
  gaps.conservativeResize(count, 3);
  return gaps;
}

RefinementTerms withGaps(const RefinementTerms& terms, const FaceMatrix& gaps, const Points2& positions)
{
  TriangleMesh flat{ Points3::Zero(positions.rows(), 3), gaps };
  flat.Vertices.leftCols<2>() = positions;
  const RefinementTerms ofGaps(flat, {}, 1.0, ScaffoldWeight);
  RefinementTerms all;
  all.Faces = joined(terms.Faces, ofGaps.Faces);
  all.Cotangents = joined(terms.Cotangents, ofGaps.Cotangents);
  all.ShapeWeights = joined(terms.ShapeWeights, ofGaps.ShapeWeights);
  all.ShapeLimits = joined(terms.ShapeLimits, ofGaps.ShapeLimits);
  all.Outline = terms.Outline;
  return all;
}

} // namespace

OutlineScaffold::OutlineScaffold(const RefinementTerms& terms,
  const Points2& positions,
  const Eigen::VectorXd& targets,
  ShallowBays bays)
  : All(
      withGaps(terms, gapsOf(terms.Outline, positions, LeastGapArea * targets.mean(), bays), positions))
  , FacesOf(this->All.Faces, static_cast<int>(positions.rows()))
  , GapAreas(
      signedFaceAreas(positions, this->All.Faces.bottomRows(this->All.Faces.rows() - targets.size())))
  , MeanTarget(targets.mean())
{
}

Eigen::VectorXd OutlineScaffold::targets(const Eigen::VectorXd& ofMesh) const
{
  return joined(ofMesh, this->GapAreas);
}

Eigen::VectorXd OutlineScaffold::areaWeights(const Eigen::VectorXd& ofMesh) const
{
  return joined(ofMesh, Eigen::VectorXd::Constant(this->GapAreas.size(), ScaffoldWeight).eval());
}

Eigen::VectorXd OutlineScaffold::counts(const Eigen::VectorXd& ofMesh) const
{
  return joined(ofMesh, (ScaffoldCount * this->MeanTarget * this->GapAreas.cwiseInverse()).eval());
}

} // namespace flattening
