// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/DiskNormalisation.h"

#include "Base/Errors.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
// Points per task of a parallel loop: enough to outweigh the cost of a task.
constexpr std::size_t PointsPerTask = 4096;
// Distance of the centre of mass from 0, in radii, that Newton's method aims at: a few roundings.
constexpr double CentringTolerance = 1e-14;
// Distance that is accepted where no step reduces it, as rounding of the positions may forbid. A guard:
// maps that are off by more are refused.
constexpr double AcceptedOffset = 1e-9;
// Guards against endless loops: convergence takes a few iterations, and 2^-50 of a step moves nothing.
constexpr int MostNewtonSteps = 200;
constexpr int MostHalvings = 50;
// Longest step, in radii of the disk: the step is worked out for small ones.
constexpr double LongestStep = 0.5;
// Least length of the mean direction, from 0 to 1, that counts as a direction. A guard: in a symmetric
// surface rounding leaves 1e-15, and a rotation by that would depend on the numbering.
constexpr double LeastAsymmetry = 1e-6;

double weightedMedian(const std::vector<double>& values, const Eigen::VectorXd& masses)
{
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  tbb::parallel_sort(order.begin(),
    order.end(),
    [&values](int a, int b) { return values[a] != values[b] ? values[a] < values[b] : a < b; });
  const double half = 0.5 * masses.sum();
  double sum = 0.0;
  for (const int i : order)
  {
    sum += masses[i];
    if (sum >= half)
    {
      return values[i];
    }
  }
  return values[order.back()];
}

// The real or the imaginary parts; 0 for the point at infinity.
std::vector<double> coordinates(const ComplexVector& halfPlane, bool imaginary)
{
  std::vector<double> values;
  for (const Complex& z : halfPlane)
  {
    values.push_back(!std::isfinite(z.real()) ? 0.0 : imaginary ? z.imag() : z.real());
  }
  return values;
}

struct Moments
{
  Complex First{ 0.0, 0.0 };  // sum of mass z
  Complex Second{ 0.0, 0.0 }; // sum of mass z^2
};

Moments moments(const ComplexVector& disk, const Eigen::VectorXd& masses)
{
  Moments m;
  for (std::size_t i = 0; i < disk.size(); ++i)
  {
    m.First += masses[i] * disk[i];
    m.Second += masses[i] * disk[i] * disk[i];
  }
  return m;
}

// The medians of the coordinates, each weighted by the masses: a point amid the mass.
Complex medianOf(const ComplexVector& halfPlane, const Eigen::VectorXd& masses)
{
  return { weightedMedian(coordinates(halfPlane, false), masses),
    weightedMedian(coordinates(halfPlane, true), masses) };
}

// The centre of mass; nothing if Newton's method does not reach it.
std::optional<Complex> foundCentre(const ComplexVector& halfPlane, const Eigen::VectorXd& masses)
{
  // The first centre lies amid the mass, so that no image loses digits by lying close to the circle.
  Complex centre = medianOf(halfPlane, masses);
  if (!(centre.imag() > 0.0))
  {
    const std::vector<double> x = coordinates(halfPlane, false);
    const std::vector<double> y = coordinates(halfPlane, true);
    const auto [left, right] = std::minmax_element(x.begin(), x.end());
    const double highest = *std::max_element(y.begin(), y.end());
    centre.imag(highest > 0.0 ? highest : *right - *left); // 0 if all vertices are on the boundary
  }
  const double total = masses.sum();
  Moments m = moments(cayley(halfPlane, centre), masses);
  for (int iteration = 0; iteration < MostNewtonSteps; ++iteration)
  {
    const double error = std::abs(m.First) / total;
    if (error < CentringTolerance)
    {
      return centre;
    }
    // Newton's method for the Moebius map of the disk that takes a to 0: the first moment after it is
    // First - total a + Second conj(a) for small a, which is solved for a.
    const Complex s = m.Second / total;
    const Complex f = m.First / total;
    Complex step = (f + s * std::conj(f)) / std::max(1.0 - std::norm(s), 1e-12);
    step *= std::min(1.0, LongestStep / std::abs(step));
    bool improved = false;
    for (int trial = 0; trial < MostHalvings && !improved; ++trial, step *= 0.5)
    {
      const Complex next = (centre - step * std::conj(centre)) / (1.0 - step);
      if (!(next.imag() > 0.0))
      {
        continue;
      }
      const Moments moved = moments(cayley(halfPlane, next), masses);
      if (std::abs(moved.First) < std::abs(m.First))
      {
        centre = next;
        m = moved;
        improved = true;
      }
    }
    if (!improved)
    {
      break;
    }
  }
  return std::abs(m.First) <= AcceptedOffset * total ? std::optional<Complex>(centre) : std::nullopt;
}

} // namespace

ComplexVector cayley(const ComplexVector& halfPlane, Complex centre)
{
  ComplexVector disk(halfPlane.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, halfPlane.size(), PointsPerTask),
    [&](const tbb::blocked_range<std::size_t>& points)
    {
      for (std::size_t i = points.begin(); i < points.end(); ++i)
      {
        const Complex z = halfPlane[i];
        disk[i] = std::isfinite(z.real()) ? (z - centre) / (z - std::conj(centre)) : Complex(1.0, 0.0);
      }
    });
  return disk;
}

void moveToCircle(const std::vector<int>& vertices, ComplexVector& disk)
{
  for (const int v : vertices)
  {
    disk[v] /= std::abs(disk[v]);
  }
}

Complex centreOfMass(const ComplexVector& halfPlane, const Eigen::VectorXd& masses)
{
  const std::optional<Complex> centre = foundCentre(halfPlane, masses);
  if (!centre)
  {
    throw ConvergenceError(
      "the conformal disk could not be centred, as happens to long narrow strips: set Domain to "
      "Rectangle, or leave Conformal Disk out and turn Free Outline on in OMT Area Preserving");
  }
  return *centre;
}

std::optional<double> intrinsicRotation(const ComplexVector& disk,
  const Points3& surface,
  const Eigen::VectorXd& masses)
{
  const Eigen::RowVector3d centroid = (masses.transpose() * surface) / masses.sum();
  Complex direction(0.0, 0.0);
  double scale = 0.0;
  for (std::size_t i = 0; i < disk.size(); ++i)
  {
    const double weight = masses[i] * (surface.row(i) - centroid).norm();
    direction += weight * disk[i];
    scale += weight;
  }
  if (!(std::abs(direction) > LeastAsymmetry * scale))
  {
    return std::nullopt;
  }
  return -std::arg(direction);
}

DiskCentring::DiskCentring(const TriangleMesh& mesh)
  : Weights(vertexAreas(mesh))
{
  this->Weights /= this->Weights.sum();
}

DiskCentring::DiskCentring(const TriangleMesh& mesh, int vertex)
  : Vertex(vertex)
  , Weights(Eigen::VectorXd::Unit(mesh.vertexCount(), vertex))
{
}

Complex DiskCentring::centre(const ComplexVector& halfPlane) const
{
  return this->Vertex >= 0 ? halfPlane[this->Vertex] : centreOfMass(halfPlane, this->Weights);
}

Complex DiskCentring::roughCentre(const ComplexVector& halfPlane) const
{
  if (this->Vertex >= 0)
  {
    return halfPlane[this->Vertex];
  }
  const std::optional<Complex> centre = foundCentre(halfPlane, this->Weights);
  return centre ? *centre : medianOf(halfPlane, this->Weights);
}

} // namespace flattening
