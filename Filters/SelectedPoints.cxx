// SPDX-License-Identifier: GPL-3.0-or-later
#include "SelectedPoints.h"

#include "Core/Errors.h"

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
  }
}

} // namespace

std::vector<char> pointsInSelection(vtkPolyData* data, vtkSelection* selection)
{
  requireEvaluable(selection);
  vtkNew<vtkExtractSelection> extract;
  extract->PreserveTopologyOn();
  extract->SetInputDataObject(0, data);
  extract->SetInputDataObject(1, selection);
  extract->Update();
  auto* marked = vtkDataSet::SafeDownCast(extract->GetOutputDataObject(0));
  std::vector<char> inside(data->GetNumberOfPoints(), 0);
  if (!marked)
  {
    return inside;
  }
  if (vtkDataArray* cells = marked->GetCellData()->GetArray(InsidednessName))
  {
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfTuples(); ++cell)
    {
      if (cells->GetTuple1(cell) > 0.0)
      {
        data->GetCellPoints(cell, corners);
        for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
        {
          inside[corners->GetId(k)] = 1;
        }
      }
    }
  }
  else if (vtkDataArray* points = marked->GetPointData()->GetArray(InsidednessName))
  {
    for (vtkIdType point = 0; point < points->GetNumberOfTuples(); ++point)
    {
      inside[point] = points->GetTuple1(point) > 0.0;
    }
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

std::vector<long long> labelsOf(vtkDataArray* array)
{
  std::vector<long long> labels(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (!std::isfinite(value))
    {
      throw InvalidInput("the label array " + std::string(array->GetName()) + " has no number at " +
                         std::to_string(i) + ": give every point or cell a label");
    }
    labels[i] = std::llround(value);
  }
  return labels;
}

} // namespace flattening
