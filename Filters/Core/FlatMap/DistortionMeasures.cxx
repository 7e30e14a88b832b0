// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/DistortionMeasures.h"

#include "Base/Errors.h"
#include "Mesh/CoordinateFrame.h"
#include "Mesh/FaceOrientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <complex>
#include <string>

namespace flattening
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double DegreesPerRadian = 180.0 / EIGEN_PI;

void requireMeasurable(const TriangleMesh& surface, const Points2& flat, const Eigen::VectorXd& weights)
{
  for (int v = 0; v < surface.vertexCount(); ++v)
  {
    if (!surface.Vertices.row(v).allFinite())
    {
      throw InvalidInput(
        "vertex " + std::to_string(v) +
        " has a surface coordinate that is not finite: clean the data before flattening");
    }
    if (!flat.row(v).allFinite())
    {
      throw InvalidInput("vertex " + std::to_string(v) +
                         " has a flat coordinate that is not finite: run the flattening again");
    }
    if (weights.size() > 0 && !(weights[v] > 0.0 && std::isfinite(weights[v])))
    {
      throw InvalidInput("vertex " + std::to_string(v) + " has the area weight " +
                         formatted(weights[v]) + ": weights must be positive and finite");
    }
  }
}

// Edge vectors of a triangle from its first corner, as complex numbers in its own plane.
struct EdgePair
{
  std::complex<double> First;
  std::complex<double> Second;
};

EdgePair flatEdges(const Points2& flat, const Eigen::RowVector3i& face)
{
  const Eigen::RowVector2d u = flat.row(face[1]) - flat.row(face[0]);
  const Eigen::RowVector2d v = flat.row(face[2]) - flat.row(face[0]);
  return { { u.x(), u.y() }, { v.x(), v.y() } };
}

EdgePair surfaceEdges(const Points3& vertices, const Eigen::RowVector3i& face)
{
  const Eigen::Vector3d u = vertices.row(face[1]) - vertices.row(face[0]);
  const Eigen::Vector3d v = vertices.row(face[2]) - vertices.row(face[0]);
  const double length = u.norm();
  return { length, { u.dot(v) / length, u.cross(v).norm() / length } };
}

// Interior angles of the triangle with these edges.
std::array<double, 3> cornerAngles(const EdgePair& edges)
{
  const auto angle = [](std::complex<double> u, std::complex<double> v)
  { return std::abs(std::arg(std::conj(u) * v)); };
  const std::complex<double> third = edges.Second - edges.First;
  return { angle(edges.First, edges.Second), angle(-edges.First, third), angle(edges.Second, third) };
}

struct SingularValues
{
  double Larger;
  double Smaller;
  double Beltrami; // (Larger - Smaller) / (Larger + Smaller), without the cancellation
};

// The linear map w = alpha z + beta conj(z) that takes the edges z to the edges w, both
// counter-clockwise.
SingularValues singularValues(const EdgePair& z, const EdgePair& w)
{
  const double determinant = std::imag(std::conj(z.First) * z.Second);
  const double alpha =
    std::abs(w.First * std::conj(z.Second) - w.Second * std::conj(z.First)) / (2.0 * determinant);
  const double beta = std::abs(w.Second * z.First - w.First * z.Second) / (2.0 * determinant);
  const double larger = alpha + beta;
  const double smaller = std::imag(std::conj(w.First) * w.Second) / determinant / larger;
  return { larger, smaller, beta / alpha };
}

EdgePair scaled(const EdgePair& edges, double factor)
{
  return { factor * edges.First, factor * edges.Second };
}

bool collinear(const Points3& vertices, const Eigen::RowVector3i& face)
{
  const auto point = [&vertices](int v)
  { return Kernel::Point_3(vertices(v, 0), vertices(v, 1), vertices(v, 2)); };
  return CGAL::collinear(point(face[0]), point(face[1]), point(face[2]));
}

// Sets the measures of face f other than its area ratio.
// @param scale factor from lengths of the surface triangle to flat lengths.
void measureShape(const TriangleMesh& surface,
  const Points2& flat,
  double scale,
  int f,
  FaceDistortion& result)
{
  const Eigen::RowVector3i face = surface.Faces.row(f);
  EdgePair z = flatEdges(flat, face);
  const EdgePair w = surfaceEdges(surface.Vertices, face);
  if (result.Flipped[f])
  {
    z = { std::conj(z.First), std::conj(z.Second) };
  }
  const SingularValues sigma = singularValues(z, scaled(w, scale));
  const double squares = sigma.Larger * sigma.Larger + sigma.Smaller * sigma.Smaller;
  const double area = sigma.Larger * sigma.Smaller;
  const double symmetricDirichlet = squares + squares / (area * area);
  if (!std::isfinite(symmetricDirichlet))
  {
    result.FlatDegenerate[f] = 1;
    return;
  }
  result.AreaDistortion[f] = -std::log(result.AreaRatio[f]);
  result.AngleDistortion[f] = std::log(sigma.Larger / sigma.Smaller);
  result.BeltramiMagnitude[f] = sigma.Beltrami;
  result.StretchL2[f] = std::sqrt(0.5 * squares);
  result.SymmetricDirichlet[f] = symmetricDirichlet;

  const std::array<double, 3> flatAngles = cornerAngles(z);
  const std::array<double, 3> surfaceAngles = cornerAngles(w);
  double difference = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    difference += std::abs(flatAngles[k] - surfaceAngles[k]);
  }
  result.AngleError[f] = DegreesPerRadian * difference / 3.0;
}

FaceDistortion undistorted(int faceCount)
{
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(faceCount);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(faceCount);
  FaceDistortion result;
  result.AreaRatio = result.StretchL2 = one;
  result.AreaDistortion = result.AngleDistortion = result.BeltramiMagnitude = result.AngleError = zero;
  result.SymmetricDirichlet = 4.0 * one;
  result.Flipped.assign(faceCount, 0);
  result.SurfaceDegenerate.assign(faceCount, 0);
  result.FlatDegenerate.assign(faceCount, 0);
  return result;
}

// The areas that the faces should get, up to one common factor.
Eigen::VectorXd targetAreas(const FaceMatrix& faces,
  const Eigen::VectorXd& surfaceAreas,
  const Eigen::VectorXd& weights)
{
  Eigen::VectorXd targets = surfaceAreas;
  if (weights.size() > 0)
  {
    for (int f = 0; f < faces.rows(); ++f)
    {
      targets[f] *= (weights[faces(f, 0)] + weights[faces(f, 1)] + weights[faces(f, 2)]) / 3.0;
    }
  }
  return targets;
}

} // namespace

namespace
{

// Precondition: products of coordinates neither overflow nor underflow.
FaceDistortion measureInFrame(const TriangleMesh& surface,
  const Points2& flat,
  const Eigen::VectorXd& vertexWeights)
{
  const int faceCount = surface.faceCount();
  FaceDistortion result = undistorted(faceCount);
  const std::vector<signed char> orientations = faceOrientations(flat, surface.Faces);
  const Eigen::VectorXd signedFlatArea = signedFaceAreas(flat, surface.Faces);
  result.SurfaceArea = faceAreas(surface.Vertices, surface.Faces);
  result.TargetArea = targetAreas(surface.Faces, result.SurfaceArea, vertexWeights);
  // The whole map may be mirrored; faces that are oriented against the whole count negative.
  result.FlatArea = signedFlatArea.sum() < 0.0 ? Eigen::VectorXd(-signedFlatArea) : signedFlatArea;

  const double totalTarget = result.TotalTargetArea = result.TargetArea.sum();
  const double totalFlat = result.TotalFlatArea = result.FlatArea.sum();
  if (!(totalTarget > 0.0))
  {
    throw InvalidInput("the surface has zero area: all of its triangles are degenerate");
  }
  if (!(totalFlat > 0.0))
  {
    throw InvalidInput("the flat surface has zero area: run the flattening again");
  }

  tbb::parallel_for(0,
    faceCount,
    [&](int f)
    {
      result.Flipped[f] = orientations[f] <= 0;
      // A face whose rounded area contradicts the exact sign is too thin to be measured.
      result.FlatDegenerate[f] = !(orientations[f] * signedFlatArea[f] > 0.0);
      result.SurfaceDegenerate[f] =
        !(result.SurfaceArea[f] > 0.0) || collinear(surface.Vertices, surface.Faces.row(f));
      if (!result.SurfaceDegenerate[f])
      {
        const double flatShare =
          result.FlatDegenerate[f] ? 0.0 : std::abs(result.FlatArea[f]) / totalFlat;
        result.AreaRatio[f] = flatShare / (result.TargetArea[f] / totalTarget);
      }
      if (!result.degenerate(f))
      {
        const double growth = result.TargetArea[f] / result.SurfaceArea[f];
        measureShape(surface, flat, std::sqrt(growth * totalFlat / totalTarget), f, result);
      }
    });
  return result;
}

} // namespace

FaceDistortion measureDistortion(const TriangleMesh& surface,
  const Points2& flat,
  const Eigen::VectorXd& vertexWeights)
{
  requireMeasurable(surface, flat, vertexWeights);
  const CoordinateFrame frame(surface);
  const PlaneFrame flatFrame(flat);
  FaceDistortion result =
    measureInFrame(frame.normalised(surface), flatFrame.normalised(flat), vertexWeights);
  result.SurfaceAreaUnit = frame.restoredArea(1.0);
  result.FlatAreaUnit = flatFrame.restoredArea(1.0);
  return result;
}

} // namespace flattening
