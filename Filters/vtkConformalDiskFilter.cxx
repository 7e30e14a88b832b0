// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkConformalDiskFilter.h"

#include "Core/Base/Errors.h"
#include "Core/Conformal/ConformalDisk.h"
#include "Core/Conformal/ConformalRectangle.h"
#include "Core/Mesh/MeshTopology.h"
#include "Internal/FilterExecution.h"
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

int nearestVertex(const flattening::Points3& vertices,
  const std::vector<int>& candidates,
  const double point[3])
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
    const double distance = (vertices.row(v) - target).norm();
    if (distance < smallest)
    {
      smallest = distance;
      nearest = v;
    }
  }
  return nearest;
}

// Of the points: if more than these had to be moved apart, the map is conformal in part only.
constexpr double SpreadShare = 0.01;

double boundaryAnisotropy(const flattening::TriangleMesh& mesh, const std::vector<int>& loop)
{
  double length = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    length += (mesh.Vertices.row(loop[k]) - mesh.Vertices.row(loop[(k + 1) % loop.size()])).norm();
  }
  return 4.0 * EIGEN_PI * flattening::faceAreas(mesh.Vertices, mesh.Faces).sum() / (length * length);
}

// In the order of vtkConformalDiskFilter::MethodType.
constexpr std::array<flattening::ConformalMethod, 3> Methods = { flattening::ConformalMethod::RicciFlow,
  flattening::ConformalMethod::BoundaryFirst,
  flattening::ConformalMethod::MeanValue };
constexpr std::array<const char*, 3> MethodNames = { "RicciFlow", "BoundaryFirst", "MeanValue" };

flattening::ConformalDiskOptions diskOptions(vtkConformalDiskFilter* filter,
  const flattening::TriangleMesh& mesh,
  const std::vector<int>& loop)
{
  flattening::ConformalDiskOptions options;
  options.Method = Methods[filter->GetMethod()];
  options.Flow.Tolerance = filter->GetTolerance();
  if (filter->GetUseCenterPoint())
  {
    std::vector<int> all(mesh.vertexCount());
    std::iota(all.begin(), all.end(), 0);
    options.CenterVertex = nearestVertex(mesh.Vertices, all, filter->GetCenterPoint());
  }
  if (filter->GetUseBoundaryPoint())
  {
    options.BoundaryVertex = nearestVertex(mesh.Vertices, loop, filter->GetBoundaryPoint());
  }
  return options;
}

// Of the points that vtkSurfaceToDiskFilter marks.
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
  const flattening::TriangleMesh& mesh,
  const std::vector<int>& loop)
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
      options.Corners.push_back(nearestVertex(mesh.Vertices, loop, corner));
    }
  }
  else
  {
    options.Corners = flattening::seamCorners(mesh, loop, seamOf(input));
  }
  return options;
}

// Those of an earlier map that the input may bring, and that this one may not have.
void removeFigures(vtkFieldData* figures)
{
  for (const char* name : { "NewtonIterations",
         "MaxCurvatureError",
         "LayoutError",
         "SpreadPoints",
         "BoundaryIterations",
         "Modulus",
         "CornerPointIds" })
  {
    figures->RemoveArray(name);
  }
}

void setFigures(vtkFieldData* figures, const flattening::ConformalDiskMap& map, int method)
{
  const auto count = [figures](const char* name, int value)
  { flattening::setDatum(figures, name, static_cast<long long>(value)); };
  if (method == vtkConformalDiskFilter::RICCI_FLOW)
  {
    count("NewtonIterations", map.NewtonIterations);
    flattening::setDatum(figures, "MaxCurvatureError", map.MaxCurvatureError);
    flattening::setDatum(figures, "LayoutError", map.LayoutError);
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
  flattening::setDatum(figures, "AddedLength", map.AddedLength);
  count("RepairedFaces", map.Repair.RepairedFaces);
  count("MovedPoints", map.Repair.MovedVertices);
  flattening::setDatum(figures, "GreatestMove", map.Repair.GreatestMove);
  count("FlippedFaces", map.FlippedFaces);
}

} // namespace

vtkConformalDiskFilter::vtkConformalDiskFilter() = default;

void vtkConformalDiskFilter::Execute(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const flattening::TriangleMesh mesh = flattening::toTriangleMesh(input);
  const std::vector<int> loop = flattening::requireDisk(mesh);
  flattening::ConformalDiskMap map;
  double domainArea = EIGEN_PI;
  output->ShallowCopy(input);
  vtkFieldData* figures = output->GetFieldData();
  removeFigures(figures);
  if (this->Domain == RECTANGLE)
  {
    flattening::ConformalRectangleMap rectangle = flattening::conformalRectangleMap(
      mesh, rectangleOptions(this, input, mesh, loop), flattening::progressOf(this));
    map = std::move(rectangle.Map);
    domainArea = rectangle.Modulus;
    flattening::setDatum(figures, "Modulus", rectangle.Modulus);
    flattening::setIds(figures, "CornerPointIds", rectangle.Corners);
  }
  else
  {
    map =
      flattening::conformalDiskMap(mesh, diskOptions(this, mesh, loop), flattening::progressOf(this));
  }

  const double area = flattening::faceAreas(mesh.Vertices, mesh.Faces).sum();
  const double scale = this->NormalizeTo == SURFACE_AREA ? std::sqrt(area / domainArea) : 1.0;
  output->SetPoints(vtk::TakeSmartPointer(flattening::newPlanarPoints(scale * map.Positions)));
  flattening::keepSurfaceTextureCoordinates(output);
  flattening::setTextureCoordinates(output, map.Positions);
  flattening::deactivateNormals(output);
  flattening::addSurfacePoints(output, mesh.Vertices);
  flattening::addPointArray(
    output, "ConformalFactor", (map.LogFactors.array() + std::log(scale)).matrix());
  setFigures(figures, map, this->Method);
  if (map.FlippedFaces > 0)
  {
    vtkWarningMacro(
      << this->GetBlockPrefix() << map.FlippedFaces
      << " faces of the map are flipped and could not be turned over, so that it is not one-to-one "
         "there: "
      << (this->Method == RICCI_FLOW
             ? "remesh the surface (Surface To Disk, Remesh)"
             : "set Method to Ricci Flow, which moves apart what lies too close together"));
  }
  const double anisotropy = boundaryAnisotropy(mesh, loop);
  flattening::setDatum(figures, "BoundaryAnisotropy", anisotropy);
  if (this->Domain == DISK && map.SpreadVertices > SpreadShare * mesh.vertexCount())
  {
    vtkWarningMacro(<< this->GetBlockPrefix() << map.SpreadVertices << " of " << mesh.vertexCount()
                    << " points lie in long narrow parts of the surface, which a conformal disk "
                       "shrinks to less than "
                       "1e-5 of the rest: they were moved apart, and the map is not conformal "
                       "there. A disk that keeps "
                       "areas is stretched "
                    << anisotropy
                    << " to 1 along its boundary. If the surface is a tube, cut it "
                       "open (Surface To Disk, Cut: Seam) and set Domain to Rectangle");
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
