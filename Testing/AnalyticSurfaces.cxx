// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace flattening::analytic
{
namespace
{

constexpr double Pi = EIGEN_PI;

// The integral from 0 to t, to the last digits for smooth functions.
double integral(const SurfaceOfRevolution::Function& f, double t)
{
  return boost::math::quadrature::gauss<double, 40>::integrate(f, 0.0, t);
}

Eigen::RowVector3d pointOf(const SurfaceOfRevolution& surface, double t, double angle)
{
  const double r = surface.Radius(t);
  return { r * std::cos(angle), r * std::sin(angle), surface.Height(t) };
}

// The meridian parameter within which @p share of the area lies.
double parameterOfShare(const SurfaceOfRevolution& surface, double share)
{
  double low = 0.0;
  double high = surface.End;
  for (int step = 0; step < 50; ++step)
  {
    const double middle = 0.5 * (low + high);
    (surface.AreaShare(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

struct Ring
{
  int First; // vertex
  int Count;
  int Shift; // of the angles, in half steps

  int vertex(int k) const { return this->First + k % this->Count; }
};

// Adds the faces between two rings: the ring whose current vertex has the smaller angle advances.
void stitch(const Ring& inner, const Ring& outer, std::vector<Eigen::RowVector3i>& faces)
{
  int a = 0;
  int b = 0;
  while (a < inner.Count || b < outer.Count)
  {
    const long long nextInner = (2LL * (a + 1) + inner.Shift) * outer.Count;
    const long long nextOuter = (2LL * (b + 1) + outer.Shift) * inner.Count;
    if (a == inner.Count || (b < outer.Count && nextOuter <= nextInner))
    {
      faces.emplace_back(inner.vertex(a), outer.vertex(b), outer.vertex(b + 1));
      ++b;
    }
    else
    {
      faces.emplace_back(inner.vertex(a), outer.vertex(b), inner.vertex(a + 1));
      ++a;
    }
  }
}

void setFaces(TriangleMesh& mesh, const std::vector<Eigen::RowVector3i>& faces)
{
  mesh.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    mesh.Faces.row(static_cast<Eigen::Index>(f)) = faces[f];
  }
}

// Computes the points from their angles and parameters.
void placeVertices(RevolutionMesh& mesh, const SurfaceOfRevolution& surface)
{
  mesh.Mesh.Vertices.resize(mesh.Parameter.size(), 3);
  for (Eigen::Index v = 0; v < mesh.Parameter.size(); ++v)
  {
    mesh.Mesh.Vertices.row(v) = pointOf(surface, mesh.Parameter[v], mesh.Angle[v]);
  }
}

} // namespace

double SurfaceOfRevolution::brenierRadius(double t) const
{
  return std::sqrt(this->AreaShare(t));
}

SurfaceOfRevolution flatDisk()
{
  SurfaceOfRevolution disk;
  disk.Radius = [](double t) { return t; };
  disk.Height = [](double) { return 0.0; };
  disk.ConformalRadius = [](double t) { return t; };
  disk.AreaShare = [](double t) { return t * t; };
  disk.Area = Pi;
  return disk;
}

SurfaceOfRevolution sphericalCap(double angle)
{
  SurfaceOfRevolution cap;
  cap.End = angle;
  cap.Radius = [](double t) { return std::sin(t); };
  cap.Height = [](double t) { return std::cos(t); };
  cap.ConformalRadius = [angle](double t) { return std::tan(0.5 * t) / std::tan(0.5 * angle); };
  cap.AreaShare = [angle](double t) { return std::pow(std::sin(0.5 * t) / std::sin(0.5 * angle), 2); };
  cap.Area = 4.0 * Pi * std::pow(std::sin(0.5 * angle), 2);
  return cap;
}

SurfaceOfRevolution paraboloid(double steepness)
{
  const double k = 2.0 * steepness;
  const auto q = [k](double r) { return std::sqrt(1.0 + k * k * r * r); };
  // ds / r = q dr / r has the integral q + log(k r / (q + 1)).
  const auto potential = [k, q](double r) { return q(r) + std::log(k * r / (q(r) + 1.0)); };
  const auto area = [k, q](double r) { return 2.0 * Pi / (3.0 * k * k) * (std::pow(q(r), 3) - 1.0); };
  SurfaceOfRevolution surface;
  surface.Radius = [](double t) { return t; };
  surface.Height = [steepness](double t) { return -steepness * t * t; };
  surface.ConformalRadius = [potential](double t)
  { return t > 0.0 ? std::exp(potential(t) - potential(1.0)) : 0.0; };
  surface.AreaShare = [area](double t) { return area(t) / area(1.0); };
  surface.Area = area(1.0);
  return surface;
}

SurfaceOfRevolution gaussianBump(double height, double width)
{
  const auto z = [height, width](double r) { return height * std::exp(-r * r / (2.0 * width * width)); };
  // sqrt(1 + z'^2) - 1 and 1/r of it, without cancellation and regular on the axis.
  const auto stretchOverRadius = [z, width](double r)
  {
    const double slopeOverRadius = z(r) / (width * width);
    const double slope = slopeOverRadius * r;
    return slopeOverRadius * slope / (std::sqrt(1.0 + slope * slope) + 1.0);
  };
  const auto potential = [stretchOverRadius](double r) { return integral(stretchOverRadius, r); };
  const auto area = [stretchOverRadius](double r) {
    return Pi * r * r + 2.0 * Pi * integral([&](double x) { return x * x * stretchOverRadius(x); }, r);
  };
  SurfaceOfRevolution surface;
  surface.Radius = [](double t) { return t; };
  surface.Height = z;
  surface.ConformalRadius = [potential, whole = potential(1.0)](double t)
  { return t * std::exp(potential(t) - whole); };
  surface.Area = area(1.0);
  surface.AreaShare = [area, whole = surface.Area](double t) { return area(t) / whole; };
  return surface;
}

SurfaceOfRevolution capsule(double length)
{
  SurfaceOfRevolution surface;
  surface.End = 0.5 * Pi + length;
  surface.Radius = [](double t) { return t < 0.5 * Pi ? std::sin(t) : 1.0; };
  surface.Height = [](double t) { return t < 0.5 * Pi ? std::cos(t) : 0.5 * Pi - t; };
  surface.ConformalRadius = [length](double t)
  { return t < 0.5 * Pi ? std::exp(-length) * std::tan(0.5 * t) : std::exp(t - 0.5 * Pi - length); };
  const auto area = [](double t)
  { return 2.0 * Pi * (t < 0.5 * Pi ? 2.0 * std::pow(std::sin(0.5 * t), 2) : 1.0 + t - 0.5 * Pi); };
  surface.Area = area(surface.End);
  surface.AreaShare = [area, whole = surface.Area](double t) { return area(t) / whole; };
  return surface;
}

RevolutionMesh ringMesh(const SurfaceOfRevolution& surface, int vertexCount)
{
  // The number of vertices of a ring grows up to the ring at this share of the meridian.
  double widest = surface.End;
  for (int i = 1000;
       i > 0 && surface.Radius(surface.End * (i - 1) / 1000.0) > 0.999 * surface.Radius(surface.End);
       --i)
  {
    widest = surface.End * (i - 1) / 1000.0;
  }
  const double growing = widest < 0.8 * surface.End ? widest / surface.End : 1.0;
  // K rings, of which K * growing grow, have 3 K^2 (2 growing - growing^2) + 3 K growing + 1 vertices.
  const double share = (2.0 - growing) * growing;
  const int ringCount = std::max(
    1, static_cast<int>(std::lround(std::sqrt(vertexCount / (3.0 * share)) - 0.5 * growing / share)));
  const int largest = std::max(1, static_cast<int>(std::lround(growing * ringCount)));

  std::vector<Ring> rings;
  std::vector<Eigen::RowVector3i> faces;
  std::vector<double> parameters{ 0.0 };
  std::vector<double> angles{ 0.0 };
  for (int i = 1; i <= ringCount; ++i)
  {
    const Ring ring{
      static_cast<int>(angles.size()), 6 * std::min(i, largest), std::max(0, i - largest)
    };
    for (int k = 0; k < ring.Count; ++k)
    {
      parameters.push_back(surface.End * i / ringCount);
      angles.push_back(Pi * (2.0 * k + ring.Shift) / ring.Count);
    }
    if (i == 1)
    {
      for (int k = 0; k < ring.Count; ++k)
      {
        faces.emplace_back(0, ring.vertex(k), ring.vertex(k + 1));
      }
    }
    else
    {
      stitch(rings.back(), ring, faces);
    }
    rings.push_back(ring);
  }
  RevolutionMesh mesh;
  mesh.FirstBoundaryVertex = rings.back().First;
  mesh.Parameter = Eigen::Map<const Eigen::VectorXd>(parameters.data(), parameters.size());
  mesh.Angle = Eigen::Map<const Eigen::VectorXd>(angles.data(), angles.size());
  setFaces(mesh.Mesh, faces);
  placeVertices(mesh, surface);
  return mesh;
}

RevolutionMesh sunflowerMesh(const SurfaceOfRevolution& surface, int vertexCount)
{
  const double edge = std::sqrt(surface.Area / vertexCount);
  const int boundary =
    std::max(6, static_cast<int>(std::lround(2.0 * Pi * surface.Radius(surface.End) / edge)));
  const int interior = vertexCount - boundary;
  const double goldenAngle = Pi * (3.0 - std::sqrt(5.0));
  RevolutionMesh mesh;
  mesh.FirstBoundaryVertex = interior;
  mesh.Parameter = Eigen::VectorXd::Constant(vertexCount, surface.End);
  mesh.Angle = Eigen::VectorXd::Zero(vertexCount);
  mesh.Parameter[0] = 0.0;
  for (int v = 1; v < vertexCount; ++v)
  {
    if (v < interior)
    {
      // A boundary vertex stands for half the area of an interior one.
      mesh.Parameter[v] = parameterOfShare(surface, v / (interior + 0.5 * boundary));
      mesh.Angle[v] = std::remainder(v * goldenAngle, 2.0 * Pi);
    }
    else
    {
      mesh.Angle[v] = 2.0 * Pi * (v - interior) / boundary;
    }
  }
  placeVertices(mesh, surface);

  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
  using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;
  std::vector<std::pair<Kernel::Point_2, int>> points;
  for (int v = 0; v < vertexCount; ++v)
  {
    const auto image = std::polar(surface.ConformalRadius(mesh.Parameter[v]), mesh.Angle[v]);
    points.emplace_back(Kernel::Point_2(image.real(), image.imag()), v);
  }
  const Delaunay delaunay(points.begin(), points.end());
  std::vector<Eigen::RowVector3i> faces;
  for (auto face = delaunay.finite_faces_begin(); face != delaunay.finite_faces_end(); ++face)
  {
    const Eigen::RowVector3i corners(
      face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info());
    if (corners.minCoeff() < interior) // rounding lets three boundary vertices span a face
    {
      faces.push_back(corners);
    }
  }
  setFaces(mesh.Mesh, faces);
  return mesh;
}

double radialError(const RevolutionMesh& mesh,
  const Points2& positions,
  const SurfaceOfRevolution::Function& radius)
{
  double sum = 0.0;
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    sum += std::pow(positions.row(v).norm() - radius(mesh.Parameter[v]), 2);
  }
  return std::sqrt(sum / positions.rows());
}

double largestError(const RevolutionMesh& mesh,
  const Points2& positions,
  const SurfaceOfRevolution::Function& radius)
{
  using Complex = std::complex<double>;
  const auto found = [&](Eigen::Index v) { return Complex(positions(v, 0), positions(v, 1)); };
  const auto expected = [&](Eigen::Index v)
  { return std::polar(radius(mesh.Parameter[v]), mesh.Angle[v]); };
  Complex turn = 0.0;
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    turn += found(v) * std::conj(expected(v));
  }
  turn /= std::abs(turn);
  double largest = 0.0;
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    largest = std::max(largest, std::abs(found(v) - turn * expected(v)));
  }
  return largest;
}

} // namespace flattening::analytic
