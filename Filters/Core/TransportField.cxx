// SPDX-License-Identifier: GPL-3.0-or-later
#include "TransportField.h"

#include <Eigen/LU>

#include <tbb/parallel_for.h>

#include <algorithm>

namespace flattening
{
namespace
{

constexpr int VerticesPerTask = 512;
// Of the squared trace of the neighbours' spread: its determinant, where they lie in a line.
constexpr double DegenerateSpread = 1e-6;

std::vector<int> starOf(const FaceMatrix& faces, const VertexFaces& facesOf, int vertex)
{
  std::vector<int> star;
  for (const int f : facesOf[vertex])
  {
    star.insert(star.end(), { faces(f, 0), faces(f, 1), faces(f, 2) });
  }
  std::sort(star.begin(), star.end());
  star.erase(std::unique(star.begin(), star.end()), star.end());
  return star;
}

} // namespace

Points2 transportField(const FaceMatrix& faces,
  const VertexFaces& facesOf,
  const Points2& conformal,
  const Points2& transported,
  const Eigen::VectorXd& masses,
  const std::vector<char>& fixed)
{
  Points2 field = transported;
  const auto fit = [&](int v)
  {
    const std::vector<int> star = starOf(faces, facesOf, v);
    double mass = 0.0;
    Eigen::RowVector2d from = Eigen::RowVector2d::Zero();
    Eigen::RowVector2d to = Eigen::RowVector2d::Zero();
    for (const int u : star)
    {
      mass += masses[u];
      from += masses[u] * conformal.row(u);
      to += masses[u] * transported.row(u);
    }
    from /= mass;
    to /= mass;
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    for (const int u : star)
    {
      const Eigen::RowVector2d offset = conformal.row(u) - from;
      spread += masses[u] * offset.transpose() * offset;
      moments += masses[u] * offset.transpose() * (transported.row(u) - to);
    }
    const double trace = spread.trace();
    if (spread.determinant() > DegenerateSpread * trace * trace)
    {
      field.row(v) = to + (conformal.row(v) - from) * (spread.inverse() * moments);
    }
  };
  const int n = static_cast<int>(transported.rows());
  tbb::parallel_for(tbb::blocked_range<int>(0, n, VerticesPerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int v = range.begin(); v < range.end(); ++v)
      {
        if (!fixed[v])
        {
          fit(v);
        }
      }
    });
  return field;
}

} // namespace flattening
