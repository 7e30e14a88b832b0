// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/BoundaryFirstDisk.h"

#include "Base/Errors.h"
#include "Base/SparseFactorization.h"
#include "Conformal/BoundaryAngles.h"
#include "Conformal/ConvexCombinationDisk.h"
#include "Conformal/CotangentWeights.h"
#include "Conformal/CurvatureSystem.h"
#include "Conformal/ProtrusionSpreading.h"
#include "Intrinsic/IntrinsicTriangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
// Change of an angle in an iteration (radians) at which the boundary has settled. Iterations halve the
// error, so the error that is left is no greater than the last change. A choice, far below the
// discretisation error.
constexpr double GreatestChange = 1e-9;
// Most iterations: a guard, for about 25 are needed.
constexpr int MostBoundaryIterations = 200;
constexpr const char* LaplacianStage = "Cotangent Laplacian";

// The Poisson equation on the surface, with the angle defects as its curvature.
class CherrierEquation
{
public:
  CherrierEquation(const IntrinsicTriangulation& t,
    const std::vector<int>& loop,
    const ProgressCallback& progress)
    : Loop(loop)
  {
    const Eigen::VectorXd flat = flatAngleSums(t);
    CurvatureSystem system(t, flat, std::vector<char>(t.vertexCount(), 0));
    system.evaluate(IntrinsicTriangulation::Factors::Zero(t.vertexCount()));
    this->Defects = system.gradient();
    SparseMatrix laplacian = system.hessian();
    laplacian.coeffRef(loop.front(), loop.front()) += 1.0; // holds one factor, as a constant is free
    this->Cholesky.compute(std::move(laplacian), progress, 0.5, LaplacianStage);
    if (this->Cholesky.info() != Eigen::Success)
    {
      throw ConvergenceError(
        "the cotangent Laplacian could not be factored: remesh the surface (Surface To Disk, Remesh)");
    }
  }

  // Logarithmic factors, up to a constant, that give the loop's vertices the exterior angles.
  Eigen::VectorXd factors(const Eigen::VectorXd& exteriorAngles) const
  {
    Eigen::VectorXd right = -this->Defects;
    for (std::size_t k = 0; k < this->Loop.size(); ++k)
    {
      right[this->Loop[k]] += exteriorAngles[k];
    }
    return this->Cholesky.solve(right);
  }
  Eigen::VectorXd boundaryFactors(const Eigen::VectorXd& exteriorAngles) const
  {
    return this->factors(exteriorAngles)(this->Loop);
  }

private:
  const std::vector<int>& Loop;
  Eigen::VectorXd Defects; // flat angle sum minus angle sum
  SparseCholesky Cholesky{ SparseCholesky::Ordering::Quick };
};

// For every vertex of the loop the mean over its two edges, given values of the edges that follow the
// vertices.
Eigen::VectorXd meanOfEdges(const Eigen::VectorXd& edgeValues)
{
  Eigen::VectorXd mean = edgeValues;
  mean[0] += edgeValues[edgeValues.size() - 1];
  mean.tail(edgeValues.size() - 1) += edgeValues.head(edgeValues.size() - 1);
  return 0.5 * mean;
}

Eigen::VectorXd scaledLengths(const Eigen::VectorXd& lengths, const Eigen::VectorXd& u)
{
  Eigen::VectorXd scaled(lengths.size());
  const double unit = u.maxCoeff(); // with which no factor overflows
  for (Eigen::Index k = 0; k < lengths.size(); ++k)
  {
    scaled[k] = lengths[k] * std::exp(0.5 * (u[k] + u[(k + 1) % u.size()]) - unit);
  }
  return scaled;
}

// Adds to the factors those of the Moebius map that centres @p masses on the circle. Returns false if
// half of the mass lies in one point, to the precision of doubles.
bool centre(const Eigen::VectorXd& lengths, const Eigen::VectorXd& masses, Eigen::VectorXd& u)
{
  const Complex up(0.0, 1.0);
  const Eigen::VectorXd angles = anglesInProportion(scaledLengths(lengths, u));
  try
  {
    const Complex inHalfPlane = centreOfMass(halfPlaneBoundary(angles), masses);
    const Complex inDisk = (inHalfPlane - up) / (inHalfPlane + up);
    for (Eigen::Index k = 0; k < u.size(); ++k)
    {
      u[k] -= 2.0 * std::log(std::abs(1.0 - std::conj(inDisk) * std::polar(1.0, angles[k])));
    }
    return true;
  }
  catch (const ConvergenceError&)
  {
    return false;
  }
}

// The angles of the loop's vertices on the circle.
Eigen::VectorXd boundaryAngles(const CherrierEquation& equation,
  const Eigen::VectorXd& lengths,
  int& iterations,
  const ProgressCallback& progress)
{
  const Eigen::VectorXd masses = meanOfEdges(lengths) / lengths.sum();
  Eigen::VectorXd scaled = lengths;
  Eigen::VectorXd angles = anglesInProportion(lengths);
  for (iterations = 1; iterations <= MostBoundaryIterations; ++iterations)
  {
    Eigen::VectorXd u = equation.boundaryFactors(2.0 * EIGEN_PI / scaled.sum() * meanOfEdges(scaled));
    if (!u.allFinite() || !centre(lengths, masses, u))
    {
      break;
    }
    scaled = scaledLengths(lengths, u);
    const Eigen::VectorXd next = anglesInProportion(scaled);
    const double change = (next - angles).lpNorm<Eigen::Infinity>();
    angles = next;
    if (change < GreatestChange)
    {
      return angles;
    }
    report(progress, static_cast<double>(iterations) / MostBoundaryIterations, "Boundary factors");
  }
  throw ConvergenceError(
    "Boundary First stopped at iteration " +
    std::to_string(std::min(iterations, MostBoundaryIterations)) +
    " without the lengths of the boundary in the disk: set Method to Ricci Flow, or "
    "remesh the surface (Surface To Disk, Remesh)");
}

// Logarithmic factors of all vertices for the boundary's position in the disk.
IntrinsicTriangulation::Factors logFactorsOf(const CherrierEquation& equation,
  const Eigen::VectorXd& lengths,
  const std::vector<int>& loop,
  const ComplexVector& disk)
{
  Eigen::VectorXd arcs(lengths.size());
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const double arc = std::arg(disk[loop[(k + 1) % loop.size()]] * std::conj(disk[loop[k]]));
    arcs[k] = arc < 0.0 ? arc + 2.0 * EIGEN_PI : arc;
  }
  Eigen::VectorXd u = equation.factors(meanOfEdges(arcs));
  u.array() += std::log(arcs.sum() / scaledLengths(lengths, u(loop)).sum()) - u(loop).maxCoeff();
  return u.cast<long double>();
}

} // namespace

ConformalDiskMap boundaryFirstDisk(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const DiskCentring& centring,
  const ProgressCallback& progress)
{
  ConformalDiskMap map;
  map.MaxCurvatureError = map.LayoutError = std::numeric_limits<double>::quiet_NaN();
  IntrinsicTriangulation triangulation(mesh);
  map.Flips = triangulation.flipToDelaunay(subrange(progress, 0.0, 0.2));
  map.AddedLength = triangulation.addedLength();
  report(progress, 0.2, LaplacianStage);
  const CherrierEquation equation(triangulation, loop, subrange(progress, 0.2, 0.4));
  const IntrinsicTriangulation::Factors none =
    IntrinsicTriangulation::Factors::Zero(triangulation.vertexCount());
  const Eigen::VectorXd lengths = loopLengths(mesh, loop, map.AddedLength);
  const Eigen::VectorXd angles =
    boundaryAngles(equation, lengths, map.BoundaryIterations, subrange(progress, 0.4, 0.7));
  const ProgressCallback extension = atFraction(progress, 0.7, "Harmonic extension");
  report(extension, 0.0, "");
  ComplexVector disk = convexCombinationDisk(
    cotangentWeights(triangulation, none), WeightSymmetry::Symmetric, loop, angles, centring, extension);
  report(extension, 1.0, "");
  const double area = faceAreas(mesh.Vertices, mesh.Faces).sum();
  const double logMeanFactor = 0.5 * std::log(EIGEN_PI / area);
  const IntrinsicTriangulation::Factors factors = logFactorsOf(equation, lengths, loop, disk);
  const ComplexVector conformal = disk;
  map.SpreadVertices =
    spreadProtrusions(triangulation, none, factors, logMeanFactor, disk, mesh.vertexCount());
  disk = spreadAlongCircle(triangulation, factors, logMeanFactor, mesh.Faces, conformal, disk);
  map.Positions = pointsOf(disk);
  return map;
}

} // namespace flattening
