// SPDX-License-Identifier: GPL-3.0-or-later
#include "LieAdvection.h"

#include "Mesh/MeshTopology.h"
#include "Yardstick.h"

#include <algorithm>

namespace flattening::benchmarks
{
namespace
{

// Shares of the time in which excess areas decay by the factor e.
constexpr double WholeStep = 1.0;
constexpr double ShortStep = 0.25;
constexpr double GreatestMove = 0.3; // share of the least altitude around a vertex

// Shortens the moves, vertex by vertex, so that no face flips. Global steps would be as short as the
// thinnest face needs them.
FaceVectors withinFaces(FaceVectors moves, const Points2& positions, const FaceMatrix& faces)
{
  const Eigen::VectorXd areas = signedFaceAreas(positions, faces);
  Eigen::VectorXd room = Eigen::VectorXd::Constant(positions.rows(), 1.0);
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      longest =
        std::max(longest, (positions.row(faces(f, k)) - positions.row(faces(f, (k + 1) % 3))).norm());
    }
    for (int k = 0; k < 3; ++k)
    {
      room[faces(f, k)] = std::min(room[faces(f, k)], GreatestMove * 2.0 * areas[f] / longest);
    }
  }
  for (Eigen::Index v = 0; v < moves.rows(); ++v)
  {
    const double length = moves.row(v).norm();
    if (length > room[v])
    {
      moves.row(v) *= std::max(room[v], 0.0) / length;
    }
  }
  return moves;
}

} // namespace

FlowResult lieAdvection(const TriangleMesh& mesh,
  const Points2& conformal,
  double tolerance,
  double seconds)
{
  const StopWatch watch;
  const FaceMatrix& faces = mesh.Faces;
  const std::vector<int> boundary = requireDisk(mesh);
  const Eigen::VectorXd surface = faceAreas(mesh.Vertices, faces);
  SparseCholesky cholesky(SparseCholesky::Ordering::Quick);
  FlowResult result;
  result.Positions = conformal;
  while (watch.processorSeconds() < seconds)
  {
    const Eigen::VectorXd flat = signedFaceAreas(result.Positions, faces);
    const Eigen::VectorXd own = vertexAreas(faces, flat, mesh.vertexCount());
    const Eigen::VectorXd wanted =
      vertexAreas(faces, surface * (flat.sum() / surface.sum()), mesh.vertexCount());
    if ((wanted - own).lpNorm<1>() <= tolerance * wanted.sum())
    {
      result.Converged = true;
      break;
    }
    SparseMatrix matrix = stiffness(result.Positions, faces);
    matrix.coeffRef(0, 0) *= 2.0; // the potential is known but for a constant
    cholesky.compute(matrix);
    if (cholesky.info() != Eigen::Success)
    {
      break;
    }
    const Eigen::VectorXd potential = cholesky.solve(own - wanted);
    FaceVectors velocity =
      vertexMeans(faces, faceGradients(result.Positions, faces, potential), flat, mesh.vertexCount());
    velocity = own.cwiseQuotient(wanted).asDiagonal() * velocity;
    if (!velocity.allFinite())
    {
      break;
    }
    if (advance(result.Positions, velocity, WholeStep, ShortStep, faces, boundary) == 0.0)
    {
      result.Positions += withinFaces(ShortStep * velocity, result.Positions, faces);
      for (const int v : boundary)
      {
        result.Positions.row(v).normalize();
      }
    }
    ++result.Steps;
  }
  return result;
}

} // namespace flattening::benchmarks
