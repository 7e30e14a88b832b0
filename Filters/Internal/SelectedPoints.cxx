// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/SelectedPoints.h"

#include "Core/Base/Errors.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExtractSelection.h>
#include <vtkIdList.h>
#include <vtkImplicitFunction.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace flattening
{
namespace
{

constexpr const char* InsidednessName = "vtkInsidedness"; // of vtkExtractSelection

void requireEvaluable(vtkSelection* selection)
{
  if (!selection || selection->GetNumberOfNodes() == 0)
  {
    throw InvalidInput("there is no selection: select points or cells in a view, then press Copy Active "
                       "Selection");
  }
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    if (selection->GetNode(i)->GetContentType() == vtkSelectionNode::QUERY)
    {
      throw InvalidInput(
        "the selection is a query, not a list of points or cells: freeze it (Find Data, "
        "Freeze) and press Copy Active Selection again");
    }
    const int type = selection->GetNode(i)->GetContentType();
    if (type == vtkSelectionNode::BLOCKS || type == vtkSelectionNode::BLOCK_SELECTORS)
    {
      throw InvalidInput(
        "the selection is one of blocks, not of points or cells: select points or cells, "
        "or pass the blocks alone (Extract Block)");
    }
  }
}

// The data with the insidedness array of vtkExtractSelection; null if there is none. An array that an
// earlier selection left is taken away.
vtkSmartPointer<vtkDataSet> marked(vtkPolyData* data, vtkSelection* selection)
{
  requireEvaluable(selection);
  vtkNew<vtkPolyData> unmarked;
  unmarked->ShallowCopy(data);
  unmarked->GetPointData()->RemoveArray(InsidednessName);
  unmarked->GetCellData()->RemoveArray(InsidednessName);
  vtkNew<vtkExtractSelection> extract;
  extract->PreserveTopologyOn();
  extract->SetInputDataObject(0, unmarked);
  extract->SetInputDataObject(1, selection);
  extract->Update();
  return vtkDataSet::SafeDownCast(extract->GetOutputDataObject(0));
}

// The flags of the insidedness array; empty if there is none.
std::vector<char> insidedness(vtkDataSetAttributes* attributes)
{
  vtkDataArray* array = attributes->GetArray(InsidednessName);
  std::vector<char> inside(array ? array->GetNumberOfTuples() : 0);
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    inside[i] = array->GetTuple1(static_cast<vtkIdType>(i)) > 0.0;
  }
  return inside;
}

// The flags of the selected cells and points; empty if the selection has none of the kind.
struct Selected
{
  std::vector<char> Cells;
  std::vector<char> Points;
};

Selected selectedIn(vtkPolyData* data, vtkSelection* selection)
{
  const vtkSmartPointer<vtkDataSet> result = marked(data, selection);
  return result ? Selected{ insidedness(result->GetCellData()), insidedness(result->GetPointData()) }
                : Selected{};
}

// The points of a cell.
std::vector<vtkIdType> cornersOf(vtkPolyData* data, vtkIdType cell)
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(cell, corners);
  return { corners->GetPointer(0), corners->GetPointer(0) + corners->GetNumberOfIds() };
}

} // namespace

std::vector<char> pointsWhereNotZero(vtkPolyData* data, const ChosenArray& array)
{
  std::vector<char> marked(data->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < array.Array->GetNumberOfTuples(); ++i)
  {
    const double value = array.Array->GetTuple1(i);
    if (!std::isfinite(value))
    {
      throw InvalidInput("the array " + nameOf(array.Array) + " has no number at " + std::to_string(i) +
                         ": give every point or cell a value");
    }
    if (value != 0.0)
    {
      for (const vtkIdType point : array.OnCells ? cornersOf(data, i) : std::vector<vtkIdType>{ i })
      {
        marked[point] = 1;
      }
    }
  }
  return marked;
}

std::vector<char> pointsInSelection(vtkPolyData* data, vtkSelection* selection)
{
  const Selected selected = selectedIn(data, selection);
  if (selected.Cells.empty() && !selected.Points.empty())
  {
    return selected.Points;
  }
  std::vector<char> inside(data->GetNumberOfPoints(), 0);
  for (std::size_t cell = 0; cell < selected.Cells.size(); ++cell)
  {
    if (selected.Cells[cell])
    {
      for (const vtkIdType point : cornersOf(data, static_cast<vtkIdType>(cell)))
      {
        inside[point] = 1;
      }
    }
  }
  return inside;
}

std::vector<char> cellsInSelection(vtkPolyData* data, vtkSelection* selection)
{
  const Selected selected = selectedIn(data, selection);
  if (!selected.Cells.empty())
  {
    return selected.Cells;
  }
  std::vector<char> inside(data->GetNumberOfCells(), 0);
  for (vtkIdType cell = 0; !selected.Points.empty() && cell < data->GetNumberOfCells(); ++cell)
  {
    const std::vector<vtkIdType> corners = cornersOf(data, cell);
    inside[cell] = std::count_if(corners.begin(),
                     corners.end(),
                     [&](vtkIdType point) { return selected.Points[point] != 0; }) >= 2;
  }
  return inside;
}

std::vector<char> pointsInFunction(vtkImplicitFunction* function, const Points3& positions, bool outside)
{
  if (!function)
  {
    throw InvalidInput("no implicit function is set: choose a sphere, a box or a plane");
  }
  std::vector<char> inside(positions.rows(), 0);
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    const double value = function->FunctionValue(positions(v, 0), positions(v, 1), positions(v, 2));
    if (std::isnan(value))
    {
      throw InvalidInput("the implicit function has no value at point " + std::to_string(v) +
                         ": give it a finite position and size");
    }
    inside[v] = outside ? value >= 0.0 : value <= 0.0;
  }
  return inside;
}

} // namespace flattening
