// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/ConvexCombinationDisk.h"

#include "Base/Errors.h"
#include "Conformal/BoundaryAngles.h"

#include <cmath>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
// Greatest share of the mass that one boundary vertex may carry: with half of it no Moebius map of the
// circle centres the masses, and close to that all other vertices crowd at the far side.
constexpr double GreatestShare = 0.49;

std::vector<char> flagsOf(const std::vector<int>& loop, Eigen::Index vertexCount)
{
  std::vector<char> flags(vertexCount, 0);
  for (const int v : loop)
  {
    flags[v] = 1;
  }
  return flags;
}

class ConvexCombinations
{
public:
  ConvexCombinations(std::vector<NeighbourWeight> weights,
    WeightSymmetry symmetry,
    const std::vector<int>& loop,
    Eigen::Index vertexCount,
    const ProgressCallback& progress)
    : Loop(loop)
    , VertexCount(vertexCount)
    , Progress(progress)
    , Means(std::move(weights), symmetry, flagsOf(loop, vertexCount), progress)
  {
  }

  // The share that every boundary vertex, in the order of the loop, has in the mean of all vertices with
  // the given weights.
  Eigen::VectorXd boundaryShares(const Eigen::VectorXd& vertexWeights)
  {
    const Eigen::VectorXd shares = this->Means.passedToFixed(vertexWeights, this->Progress)(this->Loop);
    return shares / shares.sum();
  }

  // The positions of all vertices for given positions of the boundary.
  ComplexVector extended(const ComplexVector& boundary)
  {
    ComplexVector positions(this->VertexCount, Complex(0.0, 0.0));
    for (std::size_t k = 0; k < this->Loop.size(); ++k)
    {
      positions[this->Loop[k]] = boundary[k];
    }
    this->Means.extend(positions, this->Progress);
    return positions;
  }

private:
  const std::vector<int>& Loop;
  Eigen::Index VertexCount;
  const ProgressCallback& Progress;
  WeightedMeans Means;
};

// The map after the boundary has been moved by the Moebius map that centres the boundary's shares.
ComplexVector centredByBoundary(ConvexCombinations& combinations,
  const Eigen::VectorXd& angles,
  const Eigen::VectorXd& shares)
{
  const ComplexVector halfPlane = halfPlaneBoundary(angles);
  ComplexVector circle = cayley(halfPlane, centreOfMass(halfPlane, shares));
  for (Complex& z : circle)
  {
    z /= std::abs(z);
  }
  return combinations.extended(circle);
}

// The map after all vertices have been moved by a Moebius map. The centre lies close to the boundary
// vertex @p nearest: distances from it keep their digits if it is the origin of the first map, and
// infinity in the half-plane.
ComplexVector centredByAll(ConvexCombinations& combinations,
  const std::vector<int>& loop,
  const Eigen::VectorXd& angles,
  Eigen::Index nearest,
  const DiskCentring& centring)
{
  Eigen::VectorXd rotated = angles.array() - angles[nearest];
  rotated = (rotated.array() < 0.0).select(rotated.array() + 2.0 * EIGEN_PI, rotated);
  ComplexVector boundary(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    boundary[k] = Complex(0.0, 2.0 * std::sin(0.5 * rotated[k])) * std::polar(1.0, 0.5 * rotated[k]);
  }
  ComplexVector halfPlane = combinations.extended(boundary);
  for (std::size_t v = 0; v < halfPlane.size(); ++v)
  {
    Complex& fromNearest = halfPlane[v];
    if (fromNearest == 0.0 && static_cast<int>(v) != loop[nearest])
    {
      throw ConvergenceError("vertex " + std::to_string(v) + " falls onto boundary vertex " +
                             std::to_string(loop[nearest]) +
                             ": the surface is too coarse there; set Method to Ricci Flow, or remesh "
                             "the surface (Surface To Disk, Remesh)");
    }
    fromNearest = Complex(0.0, -1.0) * (2.0 + fromNearest) / fromNearest;
  }
  const ComplexVector line = halfPlaneBoundary(rotated);
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    halfPlane[loop[k]] = line[k];
  }
  ComplexVector disk = cayley(halfPlane, centring.centre(halfPlane));
  moveToCircle(loop, disk);
  return disk;
}

ComplexVector centred(ConvexCombinations& combinations,
  const std::vector<int>& loop,
  const Eigen::VectorXd& angles,
  const DiskCentring& centring)
{
  const Eigen::VectorXd shares = combinations.boundaryShares(centring.weights());
  Eigen::Index nearest = 0;
  return shares.maxCoeff(&nearest) < GreatestShare
           ? centredByBoundary(combinations, angles, shares)
           : centredByAll(combinations, loop, angles, nearest, centring);
}

} // namespace

ComplexVector convexCombinationDisk(const std::vector<NeighbourWeight>& weights,
  WeightSymmetry symmetry,
  const std::vector<int>& loop,
  const Eigen::VectorXd& angles,
  const DiskCentring& centring,
  const ProgressCallback& progress)
{
  ConvexCombinations combinations(weights, symmetry, loop, centring.weights().size(), progress);
  ComplexVector disk = centred(combinations, loop, angles, centring);
  if (centring.vertex() >= 0)
  {
    disk[centring.vertex()] = 0.0; // it is there, but for rounding
  }
  for (const Complex& z : disk)
  {
    if (!std::isfinite(z.real()) || !std::isfinite(z.imag()))
    {
      throw ConvergenceError(
        "a vertex has no position in the disk: remesh the surface (Surface To Disk, "
        "Remesh)");
    }
  }
  return disk;
}

} // namespace flattening
