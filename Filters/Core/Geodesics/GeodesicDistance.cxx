// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/GeodesicDistance.h"

#include "Base/Errors.h"
#include "Base/SparseFactorization.h"
#include "Intrinsic/IntrinsicTriangulation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

constexpr const char* DistanceStage = "Distances on the surface";

// Heat below this has lost its digits: the least normal number is 2e-308.
constexpr double LeastHeat = 1e-300;
// The factor by which the time grows where heat does not come through, and the number of times that are
// tried. Heat falls by e for each square root of the time, so that 16^4 squared edges reach 177,000
// edges.
constexpr double LongerTime = 16.0;
constexpr int MostTimes = 5;

// The corners of a face in ascending order of their values.
std::array<int, 3> ascending(const FaceMatrix& faces, Eigen::Index f, const Eigen::VectorXd& values)
{
  std::array<int, 3> corners{ faces(f, 0), faces(f, 1), faces(f, 2) };
  std::sort(corners.begin(), corners.end(), [&values](int a, int b) { return values[a] < values[b]; });
  return corners;
}

// The Laplacian of an intrinsic triangulation, and the quantities of its faces that the heat method
// needs.
struct HeatFaces
{
  explicit HeatFaces(const IntrinsicTriangulation& surface)
    : Surface(surface)
    , Cotangents(surface.faceCount(), 3)
    , Mass(Eigen::VectorXd::Zero(surface.vertexCount()))
    , Laplacian(surface.vertexCount(), surface.vertexCount())
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * static_cast<std::size_t>(surface.halfedgeCount()));
    for (int f = 0; f < surface.faceCount(); ++f)
    {
      // Side k is opposite to corner k + 2.
      const TriangleAngles angles = triangleAngles(
        surface.logLength(3 * f), surface.logLength(3 * f + 1), surface.logLength(3 * f + 2));
      double area = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const int h = 3 * f + k;
        const double cotangent = angles.Cotangent[k];
        const double length = this->length(h);
        this->Cotangents(f, k) = cotangent;
        this->MeanEdge += length / surface.halfedgeCount();
        area += 0.25 * cotangent * length * length;
        const int i = surface.origin(h);
        const int j = surface.tip(h);
        entries.emplace_back(i, i, 0.5 * cotangent);
        entries.emplace_back(j, j, 0.5 * cotangent);
        entries.emplace_back(i, j, -0.5 * cotangent);
        entries.emplace_back(j, i, -0.5 * cotangent);
      }
      for (int k = 0; k < 3; ++k)
      {
        this->Mass[surface.origin(3 * f + k)] += area / 3.0;
      }
    }
    for (int v = 0; v < surface.vertexCount(); ++v)
    {
      entries.emplace_back(v, v, 0.0); // so that every vertex has an entry to which its mass is added
    }
    this->Laplacian.setFromTriplets(entries.begin(), entries.end());
  }

  double length(int h) const { return static_cast<double>(std::exp(this->Surface.logLength(h))); }

  // Integrated divergence of the unit vector field along the gradient of @p values.
  Eigen::VectorXd divergenceOfDirection(const Eigen::VectorXd& values) const
  {
    Eigen::VectorXd divergence = Eigen::VectorXd::Zero(values.size());
    for (int f = 0; f < this->Surface.faceCount(); ++f)
    {
      const auto cotangent = this->Cotangents.row(f);
      double rise[3];
      double squaredNorm = 0.0; // of the gradient, times twice the area
      double doubleArea = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const int h = 3 * f + k;
        rise[k] = values[this->Surface.tip(h)] - values[this->Surface.origin(h)];
        const double length = this->length(h);
        doubleArea += 0.5 * cotangent[k] * length * length;
      }
      // Scaled first: heat far from the source is tiny.
      const double scale = std::max({ std::abs(rise[0]), std::abs(rise[1]), std::abs(rise[2]) });
      if (!(scale > 0.0))
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        squaredNorm += cotangent[k] * (rise[k] / scale) * (rise[k] / scale);
      }
      const double gradient = std::sqrt(squaredNorm / doubleArea) * scale;
      if (!(gradient > 0.0) || !std::isfinite(gradient))
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        const double flux = 0.5 * cotangent[k] * rise[k] / gradient;
        divergence[this->Surface.origin(3 * f + k)] += flux;
        divergence[this->Surface.tip(3 * f + k)] -= flux;
      }
    }
    return divergence;
  }

  const IntrinsicTriangulation& Surface;
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> Cotangents;
  Eigen::VectorXd Mass;
  SparseMatrix Laplacian;
  double MeanEdge = 0.0;
};

// The distances of the heat method, up to a constant.
Eigen::VectorXd distancesByHeat(const TriangleMesh& mesh,
  const std::vector<int>& sources,
  const ProgressCallback& progress)
{
  report(progress, 0.0, DistanceStage);
  // Scaled to unit size by a power of two, so that no decision depends on the unit of length.
  int exponent = 0;
  std::frexp(
    (mesh.Vertices.colwise().maxCoeff() - mesh.Vertices.colwise().minCoeff()).norm(), &exponent);
  TriangleMesh unit = mesh;
  unit.Vertices *= std::ldexp(1.0, -exponent);
  IntrinsicTriangulation surface(unit);
  surface.flipToDelaunay(subrange(progress, 0.1, 0.2));
  report(progress, 0.2, DistanceStage);
  const HeatFaces faces(surface);
  report(progress, 0.3, DistanceStage);
  SparseCholesky factor(SparseCholesky::Ordering::Quick); // of both systems, whose patterns are the same
  const auto solve =
    [&factor](SparseMatrix matrix, const Eigen::VectorXd& rightSide, const ProgressCallback& part)
  {
    factor.compute(std::move(matrix), part, 0.0, DistanceStage);
    Eigen::VectorXd solution;
    if (factor.info() == Eigen::Success)
    {
      solution = factor.solve(rightSide);
    }
    if (factor.info() != Eigen::Success || !solution.allFinite())
    {
      throw ConvergenceError(
        "distances on the surface could not be computed: remesh it (Surface To Disk, Remesh)");
    }
    return solution;
  };
  Eigen::VectorXd impulse = Eigen::VectorXd::Zero(mesh.vertexCount());
  for (const int source : sources)
  {
    impulse[source] = 1.0;
  }
  // Heat that has spread from the sources for a short time, the square of the mean edge length, or
  // longer where it would vanish on its way to the far end.
  Eigen::VectorXd spread;
  Eigen::Index cold = mesh.vertexCount() + 1;
  double time = faces.MeanEdge * faces.MeanEdge;
  for (int trial = 0; cold > 0 && trial < MostTimes; ++trial, time *= LongerTime)
  {
    SparseMatrix heat = faces.Laplacian * time;
    heat.diagonal() += faces.Mass;
    Eigen::VectorXd longer =
      solve(std::move(heat), impulse, subrange(progress, trial == 0 ? 0.3 : 0.7, 0.7));
    const Eigen::Index stillCold = (longer.array().abs() < LeastHeat).count();
    if (stillCold >= cold) // what is left is not joined with a source
    {
      break;
    }
    cold = stillCold;
    spread = std::move(longer);
  }
  report(progress, 0.7, DistanceStage);

  // The function whose gradient has length 1 and points against that of the heat.
  SparseMatrix poisson = faces.Laplacian;
  // This fixes the constant, and nothing else because the right-hand side sums to 0.
  poisson.coeffRef(sources.front(), sources.front()) += 1.0;
  const Eigen::VectorXd divergence = faces.divergenceOfDirection(spread);
  Eigen::VectorXd distance = solve(std::move(poisson), divergence, subrange(progress, 0.8, 1.0));
  report(progress, 1.0, DistanceStage);
  return distance * std::ldexp(1.0, exponent);
}

// The area of the part of the surface where the function, linear on every face, is below `level`.
double areaBelow(const TriangleMesh& mesh, const Eigen::VectorXd& values, double level)
{
  const Eigen::VectorXd areas = faceAreas(mesh.Vertices, mesh.Faces);
  double sum = 0.0;
  for (Eigen::Index f = 0; f < mesh.Faces.rows(); ++f)
  {
    const auto [low, middle, high] = ascending(mesh.Faces, f, values);
    const double a = values[low];
    const double b = values[middle];
    const double c = values[high];
    if (level >= c)
    {
      sum += areas[f];
    }
    else if (level > b)
    {
      sum += areas[f] * (1.0 - (c - level) * (c - level) / ((c - a) * (c - b)));
    }
    else if (level > a)
    {
      sum += areas[f] * (level - a) * (level - a) / ((b - a) * (c - a));
    }
  }
  return sum;
}

} // namespace

Eigen::VectorXd geodesicDistances(const TriangleMesh& mesh, int source, const ProgressCallback& progress)
{
  const Eigen::VectorXd distance = distancesByHeat(mesh, { source }, progress);
  return distance.array() - distance.minCoeff();
}

Eigen::VectorXd geodesicDistances(const TriangleMesh& mesh,
  const std::vector<int>& sources,
  const ProgressCallback& progress)
{
  const Eigen::VectorXd distance = distancesByHeat(mesh, sources, progress);
  return (distance.array() - distance(sources).mean()).cwiseMax(0.0);
}

double levelEnclosingArea(const TriangleMesh& mesh, const Eigen::VectorXd& values, double area)
{
  double low = values.minCoeff();
  double high = values.maxCoeff();
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high))
  {
    (areaBelow(mesh, values, middle) < area ? low : high) = middle;
  }
  return high;
}

double levelCurveLength(const TriangleMesh& mesh, const Eigen::VectorXd& values, double level)
{
  const auto crossing = [&](int from, int to) -> Eigen::RowVector3d
  {
    const double t = (level - values[from]) / (values[to] - values[from]);
    return (1.0 - t) * mesh.Vertices.row(from) + t * mesh.Vertices.row(to);
  };
  double length = 0.0;
  for (Eigen::Index f = 0; f < mesh.Faces.rows(); ++f)
  {
    const auto [low, middle, high] = ascending(mesh.Faces, f, values);
    if (values[low] < level && level <= values[high])
    {
      const Eigen::RowVector3d other =
        values[middle] < level ? crossing(middle, high) : crossing(low, middle);
      length += (crossing(low, high) - other).norm();
    }
  }
  return length;
}

} // namespace flattening
