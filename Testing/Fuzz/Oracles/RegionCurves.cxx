// SPDX-License-Identifier: GPL-3.0-or-later
#include "RegionCurves.h"

#include "MeshLengths.h"
#include "RegionFigures.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFlattenRegion.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace fuzz
{
namespace
{

// The least length of the greatest diameter, as a share of a lower bound of the true one: the filter
// searches it from a few points only.
constexpr long double LeastShare = 0.9L;

using LongPoint = std::array<long double, 3>;
using Polyline = std::vector<Point>;

/// A curve of output port 2 in space and in the plane, and its length according to the filter.
struct Curve
{
  Polyline Space;
  Polyline Flat;
  double Length = 0.0;
};

std::map<std::string, Curve> curvesOf(vtkPolyData* data)
{
  std::map<std::string, Curve> curves;
  vtkDataArray* space = data->GetPointData()->GetArray("SurfacePoints");
  vtkAbstractArray* names = data->GetCellData()->GetAbstractArray("Measure");
  vtkNew<vtkIdList> line;
  for (vtkIdType c = 0; c < data->GetLines()->GetNumberOfCells(); ++c)
  {
    data->GetLines()->GetCellAtId(c, line);
    Curve& curve = curves[names->GetVariantValue(c).ToString()];
    curve.Length = data->GetCellData()->GetArray("Length")->GetTuple1(c);
    for (vtkIdType i = 0; i < line->GetNumberOfIds(); ++i)
    {
      Point flat;
      Point place;
      data->GetPoint(line->GetId(i), flat.data());
      space->GetTuple(line->GetId(i), place.data());
      curve.Flat.push_back(flat);
      curve.Space.push_back(place);
    }
  }
  return curves;
}

long double lengthOf(const Polyline& line)
{
  long double length = 0.0L;
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    length += distanceBetween(line[i - 1], line[i]);
  }
  return length;
}

// Whether each point of a curve lies on one face of the region, in space as well as in the plane.
void checkPlaces(const Region& region, const Curve& curve, Findings& findings)
{
  const long double spaceRounding = 1e-14L * greatestCoordinate(region.Space);
  const long double flatRounding = 1e-14L * greatestCoordinate(region.Flat);
  for (std::size_t p = 0; p < curve.Flat.size(); ++p)
  {
    bool found = false;
    for (std::size_t f = 0; f < region.Flat.Faces.size() && !found; ++f)
    {
      found = region.InRegion[f] &&
              distanceTo(region.Flat, region.Flat.Faces[f], curve.Flat[p]) <= flatRounding &&
              distanceTo(region.Space, region.Space.Faces[f], curve.Space[p]) <= spaceRounding;
    }
    findings.require(found, "region-curves", "a point of a curve on no face of the region");
  }
}

// The points of a closed curve, whose last point is its first, after waves of up to four edges were
// smoothed away: the method of Taubin (1995), with the factors and the number of steps of the filter.
std::vector<LongPoint> smoothed(const Polyline& outline)
{
  std::vector<LongPoint> points;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i)
  {
    points.push_back({ outline[i][0], outline[i][1], outline[i][2] });
  }
  const std::size_t count = points.size();
  for (int step = 0; step < 24; ++step)
  {
    const long double factor = step % 2 == 0 ? 0.5L : -0.53L;
    const std::vector<LongPoint> before = points;
    for (std::size_t i = 0; i < count; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        const long double middle =
          0.5L * (before[(i + count - 1) % count][k] + before[(i + 1) % count][k]);
        points[i][k] += factor * (middle - points[i][k]);
      }
    }
  }
  return points;
}

// The length of a closed curve whose last point is not its first.
long double closedLength(const std::vector<LongPoint>& points)
{
  long double length = 0.0L;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const LongPoint& a = points[i];
    const LongPoint& b = points[(i + 1) % points.size()];
    length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  return length;
}

// The length of a geodesic in one shape, up to where its ends meet the smoothed outline.
// @param corners the places of its two ends in the outline; -1 for an end that is not there.
Measure lengthToOutline(const Polyline& line,
  const std::array<std::ptrdiff_t, 2>& corners,
  const Polyline& outline,
  const std::vector<LongPoint>& smooth,
  long double coordinate)
{
  Measure length{ lengthOf(line), 0.0L };
  length.Rounding = SumRounding * length.Value + 1e-12L * coordinate;
  for (const int end : { 0, 1 })
  {
    const Point& last = end == 0 ? line.front() : line.back();
    const Point& next = end == 0 ? line[1] : line[line.size() - 2];
    const long double step = distanceBetween(last, next);
    if (corners[end] < 0 || step == 0.0L)
    {
      continue;
    }
    long double displacement = 0.0L;
    for (int k = 0; k < 3; ++k)
    {
      const long double moved =
        static_cast<long double>(outline[corners[end]][k]) - smooth[corners[end]][k];
      length.Value -= moved * ((static_cast<long double>(last[k]) - next[k]) / step);
      displacement += std::abs(moved);
    }
    length.Rounding += displacement * std::min(2.0L, 1e-14L * coordinate / step);
  }
  length.Value = std::max(length.Value, 0.0L);
  return length;
}

// Whether a geodesic is no longer than the way between its ends along edges.
void checkShortest(const Triangles& part,
  const Triangles& flat,
  const Curve& curve,
  bool isDiameter,
  Findings& findings)
{
  std::vector<vtkIdType> from;
  for (std::size_t p = 0; p < part.Points.size(); ++p)
  {
    if (part.Points[p] == curve.Space.front() && flat.Points[p] == curve.Flat.front())
    {
      from.push_back(static_cast<vtkIdType>(p));
    }
  }
  const std::vector<long double> distance = distancesFrom(part, from);
  long double longest = -1.0L;
  for (std::size_t p = 0; p < part.Points.size(); ++p)
  {
    if (part.Points[p] == curve.Space.back() && flat.Points[p] == curve.Flat.back() &&
        std::isfinite(distance[p]))
    {
      longest = std::max(longest, distance[p]);
    }
  }
  const long double length = lengthOf(curve.Space);
  findings.require(
    longest < 0.0L || length <= (1.0L + 1e-6L) * longest + 1e-12L * greatestCoordinate(part),
    "region-curves",
    std::string(isDiameter ? "the diameter" : "the extent across") + " is " +
      std::to_string(static_cast<double>(length / longest)) +
      " as long as the way between its ends along edges");
}

// Whether the greatest diameter is not much shorter than the straight line between any two points of the
// outline, each moved to the smoothed one.
void checkGreatest(double diameter, const Polyline& outline, Findings& findings)
{
  const std::vector<LongPoint> smooth = smoothed(outline);
  long double straight = 0.0L;
  for (std::size_t i = 0; i < smooth.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      long double line = distanceBetween(outline[i], outline[j]);
      for (const std::size_t end : { i, j })
      {
        line -= std::hypot(outline[end][0] - smooth[end][0],
          outline[end][1] - smooth[end][1],
          outline[end][2] - smooth[end][2]);
      }
      straight = std::max(straight, line);
    }
  }
  findings.require(diameter >= LeastShare * straight,
    "region-diameter",
    "GreatestDiameter is " + std::to_string(static_cast<double>(diameter / straight)) +
      " of the straight line between two points of " + std::to_string(smooth.size()) +
      " on the boundary");
}

// Whether the outline is the boundary of the region.
void checkOutline(const Triangles& part, const Curve& outline, Findings& findings)
{
  const auto loops = boundaryLoops(part);
  std::vector<Point> boundary;
  for (const vtkIdType p : loops.empty() ? std::vector<vtkIdType>{} : loops.front())
  {
    boundary.push_back(part.Points[p]);
  }
  std::vector<Point> curve = outline.Space;
  findings.require(
    curve.front() == curve.back(), "region-curves", "the outline of the region is not closed");
  curve.pop_back();
  // The order of the points is judged by the length.
  checkMeasure("the outline",
    lengthOf(outline.Space),
    { lengthOf(boundary) +
        (boundary.empty() ? 0.0L : distanceBetween(boundary.back(), boundary.front())),
      SumRounding * lengthOf(outline.Space) },
    findings);
  std::sort(boundary.begin(), boundary.end());
  std::sort(curve.begin(), curve.end());
  findings.require(curve == boundary, "region-curves", "the outline is not the boundary of the region");
}

// Whether a geodesic has the length of its curve up to the smoothed outline.
void checkGeodesic(const Region& region,
  const std::string& name,
  const Curve& curve,
  const Curve& outline,
  double onMap,
  Findings& findings)
{
  std::array<std::ptrdiff_t, 2> corners = { -1, -1 };
  for (const int end : { 0, 1 })
  {
    for (std::size_t i = 0; i + 1 < outline.Space.size(); ++i)
    {
      const std::size_t p = end == 0 ? 0 : curve.Space.size() - 1;
      if (outline.Space[i] == curve.Space[p] && outline.Flat[i] == curve.Flat[p])
      {
        corners[end] = static_cast<std::ptrdiff_t>(i);
      }
    }
  }
  const auto length = [&](Polyline Curve::*shape, const Triangles& mesh)
  {
    return lengthToOutline(
      curve.*shape, corners, outline.*shape, smoothed(outline.*shape), greatestCoordinate(mesh));
  };
  checkMeasure("Length of " + name, curve.Length, length(&Curve::Space, region.Space), findings);
  checkMeasure("OnMap of " + name, onMap, length(&Curve::Flat, region.Flat), findings);
}

} // namespace

void checkCurves(const Region& region, vtkFlattenRegion* filter, Findings& findings)
{
  vtkPolyData* output = filter->GetOutput();
  const auto curves = curvesOf(filter->GetCurves());
  const auto find = [&](const char* name)
  {
    const auto found = curves.find(name);
    return found == curves.end() ? nullptr : &found->second;
  };
  const Curve* outline = find("Perimeter");
  if (!outline || outline->Space.size() < 4)
  {
    findings.fail("region-curves", "there is no outline");
    return;
  }
  const Triangles part = partOf(region.Space, region.InRegion);
  checkOutline(part, *outline, findings);
  checkPlaces(region, *outline, findings);
  const auto onMap = [&](int row)
  { return filter->GetMeasures()->GetValueByName(row, "OnMap").ToDouble(); };
  const auto perimeter = [](const Polyline& line, const Triangles& mesh)
  {
    const long double length = closedLength(smoothed(line));
    return Measure{ length,
      SumRounding * length + 1e-14L * greatestCoordinate(mesh) * static_cast<long double>(line.size()) };
  };
  checkMeasure(
    "Perimeter", figure(output, "Perimeter"), perimeter(outline->Space, region.Space), findings);
  checkMeasure("OnMap of Perimeter", onMap(3), perimeter(outline->Flat, region.Flat), findings);
  checkGreatest(figure(output, "GreatestDiameter"), outline->Space, findings);
  int row = 1;
  for (const char* name : { "GreatestDiameter", "ExtentAcross" })
  {
    if (const Curve* curve = find(name); curve && curve->Space.size() > 1)
    {
      checkPlaces(region, *curve, findings);
      checkGeodesic(region, name, *curve, *outline, onMap(row), findings);
      findings.require(curve->Length == figure(output, name),
        "region-curves",
        std::string("the curve has another Length than ") + name);
      checkShortest(part, region.Flat, *curve, row == 1, findings);
    }
    else
    {
      findings.require(figure(output, name) == 0.0, "region-curves", std::string("no curve ") + name);
    }
    findings.require(figure(output, name) >= 0.0, "region-figures", std::string(name) + " is negative");
    ++row;
  }
}

} // namespace fuzz
