// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkOMTAreaPreservingFilter.h"

#include "Core/Areas/AreaPreservingDisk.h"
#include "Core/Conformal/ConformalDisk.h"
#include "Core/FlatMap/FlatMapLocation.h"
#include "Core/Mesh/CoordinateFrame.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/OutlineCrossings.h"
#include "Core/Transport/DomainPolygon.h"
#include "Core/Untangling/MapPlacement.h"
#include "Internal/ArrayConversion.h"
#include "Internal/ChosenArray.h"
#include "Internal/FilterExecution.h"
#include "Internal/FlatDomain.h"
#include "Internal/MapMeasures.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/TextureCoordinates.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkOMTAreaPreservingFilter);

namespace
{

using flattening::Placement;

constexpr const char* DefaultWeights = "AreaWeight";
constexpr const char* FlatPoints = "FlatPoints";

// The surface, its conformal map, and the domain to map it to.
struct TransportInput
{
  bool IsInSpace = false;           // whether the points of the input are those of the surface
  flattening::TriangleMesh Surface; // in its frame
  flattening::CoordinateFrame Frame;
  std::vector<int> Loop;                            // the boundary
  flattening::Points2 Conformal;                    // n x 2, over a domain of area pi around the origin
  flattening::FlatDomain Domain;                    // of the conformal map
  std::optional<flattening::DomainPolygon> Polygon; // to map to instead, if there is one
};

void setSurface(const flattening::TriangleMesh& surface, TransportInput& input)
{
  input.Frame = flattening::CoordinateFrame(surface);
  input.Surface = input.Frame.normalised(surface);
  input.Loop = flattening::requireDisk(input.Surface);
}

TransportInput conformalInput(vtkPolyData* map)
{
  TransportInput input;
  setSurface(flattening::surfaceOfFlattened(map), input);
  const flattening::Points2 positions = flattening::toPlanarPositions(map);
  const flattening::Points2 flat = flattening::PlaneFrame(positions).normalised(positions);
  input.Domain = flattening::flatDomain(flat, input.Loop);
  input.Conformal = (flat.rowwise() - input.Domain.Centre) / input.Domain.Scale;
  return input;
}

// A disk in space. A map with a free outline takes little more from a conformal map than its rotation,
// so that a map by mean values serves, which is found in a fraction of the time.
TransportInput inputInSpace(vtkPolyData* disk, const flattening::ProgressCallback& progress)
{
  TransportInput input;
  input.IsInSpace = true;
  setSurface(flattening::toTriangleMesh(disk), input);
  flattening::ConformalDiskOptions options;
  options.Method = flattening::ConformalMethod::MeanValue;
  input.Conformal = flattening::conformalDiskMap(input.Surface, options, progress).Positions;
  return input;
}

TransportInput readInput(vtkPolyData* data,
  vtkPolyData* polygon,
  bool hasFreeOutline,
  const flattening::ProgressCallback& progress)
{
  const bool isFlat = data->GetPointData()->HasArray(flattening::SurfacePointsName);
  if (!isFlat && !hasFreeOutline)
  {
    throw flattening::InvalidInput(
      "the input has no point array SurfacePoints, so it is not a flattened surface: run Conformal Disk "
      "first, or turn FreeOutline on");
  }
  TransportInput input = isFlat ? conformalInput(data) : inputInSpace(data, progress);
  if (polygon)
  {
    input.Polygon = flattening::domainPolygon(flattening::polygonOutline(polygon));
  }
  return input;
}

// The weights of the points (n); empty if all are 1. @p choice is the input array to process, and
// @p inUse tells which they are.
Eigen::VectorXd readWeights(vtkPolyData* input, vtkInformation* choice, std::string& inUse)
{
  const char* chosen = choice->Get(vtkDataObject::FIELD_NAME());
  const bool isNamed = chosen && *chosen && std::string(chosen) != "None";
  const bool isAttribute = !isNamed && choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  std::string name = isNamed ? chosen : DefaultWeights;
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (isAttribute)
  {
    array = flattening::chosenAttribute(input->GetPointData(), choice);
    name = array ? flattening::nameOf(array) : "that is the chosen attribute";
  }
  if (!array && !isNamed && !isAttribute)
  {
    return {};
  }
  if (!array)
  {
    throw flattening::InvalidInput("the input has no point array " + name +
                                   " for the area weights: add it with Area Weights, choose another "
                                   "array or turn UseAreaWeight off");
  }
  if (array->GetNumberOfComponents() != 1)
  {
    throw flattening::InvalidInput("the area weights " + name + " have " +
                                   std::to_string(array->GetNumberOfComponents()) +
                                   " components, not 1: choose another array or turn UseAreaWeight off");
  }
  double range[2];
  array->GetRange(range);
  inUse = name + ", " + flattening::formatted(range[0]) + " to " + flattening::formatted(range[1]);
  return flattening::toMatrix<1>(array);
}

// The power weights of an earlier run, for a domain of area pi; empty if the input has none.
Eigen::VectorXd startWeights(vtkPolyData* input, const Placement& placement)
{
  vtkDataArray* array = input->GetPointData()->GetArray("PowerWeight");
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return {};
  }
  const Eigen::VectorXd weights = flattening::toMatrix<1>(array) / placement.Scale / placement.Scale;
  return weights.allFinite() ? weights : Eigen::VectorXd();
}

// The points of an earlier run, in a domain of area pi; empty if the input has none.
flattening::Points2 startPositions(vtkPolyData* input, const Placement& placement)
{
  vtkDataArray* array = input->GetPointData()->GetArray(FlatPoints);
  if (!array || array->GetNumberOfComponents() != 3)
  {
    return {};
  }
  return (flattening::toMatrix<3>(array).leftCols<2>().rowwise() - placement.Centre) / placement.Scale;
}

// Places a disk around the origin, a rectangle with its lower left corner there, and a polygon where it
// was given.
Placement placementOf(const TransportInput& input, bool isUnit)
{
  const flattening::FlatDomain& domain = input.Domain;
  const double area = flattening::faceAreas(input.Surface.Vertices, input.Surface.Faces).sum();
  Placement placement;
  placement.Scale = !isUnit              ? input.Frame.restoredLength(std::sqrt(area / EIGEN_PI))
                    : input.Polygon      ? input.Polygon->Scale
                    : domain.IsRectangle ? domain.Scale / domain.Height
                                         : 1.0;
  if (input.Polygon)
  {
    placement.Centre = input.Polygon->Centroid.transpose();
    if (!isUnit) // at its own size, domainPolygon() found it to be large enough
    {
      flattening::requireResolved(*input.Polygon, placement.Scale);
    }
  }
  else if (domain.IsRectangle)
  {
    placement.Centre =
      0.5 * placement.Scale / domain.Scale * Eigen::RowVector2d(domain.Width, domain.Height);
  }
  return placement;
}

flattening::AreaPreservingResult areaPreservingMap(const TransportInput& input,
  bool fixCorners,
  const Eigen::VectorXd& weights,
  const flattening::AreaPreservingOptions& options,
  const flattening::ProgressCallback& progress)
{
  const flattening::FlatDomain& domain = input.Domain;
  if (input.Polygon)
  {
    return flattening::areaPreservingPolygonMap(input.Surface,
      input.Conformal,
      *domain.normalised(),
      { input.Polygon->Corners, fixCorners },
      weights,
      options,
      progress);
  }
  if (domain.IsRectangle)
  {
    return flattening::areaPreservingRectangleMap(
      input.Surface, input.Conformal, domain.Width / domain.Scale, weights, options, progress);
  }
  return flattening::areaPreservingDiskMap(input.Surface, input.Conformal, weights, options, progress);
}

// Areas of the output. They are infinite or 0, but never NaN, where double precision does not hold them.
Eigen::VectorXd placedAreas(const Eigen::VectorXd& areas, const Placement& placement)
{
  return placement.Scale * (placement.Scale * areas);
}

// For a disk in space, as Conformal Disk does for its input: keeps its points and texture coordinates,
// and drops the reports on an earlier map.
void keepSurface(vtkPolyData* output)
{
  flattening::keepSurfaceTextureCoordinates(output);
  flattening::addSurfacePoints(output, flattening::pointsOf(output));
  flattening::removeEarlierReports(output->GetFieldData());
}

void fillMap(vtkPolyData* output,
  vtkPolyData* input,
  bool isInSpace,
  const flattening::AreaPreservingMap& map,
  const flattening::Points2& positions,
  const Placement& placement)
{
  output->ShallowCopy(input);
  flattening::removeEarlierMeasures(output);
  if (isInSpace)
  {
    keepSurface(output);
  }
  output->SetPoints(vtk::TakeSmartPointer(flattening::newPlanarPoints(positions)));
  flattening::deactivateNormals(output);
  flattening::setTextureCoordinates(output, map.Positions);
  flattening::addPointArray(output, "TargetArea", placedAreas(map.TargetAreas, placement));
  flattening::addPointArray(output, "CellArea", placedAreas(map.CellAreas, placement));
  flattening::addPointArray(output, "PowerWeight", placedAreas(map.PowerWeights, placement));
  output->GetPointData()->AddArray(
    flattening::newTuples<vtkDoubleArray>(FlatPoints, flattening::planarMesh(positions, {}).Vertices));
}

void fillPowerDiagram(vtkPolyData* output,
  const flattening::AreaPreservingResult& result,
  const flattening::FaceMatrix& faces,
  const Placement& placement)
{
  const auto& [scale, centre] = placement;
  // A map with a free outline carries the points of the domain along.
  std::optional<flattening::FlatMapLocation> freed;
  if (result.Map.IsFree)
  {
    freed.emplace(flattening::planarMesh(result.Map.Positions, faces), result.Map.OnDomain);
  }
  int lastFace = 0;
  constexpr double oneDegree = EIGEN_PI / 180.0;
  const flattening::PowerDiagram& diagram = result.Diagram;
  std::vector<vtkIdType> pointOfSite(diagram.siteCount(), -1);
  Eigen::VectorXd targets = Eigen::VectorXd::Zero(diagram.siteCount());
  for (std::size_t v = 0; v < result.SiteOfVertex.size(); ++v)
  {
    const int site = result.SiteOfVertex[v];
    pointOfSite[site] = pointOfSite[site] < 0 ? static_cast<vtkIdType>(v) : pointOfSite[site];
    targets[site] += result.Map.TargetAreas[v];
  }

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  for (int site = 0; site < diagram.siteCount(); ++site)
  {
    const std::vector<Eigen::Vector2d> outline = diagram.outline(site, oneDegree);
    polygons->InsertNextCell(static_cast<int>(outline.size()));
    for (Eigen::Vector2d corner : outline)
    {
      if (freed)
      {
        const flattening::MapPlace place = freed->onMap(corner.transpose(), lastFace);
        lastFace = place.Face;
        corner = freed->surfacePoint(place).head<2>().transpose();
      }
      polygons->InsertCellPoint(
        points->InsertNextPoint(centre.x() + scale * corner.x(), centre.y() + scale * corner.y(), 0.0));
    }
  }
  output->SetPoints(points);
  output->SetPolys(polygons);
  vtkCellData* data = output->GetCellData();
  data->AddArray(flattening::newArray<vtkIdTypeArray>("SiteId", pointOfSite));
  data->AddArray(
    flattening::newArray<vtkDoubleArray>("CellArea", placedAreas(diagram.areas(), placement)));
  data->AddArray(flattening::newArray<vtkDoubleArray>("TargetArea", placedAreas(targets, placement)));
}

void setReport(vtkFieldData* data, const flattening::AreaPreservingMap& map)
{
  const auto count = [data](const char* name, int value)
  { flattening::setDatum(data, name, static_cast<long long>(value)); };
  data->RemoveArray("CornerPointIds"); // those of the conformal map
  if (!map.CornerVertices.empty() && !map.IsFree)
  {
    flattening::setIds(data, "CornerPointIds", map.CornerVertices);
  }
  count("NewtonIterations", map.NewtonIterations);
  count("Sites", map.Sites);
  count("PowerDiagrams", map.PowerDiagrams);
  flattening::setDatum(data, "MaxCellAreaError", map.MaxCellError);
  count("CoincidentPoints", map.CoincidentVertices);
  count("FlippedFaces", map.FlippedFaces);
  count("Bijective", map.Bijective ? 1 : 0);
  count("WarmStart", map.WarmStarted ? 1 : 0);
  count("RefinementRounds", map.RefinementRounds);
  count("RefinementRepairs", map.RepairedFaces);
  count("FreeOutline", map.IsFree ? 1 : 0);
}

// The share of the progress of the map by mean values.
constexpr double ReadingShare = 0.1;

// Share of the domain's area that the outline of the map may cut off without a warning: half of the 2
// percent by which faces count as right.
constexpr double LargestOutlineLoss = 0.01;

// Share of the triangles whose areas may be off by more than 2 percent without a warning. A choice,
// far above what the maps of scans on the pages have.
constexpr double LargestShareOff = 0.1;

} // namespace

vtkOMTAreaPreservingFilter::vtkOMTAreaPreservingFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

int vtkOMTAreaPreservingFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

void vtkOMTAreaPreservingFilter::SetDomainConnection(vtkAlgorithmOutput* polygon)
{
  this->SetInputConnection(1, polygon);
}

void vtkOMTAreaPreservingFilter::SetDomainData(vtkPolyData* polygon)
{
  this->SetInputData(1, polygon);
}

void vtkOMTAreaPreservingFilter::RemoveDomain()
{
  this->SetInputConnection(1, nullptr);
}

vtkPolyData* vtkOMTAreaPreservingFilter::GetPowerDiagram()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

void vtkOMTAreaPreservingFilter::Execute(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* data = vtkPolyData::GetData(inputVector[0]);
  const flattening::ProgressCallback progress = flattening::progressOf(this);
  const TransportInput input = readInput(data,
    vtkPolyData::GetData(inputVector[1]),
    this->FreeOutline,
    flattening::subrange(progress, 0.0, ReadingShare));
  Eigen::VectorXd weights;
  this->WeightsInUse = "none";
  if (this->UseAreaWeight)
  {
    weights = readWeights(data, this->GetInputArrayInformation(0), this->WeightsInUse);
  }
  const Placement placement = placementOf(input, this->NormalizeTo == UNIT_DOMAIN);
  flattening::AreaPreservingOptions options;
  options.Transport.Tolerance = this->Tolerance;
  options.Start.PowerWeights = startWeights(data, placement);
  options.Start.Positions = startPositions(data, placement);
  options.RefineFaces = this->FaceRefinement;
  options.Refinement.AngleWeight = this->AngleWeight;
  options.FreeOutline = this->FreeOutline;
  options.VerticesPerSite = this->PointsPerSite;
  flattening::AreaPreservingResult result = areaPreservingMap(input,
    this->FixCorners,
    weights,
    options,
    flattening::subrange(progress, input.IsInSpace ? ReadingShare : 0.0, 1.0));
  const flattening::PlacedMap placed =
    flattening::placeMap(input.Surface, input.Loop, result.Map.Positions, placement);
  result.Map.FlippedFaces = placed.FlippedFaces;
  result.Map.Bijective &=
    placed.FlippedFaces == 0 &&
    (!result.Map.IsFree || flattening::isSimpleOutline(placed.Positions, input.Loop));

  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  fillMap(output, data, input.IsInSpace, result.Map, placed.Positions, placement);
  fillPowerDiagram(vtkPolyData::GetData(outputVector, 1), result, input.Surface.Faces, placement);
  setReport(output->GetFieldData(), result.Map);
  flattening::setDatum(output->GetFieldData(), "WeightsInUse", this->WeightsInUse);
  if (!result.Map.Bijective)
  {
    vtkWarningMacro(
      << this->GetBlockPrefix() << result.Map.FlippedFaces
      << " triangles of the area-preserving map are flipped"
      << (this->FaceRefinement
             ? " and could not be untangled: remesh the surface (Surface To Disk, Remesh)"
             : ", as the centroids of the power cells leave them: turn FaceRefinement on"));
  }
  const bool asksForAreas = this->FaceRefinement && this->AngleWeight == 0.0;
  if (asksForAreas && result.Map.Bijective && result.Map.ShareOff > LargestShareOff)
  {
    vtkWarningMacro(
      << this->GetBlockPrefix() << "the areas of " << flattening::formatted(100.0 * result.Map.ShareOff)
      << " percent of the triangles are off by more than 2 percent: give the surface more "
         "points (Surface To Disk, Remesh and Relative Edge Length), or cut it along a longer seam");
  }
  if (this->FreeOutline && !result.Map.IsFree)
  {
    vtkWarningMacro(<< this->GetBlockPrefix()
                    << "the outline could not be freed without a loss of areas, and the map fills "
                       "the domain: remesh the surface (Surface To Disk, Remesh), cut it open along its "
                       "relief (Cut), or use area weights that differ less");
  }
  const double area = EIGEN_PI * placement.Scale * placement.Scale;
  if (!std::isnormal(area))
  {
    vtkWarningMacro(
      << this->GetBlockPrefix()
      << "double precision does not hold areas in the square of the units of this surface: "
         "the arrays of areas are 0 or infinite, and the map is right; scale the surface, "
         "e.g. with Transform");
  }
  const double flatArea =
    flattening::faceAreas(flattening::planarMesh(placed.Positions, {}).Vertices, input.Surface.Faces)
      .sum();
  if (flatArea < (1.0 - LargestOutlineLoss) * area)
  {
    vtkWarningMacro(
      << this->GetBlockPrefix() << "the outline of the map, a polygon, encloses "
      << flattening::formatted(100.0 * (1.0 - flatArea / area))
      << " percent less than the domain, and all areas on the map are too small by that: "
         "multiply them by "
      << flattening::formatted(area / flatArea)
      << ", or give the boundary more points: remesh the surface, or cut it along a longer "
         "seam (Surface To Disk)");
  }
  if (result.Map.StartShare < 1.0)
  {
    vtkWarningMacro(<< this->GetBlockPrefix()
                    << "the face refinement had to begin with a map between the conformal and the "
                       "transported one, as flipped triangles of the latter could not be untangled: "
                       "expect area errors; remesh the surface or cut a larger hole (Surface To Disk)");
  }
}

void vtkOMTAreaPreservingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NormalizeTo: " << (this->NormalizeTo == SURFACE_AREA ? "SurfaceArea" : "UnitDomain")
     << "\n";
  os << indent << "FixCorners: " << this->FixCorners << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "UseAreaWeight: " << this->UseAreaWeight << "\n";
  os << indent << "FaceRefinement: " << this->FaceRefinement << "\n";
  os << indent << "AngleWeight: " << this->AngleWeight << "\n";
  os << indent << "FreeOutline: " << this->FreeOutline << "\n";
  os << indent << "PointsPerSite: " << this->PointsPerSite << "\n";
}
