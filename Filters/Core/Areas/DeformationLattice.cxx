// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/DeformationLattice.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

// Points of one task of a thread. Results do not depend on it.
constexpr int LatticePointsPerTask = 4096;

// The three quadratic B-splines that are not 0 on a square, at the share t of its side, and their
// derivatives by t.
struct Splines
{
  explicit Splines(double t)
    : Values{ 0.5 * (1.0 - t) * (1.0 - t), 0.5 + t * (1.0 - t), 0.5 * t * t }
    , Slopes{ t - 1.0, 1.0 - 2.0 * t, t }
  {
  }
  std::array<double, 3> Values;
  std::array<double, 3> Slopes;
};

} // namespace

DeformationLattice::DeformationLattice(const Eigen::AlignedBox2d& box, int squares)
  : Origin(box.min())
  , Side(box.sizes().maxCoeff() / squares)
  , Columns(std::max(1, static_cast<int>(std::ceil(box.sizes().x() / this->Side))))
  , Rows(std::max(1, static_cast<int>(std::ceil(box.sizes().y() / this->Side))))
{
}

DeformationLattice::Influence DeformationLattice::influenceOn(const Eigen::Vector2d& point) const
{
  const Eigen::Vector2d offset = (point - this->Origin) / this->Side;
  const int column = std::clamp(static_cast<int>(offset.x()), 0, this->Columns - 1);
  const int row = std::clamp(static_cast<int>(offset.y()), 0, this->Rows - 1);
  const Splines alongX(offset.x() - column);
  const Splines alongY(offset.y() - row);
  Influence influence;
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int k = 3 * j + i;
      influence.Nodes[k] = (row + j) * (this->Columns + 2) + column + i;
      influence.Weights[k] = alongX.Values[i] * alongY.Values[j];
      influence.Gradients[k] =
        Eigen::Vector2d(alongX.Slopes[i] * alongY.Values[j], alongX.Values[i] * alongY.Slopes[j]) /
        this->Side;
    }
  }
  return influence;
}

Points2 DeformationLattice::moved(const Points2& points, const Points2& displacements) const
{
  Points2 result(points.rows(), 2);
  tbb::parallel_for(tbb::blocked_range<Eigen::Index>(0, points.rows(), LatticePointsPerTask),
    [&](const tbb::blocked_range<Eigen::Index>& range)
    {
      for (Eigen::Index p = range.begin(); p < range.end(); ++p)
      {
        const Influence influence = this->influenceOn(points.row(p));
        Eigen::RowVector2d moved = points.row(p);
        for (int k = 0; k < 9; ++k)
        {
          moved += influence.Weights[k] * displacements.row(influence.Nodes[k]);
        }
        result.row(p) = moved;
      }
    });
  return result;
}

} // namespace flattening
