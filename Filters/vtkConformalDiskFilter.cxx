// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkConformalDiskFilter.h"

#include "Core/ConformalDisk.h"
#include "Core/MeshTopology.h"
#include "FilterExecution.h"
#include "PolyDataConversion.h"

#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkConformalDiskFilter);

namespace
{

int nearestVertex(const flattening::Points3& vertices,
  const std::vector<int>& candidates,
  const double point[3])
{
  const Eigen::RowVector3d target(point[0], point[1], point[2]);
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

} // namespace

vtkConformalDiskFilter::vtkConformalDiskFilter() = default;

int vtkConformalDiskFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (flattening::isEmpty(input))
  {
    return 1;
  }

  return flattening::runFilter(this,
    outputVector,
    [&]
    {
      const flattening::TriangleMesh mesh = flattening::toTriangleMesh(input);
      flattening::ConformalDiskOptions options;
      options.Flow.Tolerance = this->Tolerance;
      if (this->UseCenterPoint)
      {
        std::vector<int> all(mesh.vertexCount());
        std::iota(all.begin(), all.end(), 0);
        options.CenterVertex = nearestVertex(mesh.Vertices, all, this->CenterPoint);
      }
      if (this->UseBoundaryPoint)
      {
        options.BoundaryVertex =
          nearestVertex(mesh.Vertices, flattening::requireDisk(mesh), this->BoundaryPoint);
      }

      const flattening::ConformalDiskMap map =
        flattening::conformalDiskMap(mesh, options, flattening::progressOf(this));

      const double radius =
        this->NormalizeTo == SURFACE_AREA
          ? std::sqrt(flattening::faceAreas(mesh.Vertices, mesh.Faces).sum() / EIGEN_PI)
          : 1.0;
      output->ShallowCopy(input);
      output->SetPoints(vtk::TakeSmartPointer(flattening::newPlanarPoints(radius * map.Positions)));
      flattening::deactivateNormals(output);
      flattening::addSurfacePoints(output, mesh.Vertices);
      flattening::addPointArray(
        output, "ConformalFactor", (map.LogFactors.array() + std::log(radius)).matrix());

      vtkFieldData* figures = output->GetFieldData();
      flattening::setFigure(figures, "NewtonIterations", static_cast<long long>(map.NewtonIterations));
      flattening::setFigure(figures, "MaxCurvatureError", map.MaxCurvatureError);
      flattening::setFigure(figures, "LayoutError", map.LayoutError);
      flattening::setFigure(figures, "IntrinsicFlips", static_cast<long long>(map.Flips));
      flattening::setFigure(
        figures, "InsertedBoundaryPoints", static_cast<long long>(map.InsertedBoundaryPoints));
      flattening::setFigure(figures, "AddedLength", map.AddedLength);
      flattening::setFigure(figures, "FlippedFaces", static_cast<long long>(map.FlippedFaces));
    });
}

void vtkConformalDiskFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NormalizeTo: " << (this->NormalizeTo == SURFACE_AREA ? "SurfaceArea" : "UnitDomain")
     << "\n";
  os << indent << "UseCenterPoint: " << this->UseCenterPoint << "\n";
  os << indent << "CenterPoint: (" << this->CenterPoint[0] << ", " << this->CenterPoint[1] << ", "
     << this->CenterPoint[2] << ")\n";
  os << indent << "UseBoundaryPoint: " << this->UseBoundaryPoint << "\n";
  os << indent << "BoundaryPoint: (" << this->BoundaryPoint[0] << ", " << this->BoundaryPoint[1] << ", "
     << this->BoundaryPoint[2] << ")\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
