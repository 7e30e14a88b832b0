// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSeamPreview.h"

#include "Core/Disk/SeamWayPoints.h"
#include "Core/Geodesics/GeodesicPath.h"
#include "Core/Mesh/CoordinateFrame.h"
#include "Internal/FilterExecution.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/TriangulatedInput.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

vtkStandardNewMacro(vtkSeamPreview);

namespace
{

using flattening::SurfaceMesh;
using Line = std::vector<Eigen::Vector3d>;

std::optional<SurfaceMesh> connected(const flattening::TriangleMesh& mesh)
{
  try
  {
    return flattening::toSurfaceMesh(mesh);
  }
  catch (const flattening::TopologyError&)
  {
    return std::nullopt; // it will be repaired before it is cut
  }
}

// The vertices of faces, one flag per vertex: other points are no part of the surface.
std::vector<char> verticesOfFaces(const flattening::TriangleMesh& mesh)
{
  std::vector<char> used(mesh.vertexCount(), 0);
  for (const int v : mesh.Faces.reshaped())
  {
    used[v] = 1;
  }
  return used;
}

int nearestVertex(const flattening::TriangleMesh& mesh,
  const std::vector<char>& candidates,
  const Eigen::Vector3d& picked)
{
  int nearest = -1;
  double smallest = std::numeric_limits<double>::infinity();
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double distance = (mesh.Vertices.row(v) - picked.transpose()).squaredNorm();
    if (candidates[v] && (nearest < 0 || distance < smallest))
    {
      nearest = v;
      smallest = distance;
    }
  }
  return nearest;
}

Line legBetween(const std::optional<SurfaceMesh>& surface,
  const flattening::Points3& points,
  int from,
  int to,
  const flattening::ProgressCallback& progress)
{
  Line line;
  try
  {
    if (surface)
    {
      using Vertex = SurfaceMesh::Vertex_index;
      for (const flattening::PathPoint& point :
        flattening::geodesicPath(*surface, Vertex(from), Vertex(to), progress).Points)
      {
        line.push_back(flattening::positionOf(*surface, point));
      }
    }
  }
  catch (const flattening::TopologyError&)
  {
    line.clear(); // the points are on different components
  }
  return line.empty() ? Line{ points.row(from), points.row(to) } : line;
}

} // namespace

void vtkSeamPreview::SetNumberOfSeamPoints(int number)
{
  this->SeamPoints.resize(std::clamp(number, 0, flattening::MostSeamPoints), { 0.0, 0.0, 0.0 });
  this->Modified();
}

void vtkSeamPreview::SetSeamPoint(int index, double x, double y, double z)
{
  if (index >= 0 && index < static_cast<int>(this->SeamPoints.size()))
  {
    this->SeamPoints[index] = { x, y, z };
    this->Modified();
  }
}

void vtkSeamPreview::SetNumberOfSeamPathStarts(int number)
{
  this->SeamPathStarts.resize(std::clamp(number, 0, flattening::MostSeamPoints), 0);
  this->Modified();
}

void vtkSeamPreview::SetSeamPathStart(int index, int point)
{
  if (index >= 0 && index < static_cast<int>(this->SeamPathStarts.size()))
  {
    this->SeamPathStarts[index] = point;
    this->Modified();
  }
}

void vtkSeamPreview::Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const flattening::ProgressCallback progress = flattening::progressOf(this);
  const flattening::TriangleMesh input =
    flattening::toTriangleMesh(flattening::triangulate(vtkPolyData::GetData(inputVector[0])));
  const flattening::CoordinateFrame frame(input);
  const flattening::TriangleMesh mesh = frame.normalised(input);
  const std::optional<SurfaceMesh> surface = connected(mesh);
  const std::vector<char> candidates = verticesOfFaces(mesh);
  std::vector<int> vertices;
  for (const std::array<double, 3>& point : this->SeamPoints)
  {
    vertices.push_back(
      nearestVertex(mesh, candidates, frame.normalisedPoint(Eigen::Vector3d(point.data()))));
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> legs;
  legs->SetName("Leg");
  for (int k = 1; k < static_cast<int>(vertices.size()); ++k)
  {
    const std::vector<int>& starts = this->SeamPathStarts;
    if (std::find(starts.begin(), starts.end(), k) != starts.end() || vertices[k] == vertices[k - 1])
    {
      continue;
    }
    const Line leg = legBetween(surface,
      mesh.Vertices,
      vertices[k - 1],
      vertices[k],
      flattening::atFraction(progress, 0.5, "Seam"));
    lines->InsertNextCell(static_cast<int>(leg.size()));
    legs->InsertNextValue(k - 1);
    for (const Eigen::Vector3d& point : leg)
    {
      lines->InsertCellPoint(points->InsertNextPoint(frame.restoredPoint(point).data()));
    }
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->AddArray(legs);
  flattening::report(progress, 1.0, "Done");
}

void vtkSeamPreview::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SeamPoints: " << this->SeamPoints.size() << "\n";
  os << indent << "SeamPathStarts: " << this->SeamPathStarts.size() << "\n";
}
