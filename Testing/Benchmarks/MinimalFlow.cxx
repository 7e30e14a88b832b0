// SPDX-License-Identifier: GPL-3.0-or-later
#include "MinimalFlow.h"

#include "Mesh/MeshTopology.h"
#include "Mesh/VertexFaces.h"
#include "Yardstick.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening::benchmarks
{
namespace
{

constexpr double CurlLeft = 0.1;      // share of the curl at the start
constexpr double LeastCurl = 0.01;    // share of the distance that the start moves points
constexpr double ShortestPart = 1e-6; // share of a step
constexpr double StreamStep = 0.5;    // share of the width of a face that a step may cross

class Flow
{
public:
  Flow(const TriangleMesh& mesh, const Points2& conformal)
    : Faces(mesh.Faces)
    , Domain(conformal)
    , Areas(signedFaceAreas(conformal, mesh.Faces))
    , FacesOf(mesh.Faces, mesh.vertexCount())
    , Boundary(requireDisk(mesh))
  {
    const Eigen::VectorXd surface = faceAreas(mesh.Vertices, mesh.Faces);
    const Eigen::VectorXd mass =
      vertexAreas(mesh.Faces, surface * (this->Areas.sum() / surface.sum()), mesh.vertexCount());
    this->Density = mass.cwiseQuotient(vertexAreas(mesh.Faces, this->Areas, mesh.vertexCount()));
    // f = 0 on the boundary: its rows become those of the identity.
    std::vector<char> fixed(mesh.vertexCount(), 0);
    for (const int v : this->Boundary)
    {
      fixed[v] = 1;
    }
    SparseMatrix matrix = stiffness(conformal, mesh.Faces);
    for (int column = 0; column < matrix.outerSize(); ++column)
    {
      for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      {
        if (fixed[entry.row()] || fixed[column])
        {
          entry.valueRef() = entry.row() == column ? 1.0 : 0.0;
        }
      }
    }
    this->Cholesky.compute(matrix);
  }

  // The velocity of every vertex of the map u; sets Curl, and Time to the longest stable step.
  FaceVectors velocity(const Points2& u);

  const std::vector<int>& boundary() const { return this->Boundary; }
  double Curl = 0.0;
  double Time = 0.0;

private:
  int upstreamFace(int v, const Eigen::RowVector2d& stream) const;

  const FaceMatrix& Faces;
  const Points2& Domain;
  Eigen::VectorXd Areas;
  VertexFaces FacesOf;
  std::vector<int> Boundary;
  Eigen::VectorXd Density;
  SparseCholesky Cholesky{ SparseCholesky::Ordering::Quick };
};

// The face around v that lies upstream of v; at the boundary, the one nearest to that direction.
int Flow::upstreamFace(int v, const Eigen::RowVector2d& stream) const
{
  int best = -1;
  double greatest = -std::numeric_limits<double>::infinity();
  for (const int f : this->FacesOf[v])
  {
    int k = 0;
    while (this->Faces(f, k) != v)
    {
      ++k;
    }
    Eigen::Matrix2d sides;
    sides.col(0) = (this->Domain.row(this->Faces(f, (k + 1) % 3)) - this->Domain.row(v)).transpose();
    sides.col(1) = (this->Domain.row(this->Faces(f, (k + 2) % 3)) - this->Domain.row(v)).transpose();
    const Eigen::Vector2d shares = sides.inverse() * -stream.transpose();
    const double inside = shares.minCoeff() / std::max(shares.cwiseAbs().maxCoeff(), 1e-300);
    if (inside > greatest)
    {
      greatest = inside;
      best = f;
    }
  }
  return best;
}

FaceVectors Flow::velocity(const Points2& u)
{
  const FaceVectors du = faceGradients(this->Domain, this->Faces, u.col(0));
  const FaceVectors dv = faceGradients(this->Domain, this->Faces, u.col(1));
  const Eigen::VectorXd curl = this->Areas.cwiseProduct(dv.col(0) - du.col(1));
  Eigen::VectorXd rightSide = -vertexAreas(this->Faces, curl, static_cast<int>(u.rows()));
  for (const int v : this->Boundary)
  {
    rightSide[v] = 0.0;
  }
  const Eigen::VectorXd potential = this->Cholesky.solve(rightSide);
  const FaceVectors gradients = faceGradients(this->Domain, this->Faces, potential);
  FaceVectors turned(gradients.rows(), 2);
  turned.col(0) = -gradients.col(1);
  turned.col(1) = gradients.col(0);
  this->Curl = std::sqrt(this->Areas.dot(turned.rowwise().squaredNorm()) / this->Areas.sum());
  const FaceVectors stream = this->Density.cwiseInverse().asDiagonal() *
                             vertexMeans(this->Faces, turned, this->Areas, static_cast<int>(u.rows()));

  FaceVectors result(u.rows(), 2);
  this->Time = std::numeric_limits<double>::infinity();
  for (int v = 0; v < u.rows(); ++v)
  {
    const int f = this->upstreamFace(v, stream.row(v));
    result.row(v) << -du.row(f).dot(stream.row(v)), -dv.row(f).dot(stream.row(v));
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const auto side =
        this->Domain.row(this->Faces(f, (k + 1) % 3)) - this->Domain.row(this->Faces(f, k));
      longest = std::max(longest, side.norm());
    }
    const double across = 2.0 * this->Areas[f] / longest;
    this->Time = std::min(this->Time, StreamStep * across / std::max(stream.row(v).norm(), 1e-300));
  }
  return result;
}

} // namespace

FlowResult minimalFlow(const TriangleMesh& mesh,
  const Points2& conformal,
  const Points2& start,
  double seconds)
{
  const StopWatch watch;
  Flow flow(mesh, conformal);
  FlowResult result;
  result.Positions = start;
  const double way = std::sqrt((start - conformal).squaredNorm() / static_cast<double>(start.rows()));
  double enough = LeastCurl * way;
  while (watch.processorSeconds() < seconds)
  {
    const FaceVectors velocity = flow.velocity(result.Positions);
    enough = result.Steps == 0 ? std::max(enough, CurlLeft * flow.Curl) : enough;
    if (flow.Curl <= enough)
    {
      result.Converged = true;
      break;
    }
    if (advance(result.Positions,
          velocity,
          flow.Time,
          ShortestPart * flow.Time,
          mesh.Faces,
          flow.boundary()) == 0.0)
    {
      break;
    }
    ++result.Steps;
  }
  return result;
}

} // namespace flattening::benchmarks
