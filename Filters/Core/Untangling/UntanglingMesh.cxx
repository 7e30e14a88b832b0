// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/UntanglingMesh.h"

#include "Mesh/FaceOrientation.h"
#include "Mesh/PlaneVectors.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

// Bound on the error of a coordinate that is scaled or rotated and rounded, relative to its size: four
// units in the last place, enough for the products and the sum of a rotation. With less, a rotated map
// may flip faces that were counted as positive.
constexpr double CoordinateError = 0x1p-50;

} // namespace

bool UntanglingMesh::safelyPositive(int f) const
{
  if (faceOrientation(this->Positions, this->Faces, f) <= 0)
  {
    return false;
  }
  const auto corner = [&](int k) { return this->Positions.row(this->Faces(f, k)); };
  const Eigen::RowVector2d left = corner(1) - corner(0);
  const Eigen::RowVector2d right = corner(2) - corner(0);
  const double longest = std::max({ left.norm(), right.norm(), (right - left).norm() });
  const double largest = corner(0).cwiseAbs().maxCoeff();
  return cross(left, right) > CoordinateError * largest * longest;
}

double UntanglingMesh::edgeLengthAt(int v) const
{
  double sum = 0.0;
  for (const int f : this->FacesOf[v])
  {
    for (int k = 0; k < 3; ++k)
    {
      sum += (this->Positions.row(this->Faces(f, (k + 1) % 3)) - this->Positions.row(this->Faces(f, k)))
               .norm();
    }
  }
  return sum / (3.0 * this->FacesOf[v].size());
}

} // namespace flattening
