// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/PolyDataConversion.h"

#include "Core/Base/Errors.h"
#include "Core/Mesh/CoordinateFrame.h"
#include "Internal/ArrayConversion.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace flattening
{

bool isEmpty(vtkDataObject* data)
{
  return !data || (data->GetNumberOfElements(vtkDataObject::POINT) == 0 &&
                    data->GetNumberOfElements(vtkDataObject::CELL) == 0 &&
                    data->GetNumberOfElements(vtkDataObject::VERTEX) == 0);
}

namespace
{

FaceMatrix toFaces(vtkPolyData* data)
{
  const vtkIdType triangles = data->GetNumberOfPolys();
  if (data->GetNumberOfCells() != triangles)
  {
    throw InvalidInput(
      "the surface has vertices, lines or strips beside its triangles: run Surface To Disk first");
  }
  if (triangles == 0)
  {
    throw InvalidInput("the surface has no triangles: pass a triangle surface, e.g. from Contour");
  }
  if (data->GetNumberOfPoints() > std::numeric_limits<int>::max())
  {
    throw InvalidInput("the surface has more points than can be flattened (2^31): decimate it first");
  }
  FaceMatrix faces(triangles, 3);
  auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  vtkIdType face = 0;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++face)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    if (size != 3)
    {
      throw InvalidInput("cell " + std::to_string(face) + " has " + std::to_string(size) +
                         " points, not 3: run Surface To Disk or Triangulate first");
    }
    for (int k = 0; k < 3; ++k)
    {
      if (ids[k] < 0 || ids[k] >= data->GetNumberOfPoints())
      {
        throw InvalidInput("cell " + std::to_string(face) + " names point " + std::to_string(ids[k]) +
                           ", which does not exist: the data set is damaged");
      }
      faces(face, k) = static_cast<int>(ids[k]);
    }
  }
  return faces;
}

} // namespace

Points3 pointsOf(vtkPolyData* data)
{
  return data->GetPoints() ? Points3(toMatrix<3>(data->GetPoints()->GetData())) : Points3(0, 3);
}

TriangleMesh toTriangleMesh(vtkPolyData* data)
{
  TriangleMesh mesh;
  mesh.Faces = toFaces(data);
  mesh.Vertices = pointsOf(data);
  return mesh;
}

double coordinateStep(const Points3& points, int type)
{
  const double greatest = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0.0;
  if (type == VTK_FLOAT)
  {
    const auto coordinate = static_cast<float>(greatest);
    return std::nextafter(coordinate, HUGE_VALF) - coordinate;
  }
  return std::nextafter(greatest, HUGE_VAL) - greatest;
}

TriangleMesh surfaceOfFlattened(vtkPolyData* flattened)
{
  vtkDataArray* points = flattened->GetPointData()->GetArray(SurfacePointsName);
  if (!points)
  {
    throw InvalidInput("the input has no point array SurfacePoints, so it is not a flattened "
                       "surface: run Conformal Disk first");
  }
  if (points->GetNumberOfComponents() != 3)
  {
    throw InvalidInput("the point array SurfacePoints has " +
                       std::to_string(points->GetNumberOfComponents()) +
                       " components, not 3: run Conformal Disk again");
  }
  TriangleMesh mesh;
  mesh.Faces = toFaces(flattened);
  mesh.Vertices = toMatrix<3>(points);
  return mesh;
}

void requireOrdinarySize(const TriangleMesh& surface)
{
  if (CoordinateFrame(surface).changesSize())
  {
    const Points3& points = surface.Vertices;
    throw InvalidInput(
      "the surface extends over " +
      formatted((points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff()) +
      " units, outside of the range of this filter, 2e-10 to 4e9: scale it, e.g. with "
      "Transform");
  }
}

TriangleMesh surfaceInSpace(vtkPolyData* data)
{
  TriangleMesh surface =
    data->GetPointData()->HasArray(SurfacePointsName) ? surfaceOfFlattened(data) : toTriangleMesh(data);
  requireOrdinarySize(surface);
  return surface;
}

namespace
{

// The deviation from a plane that is rounding, as a share of the extent: between the rounding of single
// precision, about 1e-7, and a surface that was warped back into space, whose x and y make no sense.
constexpr double Flatness = 1e-6;

void requireFlat(vtkPolyData* flattened)
{
  double bounds[6];
  flattened->GetBounds(bounds);
  const double extent = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  if (bounds[5] - bounds[4] > Flatness * extent)
  {
    throw InvalidInput("the input is not flat (z runs from " + formatted(bounds[4]) + " to " +
                       formatted(bounds[5]) +
                       "): pass the output of Conformal Disk or OMT Area Preserving as it is");
  }
}

} // namespace

Points2 toPlanarPositions(vtkPolyData* flattened)
{
  requireFlat(flattened);
  const Points3 points = pointsOf(flattened);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (!points.row(i).allFinite())
    {
      throw InvalidInput("point " + std::to_string(i) +
                         " of the flat surface is not finite: clean the data before flattening");
    }
  }
  return points.leftCols<2>();
}

vtkPoints* newPlanarPoints(const Points2& positions)
{
  vtkPoints* points = vtkPoints::New(VTK_DOUBLE);
  points->SetNumberOfPoints(positions.rows());
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    points->SetPoint(i, positions(i, 0), positions(i, 1), 0.0);
  }
  return points;
}

void deactivateNormals(vtkPolyData* flattened)
{
  flattened->GetPointData()->SetActiveAttribute(-1, vtkDataSetAttributes::NORMALS);
  flattened->GetCellData()->SetActiveAttribute(-1, vtkDataSetAttributes::NORMALS);
}

void setTriangles(vtkPolyData* output, const TriangleMesh& mesh)
{
  auto points = vtk::TakeSmartPointer(vtkPoints::New(VTK_DOUBLE));
  points->SetData(newTuples<vtkDoubleArray>("Points", mesh.Vertices));
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(mesh.faceCount(), 3 * static_cast<vtkIdType>(mesh.faceCount()));
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const vtkIdType ids[3] = { mesh.Faces(f, 0), mesh.Faces(f, 1), mesh.Faces(f, 2) };
    cells->InsertNextCell(3, ids);
  }
  output->SetPoints(points);
  output->SetPolys(cells);
}

void addSurfacePoints(vtkPolyData* output, const Points3& surface)
{
  output->GetPointData()->AddArray(newTuples<vtkDoubleArray>(SurfacePointsName, surface));
}

void addPointArray(vtkPolyData* output, const char* name, const Eigen::VectorXd& values)
{
  output->GetPointData()->AddArray(newArray<vtkDoubleArray>(name, values));
}

void setDatum(vtkFieldData* fieldData, const char* name, double value)
{
  fieldData->AddArray(newArray<vtkDoubleArray>(name, std::array{ value }));
}

void setDatum(vtkFieldData* fieldData, const char* name, long long value)
{
  fieldData->AddArray(newArray<vtkIdTypeArray>(name, std::array{ value }));
}

void setIds(vtkFieldData* fieldData, const char* name, const std::vector<int>& ids)
{
  fieldData->AddArray(newArray<vtkIdTypeArray>(name, ids));
}

void setDatum(vtkFieldData* fieldData, const char* name, const std::string& value)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fieldData->AddArray(array);
}

} // namespace flattening
