// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/WrongFaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{

// The least area ratio of a face in the sum of errors. A guard: the logarithm of a flipped face's ratio
// does not exist.
constexpr double LeastRatio = 1e-3;

// Marks the vertices of a face, and adds those that were not marked to @p found.
void markFace(const FaceMatrix& faces, int face, std::vector<char>& isMarked, std::vector<int>& found)
{
  for (const int v : faces.row(face))
  {
    if (!isMarked[v])
    {
      isMarked[v] = 1;
      found.push_back(v);
    }
  }
}

} // namespace

WrongFaces::WrongFaces(const Eigen::VectorXd& areaRatios, double tolerance)
{
  for (int f = 0; f < static_cast<int>(areaRatios.size()); ++f)
  {
    if (std::abs(areaRatios[f] - 1.0) > tolerance)
    {
      this->Faces.push_back(f);
      this->Distance += std::abs(std::log(std::max(areaRatios[f], LeastRatio)));
    }
  }
  this->Share =
    areaRatios.size() > 0 ? static_cast<double>(this->Faces.size()) / areaRatios.size() : 0.0;
}

double shareOfWrongFaces(const Points2& positions,
  const FaceMatrix& faces,
  const Eigen::VectorXd& targets,
  double tolerance)
{
  const Eigen::VectorXd areas = signedFaceAreas(positions, faces);
  const Eigen::VectorXd ratios = targets.sum() / areas.sum() * areas.cwiseQuotient(targets);
  return WrongFaces(ratios, tolerance).Share;
}

std::vector<char> verticesNear(const std::vector<int>& wrong,
  const FaceMatrix& faces,
  const VertexFaces& facesOf,
  int rings)
{
  std::vector<char> isNear(facesOf.vertexCount(), 0);
  std::vector<int> found; // by the last ring
  for (const int f : wrong)
  {
    markFace(faces, f, isNear, found);
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    for (const int v : std::exchange(found, {}))
    {
      for (const int f : facesOf[v])
      {
        markFace(faces, f, isNear, found);
      }
    }
  }
  return isNear;
}

} // namespace flattening
