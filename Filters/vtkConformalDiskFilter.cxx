// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkConformalDiskFilter.h"

#include "Core/Base/Errors.h"
#include "Core/Conformal/ConformalDisk.h"
#include "Core/Conformal/ConformalRectangle.h"
#include "Core/Mesh/CoordinateFrame.h"
#include "Core/Mesh/MeshMeasures.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Untangling/MapPlacement.h"
#include "Internal/FilterExecution.h"
#include "Internal/MapMeasures.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/TextureCoordinates.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkConformalDiskFilter);

namespace
{

// A surface that is to be mapped.
struct Disk
{
  flattening::TriangleMesh Surface; // in its frame
  flattening::Points3 Places;       // of its vertices, input units
  std::vector<int> Loop;            // the boundary
};

// The candidate that is nearest to a point in space, input units.
int nearestVertex(const Disk& disk, const std::vector<int>& candidates, const double point[3])
{
  const Eigen::RowVector3d target(point[0], point[1], point[2]);
  if (!target.allFinite())
  {
    throw flattening::InvalidInput(
      "a centre, boundary point or corner has a coordinate that is not finite: "
      "give a point of the surface");
  }
  int nearest = -1;
  double smallest = std::numeric_limits<double>::infinity();
  for (const int v : candidates)
  {
    const double distance = (0.25 * disk.Places.row(v) - 0.25 * target).stableNorm(); // never overflows
    if (distance < smallest)
    {
      smallest = distance;
      nearest = v;
    }
  }
  return nearest;
}

// The share of the points above which the moving apart of points is worth a warning: a convention, as
// the map is then visibly not conformal.
constexpr double SpreadShare = 0.01;

// The BoundaryAnisotropy below which the surface is taken for a strip, which a rectangle suits: a flat
// rectangle of 13 to 1 has 0.2. The boundary of half a brain is long as well, though the surface is not:
// it has 0.6.
constexpr double StripAnisotropy = 0.2;

// The methods in the order of vtkConformalDiskFilter::MethodType.
constexpr std::array<flattening::ConformalMethod, 3> Methods = { flattening::ConformalMethod::RicciFlow,
  flattening::ConformalMethod::BoundaryFirst,
  flattening::ConformalMethod::MeanValue };
constexpr std::array<const char*, 3> MethodNames = { "RicciFlow", "BoundaryFirst", "MeanValue" };

flattening::ConformalDiskOptions diskOptions(vtkConformalDiskFilter* filter, const Disk& disk)
{
  flattening::ConformalDiskOptions options;
  options.Method = Methods[filter->GetMethod()];
  options.Flow.Tolerance = filter->GetTolerance();
  if (filter->GetUseCenterPoint())
  {
    std::vector<int> all(disk.Surface.vertexCount());
    std::iota(all.begin(), all.end(), 0);
    options.CenterVertex = nearestVertex(disk, all, filter->GetCenterPoint());
  }
  if (filter->GetUseBoundaryPoint())
  {
    options.BoundaryVertex = nearestVertex(disk, disk.Loop, filter->GetBoundaryPoint());
  }
  return options;
}

// One flag per point: 1 on the seam that vtkSurfaceToDiskFilter marks.
std::vector<char> seamOf(vtkPolyData* input)
{
  std::vector<char> onSeam(input->GetNumberOfPoints(), 0);
  vtkDataArray* seam = input->GetPointData()->GetArray("Seam");
  for (vtkIdType i = 0; seam && i < input->GetNumberOfPoints(); ++i)
  {
    onSeam[i] = seam->GetComponent(i, 0) != 0.0 ? 1 : 0;
  }
  return onSeam;
}

flattening::ConformalRectangleOptions rectangleOptions(vtkConformalDiskFilter* filter,
  vtkPolyData* input,
  const Disk& disk)
{
  if (filter->GetMethod() != vtkConformalDiskFilter::RICCI_FLOW)
  {
    throw flattening::InvalidInput(
      "a rectangle is found by Ricci flow alone: set Method to Ricci Flow, or Domain to Disk");
  }
  flattening::ConformalRectangleOptions options;
  options.Flow.Tolerance = filter->GetTolerance();
  if (filter->GetUseCorners())
  {
    for (const double* corner : { filter->GetLowerLeftCorner(),
           filter->GetLowerRightCorner(),
           filter->GetUpperRightCorner(),
           filter->GetUpperLeftCorner() })
    {
      options.Corners.push_back(nearestVertex(disk, disk.Loop, corner));
    }
  }
  else
  {
    options.Corners = flattening::seamCorners(disk.Surface, disk.Loop, seamOf(input));
  }
  return options;
}

// A map with the area of its disk or rectangle.
struct DomainMap
{
  flattening::ConformalDiskMap Map;
  double Area = EIGEN_PI;   // of a rectangle of height 1 its conformal modulus
  std::vector<int> Corners; // of a rectangle
};

DomainMap diskMap(vtkConformalDiskFilter* filter, const Disk& disk)
{
  DomainMap result;
  result.Map = flattening::conformalDiskMap(
    disk.Surface, diskOptions(filter, disk), flattening::progressOf(filter));
  return result;
}

DomainMap rectangleMap(vtkConformalDiskFilter* filter, vtkPolyData* input, const Disk& disk)
{
  flattening::ConformalRectangleMap map = flattening::conformalRectangleMap(
    disk.Surface, rectangleOptions(filter, input, disk), flattening::progressOf(filter));
  return { std::move(map.Map), map.Modulus, map.Corners };
}

// @param logScale the logarithm of the size of the output over that of the map, less that of the surface
// over that of the mesh that was mapped.
void fillMap(vtkPolyData* output,
  vtkPolyData* input,
  const flattening::Points3& places,
  const flattening::Points2& positions,
  const flattening::ConformalDiskMap& map,
  double logScale)
{
  output->ShallowCopy(input);
  flattening::removeEarlierMeasures(output);
  output->SetPoints(vtk::TakeSmartPointer(flattening::newPlanarPoints(positions)));
  flattening::keepSurfaceTextureCoordinates(output);
  flattening::setTextureCoordinates(output, map.Positions);
  flattening::deactivateNormals(output);
  flattening::addSurfacePoints(output, places);
  flattening::addPointArray(output, "ConformalFactor", (map.LogFactors.array() + logScale).matrix());
}

// @param addedLength that of the map in input units.
void setReport(vtkFieldData* data,
  const flattening::ConformalDiskMap& map,
  double addedLength,
  int method)
{
  const auto count = [data](const char* name, long long value)
  { flattening::setDatum(data, name, value); };
  if (method == vtkConformalDiskFilter::RICCI_FLOW)
  {
    count("NewtonIterations", map.NewtonIterations);
    flattening::setDatum(data, "MaxCurvatureError", map.MaxCurvatureError);
    flattening::setDatum(data, "LayoutError", map.LayoutError);
  }
  if (method != vtkConformalDiskFilter::MEAN_VALUE)
  {
    count("SpreadPoints", map.SpreadVertices);
  }
  if (method == vtkConformalDiskFilter::BOUNDARY_FIRST)
  {
    count("BoundaryIterations", map.BoundaryIterations);
  }
  count("IntrinsicFlips", map.Flips);
  flattening::setDatum(data, "AddedLength", addedLength);
  count("RepairedFaces", map.Untangling.RepairedFaces);
  count("MovedPoints", map.Untangling.MovedVertices);
  flattening::setDatum(data, "GreatestMove", map.Untangling.GreatestMove);
  count("FlippedFaces", map.Untangling.FlippedFaces);
}

} // namespace

vtkConformalDiskFilter::vtkConformalDiskFilter() = default;

void vtkConformalDiskFilter::Execute(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const flattening::TriangleMesh surface = flattening::toTriangleMesh(input);
  const flattening::CoordinateFrame frame(surface);
  const flattening::TriangleMesh mesh = frame.normalised(surface);
  const Disk disk{ mesh, surface.Vertices, flattening::requireDisk(mesh) };
  const double area = flattening::faceAreas(mesh.Vertices, mesh.Faces).sum();
  DomainMap result = this->Domain == RECTANGLE ? rectangleMap(this, input, disk) : diskMap(this, disk);
  flattening::ConformalDiskMap& map = result.Map;
  const double scale =
    this->NormalizeTo == SURFACE_AREA ? frame.restoredLength(std::sqrt(area / result.Area)) : 1.0;
  const flattening::PlacedMap placed =
    flattening::placeMap(mesh, disk.Loop, map.Positions, { scale, Eigen::RowVector2d::Zero() });
  map.Untangling.FlippedFaces = placed.FlippedFaces;
  fillMap(output,
    input,
    disk.Places,
    placed.Positions,
    map,
    std::log(scale) - std::log(frame.restoredLength(1.0)));

  vtkFieldData* data = output->GetFieldData();
  flattening::removeEarlierReports(data);
  setReport(data, map, frame.restoredLength(map.AddedLength), this->Method);
  if (this->Domain == RECTANGLE)
  {
    flattening::setDatum(data, "Modulus", result.Area);
    flattening::setIds(data, "CornerPointIds", result.Corners);
  }
  const double length = flattening::loopLength(mesh.Vertices, disk.Loop);
  const double anisotropy = 4.0 * EIGEN_PI * area / (length * length);
  flattening::setDatum(data, "BoundaryAnisotropy", anisotropy);
  this->Warn(map.Untangling.FlippedFaces,
    this->Domain == DISK ? map.SpreadVertices : 0,
    mesh.vertexCount(),
    anisotropy);
}

void vtkConformalDiskFilter::Warn(int flippedFaces, int spreadPoints, int points, double anisotropy)
{
  const bool isSpread = spreadPoints > SpreadShare * points;
  if (flippedFaces > 0)
  {
    const char* remedy = "set Method to Ricci Flow, which moves apart what lies too close together";
    if (isSpread && anisotropy < StripAnisotropy)
    {
      remedy = "set Domain to Rectangle, as the surface is long and narrow";
    }
    else if (isSpread)
    {
      remedy = "smooth the surface more, or fill its narrow parts; OMT Area Preserving untangles most "
               "of these faces";
    }
    else if (this->Method == RICCI_FLOW)
    {
      remedy = "remesh the surface (Surface To Disk, Remesh)";
    }
    vtkWarningMacro(
      << this->GetBlockPrefix() << flippedFaces
      << " faces of the map are flipped and could not be untangled, so that it is not one-to-one there: "
      << remedy);
  }
  if (isSpread)
  {
    vtkWarningMacro(
      << this->GetBlockPrefix() << spreadPoints << " of " << points
      << " points lie in long narrow parts of the surface, which a conformal disk "
         "shrinks to less than 1e-5 of the rest: they were moved apart, and the map is not "
         "conformal there"
      << (anisotropy > 1.0
             ? ". A disk that keeps areas is stretched " + flattening::formatted(anisotropy) +
                 " to 1 along its boundary. If the surface is a tube, cut it open (Surface To Disk, "
                 "Cut: Seam) and set Domain to Rectangle"
             : std::string()));
  }
}

void vtkConformalDiskFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto printPoint = [&os, indent](const char* name, const double* x)
  { os << indent << name << ": (" << x[0] << ", " << x[1] << ", " << x[2] << ")\n"; };
  os << indent << "Method: " << MethodNames[this->Method] << "\n";
  os << indent << "Domain: " << (this->Domain == RECTANGLE ? "Rectangle" : "Disk") << "\n";
  os << indent << "UseCorners: " << this->UseCorners << "\n";
  printPoint("LowerLeftCorner", this->LowerLeftCorner);
  printPoint("LowerRightCorner", this->LowerRightCorner);
  printPoint("UpperRightCorner", this->UpperRightCorner);
  printPoint("UpperLeftCorner", this->UpperLeftCorner);
  os << indent << "NormalizeTo: " << (this->NormalizeTo == SURFACE_AREA ? "SurfaceArea" : "UnitDomain")
     << "\n";
  os << indent << "UseCenterPoint: " << this->UseCenterPoint << "\n";
  printPoint("CenterPoint", this->CenterPoint);
  os << indent << "UseBoundaryPoint: " << this->UseBoundaryPoint << "\n";
  printPoint("BoundaryPoint", this->BoundaryPoint);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
