// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/FaceOrientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace flattening
{

signed char faceOrientation(const Points2& positions, const FaceMatrix& faces, int face)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  const auto corner = [&](int k)
  {
    const int v = faces(face, k);
    return Point(positions(v, 0), positions(v, 1));
  };
  return static_cast<signed char>(CGAL::orientation(corner(0), corner(1), corner(2)));
}

std::vector<signed char> faceOrientations(const Points2& positions, const FaceMatrix& faces)
{
  std::vector<signed char> orientations(faces.rows());
  for (int f = 0; f < faces.rows(); ++f)
  {
    orientations[f] = faceOrientation(positions, faces, f);
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
