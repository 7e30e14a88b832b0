// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColonSurface.h"

#include "Support/MarchingTetrahedra.h"
#include "Support/RandomNumbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flattening::phantom
{
namespace
{

constexpr double Pi = EIGEN_PI;
constexpr double Length = 300.0;
constexpr double BendRadius = 150.0; // of the centre line, an arc in the plane z = 0
constexpr double TubeRadius = 20.0;
constexpr double FoldSpacing = 25.0;
constexpr double FoldHeight = 7.0;
constexpr double FoldWidth = 3.0; // standard deviation along the colon
constexpr double Rounding = 1.0;

// Coordinates along the centre line, away from it and around it.
struct ColonPlace
{
  double Along;
  double Radius;
  double Angle;
};

ColonPlace placeOf(const Eigen::RowVector3d& x)
{
  const double fromAxis = std::hypot(x[0], x[1]);
  return { BendRadius * std::atan2(x[1], x[0]),
    std::hypot(fromAxis - BendRadius, x[2]),
    std::atan2(x[2], fromAxis - BendRadius) };
}

Eigen::RowVector3d pointAt(double along, double radius, double angle)
{
  const double bend = along / BendRadius;
  const double fromAxis = BendRadius + radius * std::cos(angle);
  return { fromAxis * std::cos(bend), fromAxis * std::sin(bend), radius * std::sin(angle) };
}

double wallRadius(double along, double angle)
{
  const double phase = along - FoldSpacing * std::round(along / FoldSpacing);
  const double fold = std::exp(-0.5 * phase * phase / (FoldWidth * FoldWidth));
  const double betweenTaeniae = 0.5 - 0.5 * std::cos(3.0 * angle);
  return TubeRadius + 1.5 * std::cos(2.0 * Pi * along / Length) * std::sin(angle) -
         FoldHeight * fold * betweenTaeniae;
}

// The greater of two distances, with a rounded transition where they are equal.
double smoothMaximum(double a, double b)
{
  const double blend = std::max(Rounding - std::abs(a - b), 0.0) / Rounding;
  return std::max(a, b) + 0.25 * Rounding * blend * blend;
}

std::vector<Polyp> drawPolyps(unsigned seed)
{
  samples::RandomNumbers random(seed);
  std::vector<Polyp> polyps;
  for (const double diameter : { 12.0, 10.0, 8.0, 6.0, 4.0 })
  {
    for (int count = 0; count < 3;)
    {
      const double along = random.real(-0.5 * Length + 25.0, 0.5 * Length - 25.0);
      const double angle = random.real(-Pi, Pi);
      const Eigen::RowVector3d centre = pointAt(along, wallRadius(along, angle), angle);
      if (std::all_of(polyps.begin(),
            polyps.end(),
            [&](const Polyp& other) { return (other.Centre - centre).norm() >= 18.0; }))
      {
        polyps.push_back({ centre, diameter });
        ++count;
      }
    }
  }
  return polyps;
}

} // namespace

Colon generateColon(double spacing, unsigned seed)
{
  Colon colon;
  colon.Polyps = drawPolyps(seed);
  const double bend = 0.5 * Length / BendRadius; // on either side of the x axis
  const double outer = BendRadius + TubeRadius + 4.0;
  const Eigen::RowVector3d low(
    (BendRadius - TubeRadius - 4.0) * std::cos(bend), -outer * std::sin(bend), -TubeRadius - 4.0);
  const Eigen::RowVector3d high(outer, outer * std::sin(bend), TubeRadius + 4.0);
  std::array<int, 3> size{};
  for (int k = 0; k < 3; ++k)
  {
    size[k] = static_cast<int>(std::ceil((high[k] - low[k]) / spacing)) + 1;
  }
  samples::Volume lumen(size);
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        const Eigen::RowVector3d point = low + spacing * Eigen::RowVector3d(x, y, z);
        const ColonPlace place = placeOf(point);
        double outside = place.Radius - wallRadius(place.Along, place.Angle);
        for (const Polyp& polyp : colon.Polyps)
        {
          outside = smoothMaximum(outside, 0.5 * polyp.Diameter - (point - polyp.Centre).norm());
        }
        lumen.at(x, y, z) = -outside;
      }
    }
  }
  TriangleMesh whole = samples::marchingTetrahedra(lumen);
  whole.Vertices = (spacing * whole.Vertices).rowwise() + low;

  // Leaves out the parts beyond the ends.
  std::vector<int> number(whole.vertexCount(), -1);
  int count = 0;
  for (int v = 0; v < whole.vertexCount(); ++v)
  {
    if (std::abs(placeOf(whole.Vertices.row(v)).Along) <= 0.5 * Length - 5.0)
    {
      number[v] = count++;
    }
  }
  colon.Mesh.Vertices.resize(count, 3);
  for (int v = 0; v < whole.vertexCount(); ++v)
  {
    if (number[v] >= 0)
    {
      colon.Mesh.Vertices.row(number[v]) = whole.Vertices.row(v);
    }
  }
  colon.Mesh.Faces.resize(whole.faceCount(), 3);
  Eigen::Index kept = 0;
  for (int f = 0; f < whole.faceCount(); ++f)
  {
    const Eigen::RowVector3i face(
      number[whole.Faces(f, 0)], number[whole.Faces(f, 1)], number[whole.Faces(f, 2)]);
    if (face.minCoeff() >= 0)
    {
      colon.Mesh.Faces.row(kept++) = face;
    }
  }
  colon.Mesh.Faces.conservativeResize(kept, 3);
  return colon;
}

} // namespace flattening::phantom
