// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkOMTAreaPreservingFilter.h"

#include "Core/Areas/AreaPreservingDisk.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Transport/DomainPolygon.h"
#include "Internal/FilterExecution.h"
#include "Internal/FlatDomain.h"
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

constexpr const char* DefaultWeights = "AreaWeight";
constexpr const char* FlatPoints = "FlatPoints";

// The weights per point; empty if all are 1.
Eigen::VectorXd readWeights(vtkPolyData* input, const char* chosen)
{
  const bool isSet = chosen && *chosen;
  const std::string name = isSet && std::string(chosen) != "None" ? chosen : DefaultWeights;
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (!array && !isSet)
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
  Eigen::VectorXd weights(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    weights[i] = array->GetComponent(i, 0);
  }
  return weights;
}

// The power weights of an earlier run, over a domain of area pi; empty if there are none.
Eigen::VectorXd readStart(vtkPolyData* input, double area)
{
  vtkDataArray* array = input->GetPointData()->GetArray("PowerWeight");
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return {};
  }
  Eigen::VectorXd start(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    start[i] = array->GetComponent(i, 0) / area;
  }
  return start;
}

// From a domain of area pi around the origin to that of the output.
struct Placement
{
  double Scale = 1.0;
  Eigen::RowVector2d Centre = Eigen::RowVector2d::Zero();
};

// The points of an earlier run, over a domain of area pi; empty if there are none.
flattening::Points2 readStartPositions(vtkPolyData* input,
  double scale,
  const Eigen::RowVector2d& centre)
{
  vtkDataArray* array = input->GetPointData()->GetArray(FlatPoints);
  if (!array || array->GetNumberOfComponents() != 3)
  {
    return {};
  }
  flattening::Points2 start(array->GetNumberOfTuples(), 2);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const Eigen::RowVector2d point(array->GetComponent(i, 0), array->GetComponent(i, 1));
    start.row(i) = (point - centre) / scale;
  }
  return start;
}

void addFlatPoints(vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> array;
  array->DeepCopy(output->GetPoints()->GetData());
  array->SetName(FlatPoints);
  output->GetPointData()->AddArray(array);
}

// A disk around the origin, a rectangle with its lower left corner there.
Placement placementOf(const flattening::FlatDomain& domain, bool isUnit, double surfaceArea)
{
  Placement placement;
  placement.Scale = !isUnit              ? std::sqrt(surfaceArea / EIGEN_PI)
                    : domain.IsRectangle ? domain.Scale / domain.Height
                                         : 1.0;
  if (domain.IsRectangle)
  {
    placement.Centre =
      0.5 * placement.Scale / domain.Scale * Eigen::RowVector2d(domain.Width, domain.Height);
  }
  return placement;
}

// A polygon where it was given.
Placement placementOf(const flattening::DomainPolygon& polygon, bool isUnit, double surfaceArea)
{
  constexpr double pi = EIGEN_PI;
  return { isUnit ? polygon.Scale : std::sqrt(surfaceArea / pi), polygon.Centroid.transpose() };
}

void fillPowerDiagram(vtkPolyData* output,
  const flattening::AreaPreservingResult& result,
  double scale,
  const Eigen::RowVector2d& centre)
{
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
  vtkNew<vtkIdTypeArray> siteIds;
  siteIds->SetName("SiteId");
  vtkNew<vtkDoubleArray> cellAreas;
  cellAreas->SetName("CellArea");
  vtkNew<vtkDoubleArray> targetAreas;
  targetAreas->SetName("TargetArea");
  for (int site = 0; site < diagram.siteCount(); ++site)
  {
    const std::vector<Eigen::Vector2d> outline = diagram.outline(site, oneDegree);
    polygons->InsertNextCell(static_cast<int>(outline.size()));
    for (const Eigen::Vector2d& corner : outline)
    {
      polygons->InsertCellPoint(
        points->InsertNextPoint(centre.x() + scale * corner.x(), centre.y() + scale * corner.y(), 0.0));
    }
    siteIds->InsertNextValue(pointOfSite[site]);
    cellAreas->InsertNextValue(scale * scale * diagram.areas()[site]);
    targetAreas->InsertNextValue(scale * scale * targets[site]);
  }
  output->SetPoints(points);
  output->SetPolys(polygons);
  output->GetCellData()->AddArray(siteIds);
  output->GetCellData()->AddArray(cellAreas);
  output->GetCellData()->AddArray(targetAreas);
}

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
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* cells = vtkPolyData::GetData(outputVector, 1);
  const flattening::TriangleMesh surface = flattening::surfaceOfFlattened(input);
  const std::vector<int> loop = flattening::requireDisk(surface);
  const flattening::Points2 flat = flattening::toPlanarPositions(input);
  const flattening::FlatDomain domain = flattening::flatDomain(flat, loop);
  std::optional<flattening::DomainPolygon> polygon;
  if (vtkPolyData* given = vtkPolyData::GetData(inputVector[1]))
  {
    polygon = flattening::domainPolygon(flattening::polygonOutline(given));
  }
  Eigen::VectorXd weights;
  if (this->UseAreaWeight)
  {
    weights = readWeights(input, this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME()));
  }
  flattening::AreaPreservingOptions options;
  options.Transport.Tolerance = this->Tolerance;
  options.RefineFaces = this->FaceRefinement;
  options.Refinement.AngleWeight = this->AngleWeight;
  options.VerticesPerSite = this->PointsPerSite;

  const flattening::Points2 conformal = (flat.rowwise() - domain.Centre) / domain.Scale;
  const double surfaceArea = flattening::faceAreas(surface.Vertices, surface.Faces).sum();
  const bool isUnit = this->NormalizeTo == UNIT_DOMAIN;
  const auto [scale, centre] =
    polygon ? placementOf(*polygon, isUnit, surfaceArea) : placementOf(domain, isUnit, surfaceArea);
  const double area = scale * scale;
  options.Transport.StartWeights = readStart(input, area);
  options.StartPositions = readStartPositions(input, scale, centre);
  const auto progress = flattening::progressOf(this);
  const flattening::AreaPreservingResult result =
    polygon ? flattening::areaPreservingPolygonMap(surface,
                conformal,
                *domain.normalised(),
                { polygon->Corners, this->FixCorners },
                weights,
                options,
                progress)
    : domain.IsRectangle
      ? flattening::areaPreservingRectangleMap(
          surface, conformal, domain.Width / domain.Scale, weights, options, progress)
      : flattening::areaPreservingDiskMap(surface, conformal, weights, options, progress);
  const flattening::AreaPreservingMap& map = result.Map;

  output->ShallowCopy(input);
  output->SetPoints(
    vtk::TakeSmartPointer(flattening::newPlanarPoints((scale * map.Positions).rowwise() + centre)));
  flattening::deactivateNormals(output);
  flattening::setTextureCoordinates(output, map.Positions);
  flattening::addPointArray(output, "TargetArea", area * map.TargetAreas);
  flattening::addPointArray(output, "CellArea", area * map.CellAreas);
  flattening::addPointArray(output, "PowerWeight", area * map.PowerWeights);
  addFlatPoints(output);
  fillPowerDiagram(cells, result, scale, centre);

  vtkFieldData* figures = output->GetFieldData();
  if (polygon)
  {
    figures->RemoveArray("CornerPointIds"); // of the map before
  }
  if (!map.CornerVertices.empty())
  {
    flattening::setIds(figures, "CornerPointIds", map.CornerVertices);
  }
  flattening::setDatum(figures, "NewtonIterations", static_cast<long long>(map.NewtonIterations));
  flattening::setDatum(figures, "Sites", static_cast<long long>(map.Sites));
  flattening::setDatum(figures, "PowerDiagrams", static_cast<long long>(map.PowerDiagrams));
  flattening::setDatum(figures, "MaxCellAreaError", map.MaxCellError);
  flattening::setDatum(figures, "CoincidentPoints", static_cast<long long>(map.CoincidentVertices));
  flattening::setDatum(figures, "FlippedFaces", static_cast<long long>(map.FlippedFaces));
  flattening::setDatum(figures, "Bijective", static_cast<long long>(map.Bijective ? 1 : 0));
  flattening::setDatum(figures, "WarmStart", static_cast<long long>(map.IsContinued ? 1 : 0));
  flattening::setDatum(figures, "RefinementRounds", static_cast<long long>(map.RefinementRounds));
  flattening::setDatum(figures, "RefinementRepairs", static_cast<long long>(map.RepairedFaces));
  if (this->FaceRefinement && !map.Bijective)
  {
    vtkWarningMacro(<< this->GetBlockPrefix() << map.FlippedFaces
                    << " triangles of the area-preserving map are flipped and could not be turned "
                       "over: remesh the surface (Surface To Disk, Remesh)");
  }
  if (map.StartShare < 1.0)
  {
    vtkWarningMacro(<< this->GetBlockPrefix()
                    << "the face refinement had to begin with a map between the conformal and the "
                       "transported one, as triangles of the latter could not be turned over: expect "
                       "area errors; remesh the surface or cut a larger hole (Surface To Disk)");
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
  os << indent << "PointsPerSite: " << this->PointsPerSite << "\n";
}
