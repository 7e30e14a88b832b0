// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/TriangulatedInput.h"

#include "Core/Base/Errors.h"
#include "Internal/PolyDataConversion.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>

namespace flattening
{
namespace
{

// Checks the points of the cells before triangulation, which needs finite points and changes the ids of
// the cells.
void requireFinitePoints(vtkPolyData* input, vtkCellArray* cells)
{
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      double x[3];
      input->GetPoint(ids[i], x);
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        throw InvalidInput("point " + std::to_string(ids[i]) +
                           " has a coordinate that is not finite: remove such points first, e.g. with "
                           "Threshold or Extract Selection");
      }
    }
  }
}

// The points, or a copy at the scale of 1 if VTK could not triangulate polygons: it takes fourth powers
// of the lengths of their edges.
vtkSmartPointer<vtkPoints> pointsForTriangulation(vtkPolyData* input)
{
  constexpr int greatestExponent = 200;
  const double* bounds = input->GetBounds();
  const double extent =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  const int exponent = extent > 0.0 && std::isfinite(extent) ? std::ilogb(extent) : 0;
  if (std::abs(exponent) <= greatestExponent)
  {
    return input->GetPoints();
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(input->GetNumberOfPoints());
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    double x[3];
    input->GetPoint(i, x);
    points->SetPoint(
      i, std::ldexp(x[0], -exponent), std::ldexp(x[1], -exponent), std::ldexp(x[2], -exponent));
  }
  return points;
}

} // namespace

vtkSmartPointer<vtkPolyData> triangulate(vtkPolyData* input)
{
  requireFinitePoints(input, input->GetPolys());
  requireFinitePoints(input, input->GetStrips());

  // Without vertices and lines: vtkTriangleFilter of VTK 9.3 passes them on if all polygons are
  // triangles. They are the first cells of the input.
  const vtkIdType first = input->GetNumberOfVerts() + input->GetNumberOfLines();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(pointsForTriangulation(input));
  bare->SetPolys(input->GetPolys());
  bare->SetStrips(input->GetStrips());
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(OriginalCellIdsName);
  ids->SetNumberOfTuples(bare->GetNumberOfCells());
  std::iota(ids->Begin(), ids->End(), first);
  bare->GetCellData()->AddArray(ids);

  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(bare);
  triangles->Update();
  triangles->GetOutput()->SetPoints(input->GetPoints());
  return triangles->GetOutput();
}

std::vector<vtkIdType> cellsOf(vtkPolyData* triangles)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(triangles->GetCellData()->GetArray(OriginalCellIdsName));
  return { ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples() };
}

std::vector<char> labelledTriangles(vtkPolyData* triangles, const ChosenArray& labels, int label)
{
  if (!labels.Array)
  {
    throw InvalidInput(
      "no array of labels is chosen: choose a point or cell array that names the part to "
      "be removed, or another way to cut");
  }
  const auto hasLabel = [&](vtkIdType i) { return labels.Array->GetTuple1(i) == label; };
  const std::vector<vtkIdType> cells = cellsOf(triangles);
  std::vector<char> labelled(cells.size(), 0);
  vtkNew<vtkIdList> corners;
  for (std::size_t f = 0; f < cells.size(); ++f)
  {
    triangles->GetCellPoints(static_cast<vtkIdType>(f), corners);
    labelled[f] = labels.OnCells ? hasLabel(cells[f])
                                 : std::count_if(corners->begin(), corners->end(), hasLabel) >= 2;
  }
  return labelled;
}

} // namespace flattening
