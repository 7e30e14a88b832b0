// SPDX-License-Identifier: GPL-3.0-or-later
#include "MapOracle.h"

#include "ExactOrientation.h"
#include "Triangles.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuzz
{
namespace
{

constexpr long double Pi = 3.14159265358979323846264L;

bool isFlat(const Triangles& map)
{
  return std::all_of(map.Points.begin(),
    map.Points.end(),
    [&](const Point& p)
    { return std::isfinite(p[0]) && std::isfinite(p[1]) && p[2] == map.Points.front()[2]; });
}

// The orientation of each face. Maps are counter-clockwise.
std::vector<int> orientations(const Triangles& map)
{
  std::vector<int> signs;
  for (const Triangle& face : map.Faces)
  {
    signs.push_back(orientation(map.Points[face[0]], map.Points[face[1]], map.Points[face[2]]));
  }
  return signs;
}

long double signedArea(const Triangles& map, const Triangle& face)
{
  const Point& a = map.Points[face[0]];
  const Point& b = map.Points[face[1]];
  const Point& c = map.Points[face[2]];
  return 0.5L * ((static_cast<long double>(b[0]) - a[0]) * (static_cast<long double>(c[1]) - a[1]) -
                  (static_cast<long double>(b[1]) - a[1]) * (static_cast<long double>(c[0]) - a[0]));
}

enum class Domain
{
  Disk,
  Rectangle,
  Polygon
};

Domain domainOf(vtkPolyData* map, vtkPolyData* polygon)
{
  return polygon                                           ? Domain::Polygon
         : map->GetFieldData()->HasArray("CornerPointIds") ? Domain::Rectangle
                                                           : Domain::Disk;
}

struct Box
{
  double Low[2] = { HUGE_VAL, HUGE_VAL };
  double High[2] = { -HUGE_VAL, -HUGE_VAL };
};

Box boxOf(const Triangles& map, const std::vector<vtkIdType>& loop)
{
  Box box;
  for (const vtkIdType p : loop)
  {
    for (int k = 0; k < 2; ++k)
    {
      box.Low[k] = std::min(box.Low[k], map.Points[p][k]);
      box.High[k] = std::max(box.High[k], map.Points[p][k]);
    }
  }
  return box;
}

// Whether each step along the boundary goes round the centre counter-clockwise, and all steps once.
bool goesRoundOnce(const Triangles& map,
  const std::vector<vtkIdType>& loop,
  const Point& centre,
  double size)
{
  double turn = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point& a = map.Points[loop[i]];
    const Point& b = map.Points[loop[(i + 1) % loop.size()]];
    const double x[2] = { (a[0] - centre[0]) / size, (b[0] - centre[0]) / size };
    const double y[2] = { (a[1] - centre[1]) / size, (b[1] - centre[1]) / size };
    const double step = std::atan2(x[0] * y[1] - y[0] * x[1], x[0] * x[1] + y[0] * y[1]);
    turn += orientation(centre, a, b) < 0 ? step + 2.0 * static_cast<double>(Pi) : step;
  }
  return std::abs(turn - 2.0 * static_cast<double>(Pi)) < 1e-6;
}

double radiusOf(const Triangles& map, const std::vector<vtkIdType>& loop)
{
  double radius = 0.0;
  for (const vtkIdType p : loop)
  {
    radius = std::max(radius, std::hypot(map.Points[p][0], map.Points[p][1]));
  }
  return radius;
}

// Whether the boundary goes once around the inside, on the outline of a disk or a rectangle.
void checkOutline(const Triangles& map,
  const std::vector<vtkIdType>& loop,
  Domain domain,
  Findings& findings)
{
  const Box box = boxOf(map, loop);
  const double size = std::max(box.High[0] - box.Low[0], box.High[1] - box.Low[1]);
  const Point middle = {
    0.5 * box.Low[0] + 0.5 * box.High[0], 0.5 * box.Low[1] + 0.5 * box.High[1], 0.0
  };
  const Point centre = domain == Domain::Disk ? Point{ 0.0, 0.0, 0.0 } : middle;
  findings.require(goesRoundOnce(map, loop, centre, size),
    "outline",
    "Bijective, but the boundary does not go round its centre once");
  const double radius = radiusOf(map, loop);
  for (const vtkIdType p : loop)
  {
    const Point& a = map.Points[p];
    const double away = domain == Domain::Disk
                          ? radius - std::hypot(a[0], a[1])
                          : std::min(std::min(a[0] - box.Low[0], box.High[0] - a[0]),
                              std::min(a[1] - box.Low[1], box.High[1] - a[1]));
    findings.require(
      std::abs(away) <= 1e-9 * size, "outline", "Bijective, but a boundary point is not on the outline");
  }
}

using Outline = std::vector<std::array<long double, 2>>;

long double outlineArea(const Outline& outline)
{
  const auto& from = outline.front();
  long double area = 0.0L;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i)
  {
    const auto& a = outline[i];
    const auto& b = outline[i + 1];
    area += 0.5L * ((a[0] - from[0]) * (b[1] - from[1]) - (a[1] - from[1]) * (b[0] - from[0]));
  }
  return area;
}

std::array<long double, 2> centroidOf(const Outline& outline)
{
  const auto& from = outline.front();
  const long double whole = outlineArea(outline);
  std::array<long double, 2> centroid = from;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i)
  {
    const long double share = outlineArea({ from, outline[i], outline[i + 1] }) / whole;
    for (int k = 0; k < 2; ++k)
    {
      centroid[k] += share * ((outline[i][k] - from[k]) + (outline[i + 1][k] - from[k])) / 3.0L;
    }
  }
  return centroid;
}

// The corners of the polygon, scaled about its centroid to an area, or as they are if that is 0.
Outline scaledOutline(vtkPolyData* polygon, long double toArea)
{
  Outline outline;
  for (vtkIdType p = 0; p < polygon->GetNumberOfPoints(); ++p)
  {
    const double* point = polygon->GetPoint(p);
    outline.push_back({ point[0], point[1] });
  }
  const auto centroid = centroidOf(outline);
  const long double area = std::abs(outlineArea(outline));
  const long double scale = toArea > 0.0L ? std::sqrt(toArea) / std::sqrt(area) : 1.0L;
  for (auto& corner : outline)
  {
    for (int k = 0; k < 2; ++k)
    {
      corner[k] = centroid[k] + scale * (corner[k] - centroid[k]);
    }
  }
  return outline;
}

long double distanceTo(const Outline& outline, const Point& point)
{
  long double least = std::numeric_limits<long double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const auto& a = outline[i];
    const auto& b = outline[(i + 1) % outline.size()];
    const long double side[2] = { b[0] - a[0], b[1] - a[1] };
    const long double length = std::hypot(side[0], side[1]);
    const long double from[2] = { point[0] - a[0], point[1] - a[1] };
    const long double along =
      length > 0.0L ? (from[0] * (side[0] / length) + from[1] * (side[1] / length)) / length : 0.0L;
    const long double t = std::clamp(along, 0.0L, 1.0L);
    least = std::min(least, std::hypot(from[0] - t * side[0], from[1] - t * side[1]));
  }
  return least;
}

// Whether the boundary goes once around the centroid of the polygon, on its outline.
void checkPolygonOutline(const Triangles& map,
  const std::vector<vtkIdType>& loop,
  vtkPolyData* polygon,
  long double area,
  Findings& findings)
{
  const Outline outline = scaledOutline(polygon, area);
  const auto centroid = centroidOf(outline);
  const Box box = boxOf(map, loop);
  const double size = std::max(box.High[0] - box.Low[0], box.High[1] - box.Low[1]);
  findings.require(
    goesRoundOnce(
      map, loop, { static_cast<double>(centroid[0]), static_cast<double>(centroid[1]), 0.0 }, size),
    "outline",
    "Bijective, but the boundary does not go round the centroid of the polygon once");
  double bounds[6];
  polygon->GetBounds(bounds);
  const double away = std::max(
    { -bounds[0], bounds[1], -bounds[2], bounds[3], std::abs(box.High[0]), std::abs(box.High[1]) });
  long double farthest = 0.0L;
  for (const vtkIdType p : loop)
  {
    farthest = std::max(farthest, distanceTo(outline, map.Points[p]));
  }
  // The filter leaves out points that lie on a side to 1e-9 of the width, and rounds its positions.
  findings.require(farthest <= 1e-8L * size + 4e-15L * away,
    "outline",
    "a boundary point is off the outline of the polygon by " +
      std::to_string(static_cast<double>(farthest / size)) + " of its size");
}

bool areApart(const Point& a, const Point& b, const Point& c, const Point& d, int axis)
{
  return std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
         std::max(c[axis], d[axis]) < std::min(a[axis], b[axis]);
}

// Whether two segments without a common end meet.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return !areApart(a, b, c, d, 0) && !areApart(a, b, c, d, 1) &&
         orientation(a, b, c) * orientation(a, b, d) <= 0 &&
         orientation(c, d, a) * orientation(c, d, b) <= 0;
}

// Whether no two edges of a free outline meet, each pair by itself.
void checkFreeOutline(const Triangles& map, const std::vector<vtkIdType>& loop, Findings& findings)
{
  const std::size_t count = loop.size();
  const auto at = [&](std::size_t i) -> const Point& { return map.Points[loop[i % count]]; };
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = i + 2; j < count && j + 1 < i + count; ++j)
    {
      if (meet(at(i), at(i + 1), at(j), at(j + 1)))
      {
        findings.fail("outline", "Bijective, but the free outline crosses itself");
        return;
      }
    }
  }
}

void checkDomainArea(const Triangles& map,
  const std::vector<vtkIdType>& loop,
  Domain domain,
  long double surfaceArea,
  Findings& findings)
{
  const Box box = boxOf(map, loop);
  const long double radius = radiusOf(map, loop);
  const long double area = domain == Domain::Disk
                             ? Pi * radius * radius
                             : (static_cast<long double>(box.High[0]) - box.Low[0]) *
                                 (static_cast<long double>(box.High[1]) - box.Low[1]);
  findings.require(std::abs(area - surfaceArea) <= 1e-8L * surfaceArea,
    "domain-area",
    "the domain has " + std::to_string(static_cast<double>(area / surfaceArea)) + " of the area");
}

} // namespace

void checkMap(vtkPolyData* data, bool hasSurfaceArea, Findings& findings, vtkPolyData* polygon)
{
  const Triangles map = trianglesOf(data);
  const Triangles surface = trianglesOf(data, "SurfacePoints");
  if (!isFlat(map))
  {
    findings.fail("not-finite", "a map with points that are not finite or not flat");
    return;
  }
  const std::vector<int> signs = orientations(map);
  const auto flipped = std::count_if(signs.begin(), signs.end(), [](int sign) { return sign <= 0; });
  const double reported = figure(data, "FlippedFaces");
  findings.require(reported == static_cast<double>(flipped),
    "flipped-faces",
    "FlippedFaces is " + std::to_string(static_cast<long long>(reported)) + ", the exact count " +
      std::to_string(flipped));
  const bool isTransported = data->GetFieldData()->HasArray("Bijective") != 0;
  const bool isFree = isTransported && figure(data, "FreeOutline") == 1.0;
  const Domain domain = domainOf(data, polygon);
  const long double area = totalArea(surface);
  const auto loops = boundaryLoops(map);
  if (loops.size() != 1)
  {
    findings.fail("disk-topology", "a map with several boundaries");
    return;
  }
  const std::vector<vtkIdType>& loop = loops.front();
  if (isTransported && figure(data, "Bijective") == 1.0)
  {
    findings.require(
      flipped == 0, "bijective", "Bijective, but " + std::to_string(flipped) + " faces are flipped");
    isFree    ? checkFreeOutline(map, loop, findings)
    : polygon ? checkPolygonOutline(map, loop, polygon, hasSurfaceArea ? area : 0.0L, findings)
              : checkOutline(map, loop, domain, findings);
  }
  if (hasSurfaceArea && area > 0.0L && isFree)
  {
    const long double covered = totalArea(map);
    findings.require(std::abs(covered - area) <= 1e-8L * area,
      "domain-area",
      "the map has " + std::to_string(static_cast<double>(covered / area)) + " of the area");
  }
  else if (hasSurfaceArea && area > 0.0L && domain != Domain::Polygon)
  {
    checkDomainArea(map, loop, domain, area, findings);
  }
}

void checkDistortion(vtkPolyData* data, bool hasTargets, Findings& findings)
{
  const Triangles map = trianglesOf(data);
  const Triangles surface = trianglesOf(data, "SurfacePoints");
  const std::vector<int> signs = orientations(map);
  const auto flipped = std::count_if(signs.begin(), signs.end(), [](int sign) { return sign <= 0; });
  findings.require(figure(data, "FlippedFaces") == static_cast<double>(flipped),
    "flipped-faces",
    "Distortion Metrics says " + std::to_string(static_cast<int>(figure(data, "FlippedFaces"))) +
      " flipped, the exact count is " + std::to_string(flipped));
  if (hasTargets)
  {
    return;
  }
  vtkDataArray* distortion = data->GetCellData()->GetArray("AreaDistortion");
  vtkDataArray* degenerate = data->GetCellData()->GetArray("Degenerate");
  long double flatTotal = 0.0L;
  for (const Triangle& face : map.Faces)
  {
    flatTotal += signedArea(map, face);
  }
  flatTotal = std::abs(flatTotal);
  const long double total = totalArea(surface);
  for (std::size_t f = 0; f < map.Faces.size(); ++f)
  {
    const long double area = areaOf(surface, surface.Faces[f]);
    const long double flat = std::abs(signedArea(map, map.Faces[f]));
    if (degenerate->GetTuple1(f) != 0.0 || area == 0.0L || flat == 0.0L)
    {
      continue;
    }
    // The rounding of the coordinates' differences, which a needle magnifies.
    const long double rounding = 1e-13L * (greatestSquaredSide(surface, surface.Faces[f]) / area +
                                            greatestSquaredSide(map, map.Faces[f]) / flat);
    const auto expected = std::log((area / total) / (flat / flatTotal));
    findings.require(std::abs(distortion->GetTuple1(f) - expected) <= 1e-6L + rounding,
      "area-distortion",
      "face " + std::to_string(f) + ": " + std::to_string(distortion->GetTuple1(f)) + " instead of " +
        std::to_string(static_cast<double>(expected)));
  }
}

} // namespace fuzz
