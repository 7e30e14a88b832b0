// SPDX-License-Identifier: GPL-3.0-or-later
#include "FaceOrientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace flattening
{

std::vector<signed char> faceOrientations(const Points2& positions, const FaceMatrix& faces)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  const auto point = [&positions](int v) { return Point(positions(v, 0), positions(v, 1)); };
  std::vector<signed char> orientations(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    orientations[f] = static_cast<signed char>(
      CGAL::orientation(point(faces(f, 0)), point(faces(f, 1)), point(faces(f, 2))));
  }
  return orientations;
}

int countFlippedFaces(const Points2& positions, const FaceMatrix& faces)
{
  const std::vector<signed char> orientations = faceOrientations(positions, faces);
  return static_cast<int>(
    std::count_if(orientations.begin(), orientations.end(), [](signed char o) { return o <= 0; }));
}

} // namespace flattening
