// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/RegionReport.h"

#include "Core/Base/Errors.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/ReportRows.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>
#include <vector>

namespace flattening
{
namespace
{

// Pieces with more than this share of the area of the region are no noise. A convention, the same as
// that of Surface To Disk.
constexpr double SmallestPieceLeftOut = 1e-3;

struct NamedCurve
{
  const char* Name;
  const SurfaceCurve* Curve;
};

// The curves with the names of their measures.
std::vector<NamedCurve> curvesOf(const RegionReport& measures)
{
  return { { "GreatestDiameter", &measures.Extent.Diameter },
    { "ExtentAcross", &measures.Extent.Across },
    { "Perimeter", &measures.Extent.Outline } };
}

// Replaces the vertices of the region by those of the disk that it is a part of.
void renumber(SurfaceCurve& curve, const VertexOrigins& origins)
{
  const auto original = [&origins](int v)
  { return static_cast<int>(VertexOrigins::InnerIterator(origins, v).col()); };
  for (EdgePoint& point : curve.Points)
  {
    point.From = original(point.From);
    point.To = original(point.To);
  }
}

template <typename Positions>
auto positionOn(const Positions& positions, const EdgePoint& point)
{
  return ((1.0 - point.Fraction) * positions.row(point.From) + point.Fraction * positions.row(point.To))
    .eval();
}

// The vertices of a closed outline.
std::vector<int> loopOf(const SurfaceCurve& outline)
{
  std::vector<int> loop;
  for (std::size_t i = 0; i + 1 < outline.Points.size(); ++i)
  {
    loop.push_back(outline.Points[i].From);
  }
  return loop;
}

} // namespace

RegionReport measureRegion(const RegionDisk& region,
  const Points2& positions,
  const ProgressCallback& progress)
{
  std::vector<int> faces;
  for (std::size_t f = 0; f < region.InRegion.size(); ++f)
  {
    if (region.InRegion[f])
    {
      faces.push_back(static_cast<int>(f));
    }
  }
  const TriangleMesh& disk = region.Disk.Mesh;
  RegionReport measures;
  measures.Area = faceAreas(disk.Vertices, disk.Faces)(faces).sum();
  measures.FlatArea = signedFaceAreas(positions, disk.Faces)(faces).sum();
  const DerivedMesh part = extractFaces(disk, faces);
  measures.Extent = regionExtent(part.Mesh, progress);
  for (SurfaceCurve* curve :
    { &measures.Extent.Diameter, &measures.Extent.Across, &measures.Extent.Outline })
  {
    renumber(*curve, part.Vertices);
  }
  // The boundary is taken as uniformly distributed over the length of an edge, independently at each
  // edge.
  const double edge = measures.Extent.EdgeLength;
  const double edges = measures.Extent.Outline.Length / edge;
  measures.AreaError = edge * edge * std::sqrt(edges / 12.0);
  measures.LengthError = edge * std::sqrt(2.0 / 12.0);
  Points3 flat = Points3::Zero(positions.rows(), 3);
  flat.leftCols(2) = positions;
  const std::vector<int> loop = loopOf(measures.Extent.Outline);
  measures.FlatDiameter = trimmedLength(flat, measures.Extent.Diameter, loop);
  measures.FlatAcross = trimmedLength(flat, measures.Extent.Across, loop);
  measures.FlatPerimeter = smoothedPerimeter(flat, loop);
  return measures;
}

void fillMeasures(vtkTable* table,
  const RegionReport& measures,
  const std::string& unit,
  vtkFieldData* data)
{
  vtkNew<vtkStringArray> names;
  names->SetName("Measure");
  vtkNew<vtkDoubleArray> onSurface;
  onSurface->SetName("OnSurface");
  vtkNew<vtkDoubleArray> onMap;
  onMap->SetName("OnMap");
  vtkNew<vtkDoubleArray> errors;
  errors->SetName("StandardDeviation");
  vtkNew<vtkStringArray> units;
  units->SetName("Unit");
  const auto add =
    [&](const char* name, double value, double error, double flat, const std::string& itsUnit)
  {
    names->InsertNextValue(name);
    onSurface->InsertNextValue(value);
    onMap->InsertNextValue(flat);
    errors->InsertNextValue(error);
    units->InsertNextValue(itsUnit);
    setDatum(data, name, value);
  };
  const RegionExtent& extent = measures.Extent;
  add("Area", measures.Area, measures.AreaError, measures.FlatArea, unit.empty() ? "" : unit + "^2");
  add("GreatestDiameter", extent.Diameter.Length, measures.LengthError, measures.FlatDiameter, unit);
  add("ExtentAcross", extent.Across.Length, measures.LengthError, measures.FlatAcross, unit);
  add("Perimeter", extent.Perimeter, extent.PerimeterError, measures.FlatPerimeter, unit);
  setDatum(data, "FlatArea", measures.FlatArea);
  for (vtkAbstractArray* column : std::initializer_list<vtkAbstractArray*>{
         names.Get(), onSurface.Get(), errors.Get(), onMap.Get(), units.Get() })
  {
    table->AddColumn(column);
  }
}

void fillCurves(vtkPolyData* output,
  const RegionReport& measures,
  const TriangleMesh& disk,
  const Points2& positions)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> surface;
  surface->SetName(SurfacePointsName);
  surface->SetNumberOfComponents(3);
  vtkNew<vtkStringArray> names;
  names->SetName("Measure");
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("Length");
  for (const auto& [name, curve] : curvesOf(measures))
  {
    if (curve->Points.empty())
    {
      continue;
    }
    lines->InsertNextCell(static_cast<int>(curve->Points.size()));
    for (const EdgePoint& point : curve->Points)
    {
      const Eigen::RowVector2d flat = positionOn(positions, point);
      const Eigen::RowVector3d space = positionOn(disk.Vertices, point);
      lines->InsertCellPoint(points->InsertNextPoint(flat[0], flat[1], 0.0));
      surface->InsertNextTuple(space.data());
    }
    names->InsertNextValue(name);
    lengths->InsertNextValue(curve->Length);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(surface);
  output->GetCellData()->AddArray(names);
  output->GetCellData()->AddArray(lengths);
}

std::string leftOutWarning(const RegionDisk& region, const RegionReport& measures)
{
  if (region.DroppedArea <= SmallestPieceLeftOut * measures.Area)
  {
    return {};
  }
  const long long others = region.Pieces - 1;
  return "the region is not connected: " + counted(others, "piece") + " with an area of " +
         formatted(region.DroppedArea) + (others == 1 ? " was" : " were") +
         " left out, beside the largest with " + formatted(measures.Area) +
         ". To flatten another, select it alone";
}

} // namespace flattening
