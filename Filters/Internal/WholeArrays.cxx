// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/WholeArrays.h"

#include "Core/Base/Errors.h"
#include "Internal/ChosenArray.h"

#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkInformationVector.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

constexpr std::pair<int, const char*> Elements[] = { { vtkDataObject::POINT, "points" },
  { vtkDataObject::CELL, "cells" },
  { vtkDataObject::VERTEX, "vertices" },
  { vtkDataObject::EDGE, "edges" },
  { vtkDataObject::ROW, "rows" } };

void requireWholeArrays(vtkDataObject* data)
{
  for (const auto& [type, elements] : Elements)
  {
    vtkFieldData* arrays = data->GetAttributesAsFieldData(type);
    for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = arrays->GetAbstractArray(i);
      if (array->GetNumberOfTuples() != data->GetNumberOfElements(type))
      {
        throw InvalidInput("the array " + nameOf(array) + " has " +
                           std::to_string(array->GetNumberOfTuples()) + " tuples for " +
                           std::to_string(data->GetNumberOfElements(type)) + " " + elements +
                           ": the data set is damaged; remove the array, e.g. with Pass Arrays");
      }
    }
  }
}

// Readers pass on what damaged files say about cells.
void requireWholeCells(vtkCellArray* cells, vtkIdType points)
{
  if (!cells->IsValid())
  {
    throw InvalidInput("the list of cells names places that it does not have: the data set is damaged; "
                       "write it again from its source");
  }
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cell->GetCurrentCell(size, ids);
    const vtkIdType* wrong =
      std::find_if(ids, ids + size, [points](vtkIdType id) { return id < 0 || id >= points; });
    if (wrong != ids + size)
    {
      throw InvalidInput("a cell names point " + std::to_string(*wrong) +
                         ", which does not exist: the data set is damaged");
    }
  }
}

void requireWholeCells(vtkPolyData* data)
{
  for (vtkCellArray* cells : { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    requireWholeCells(cells, data->GetNumberOfPoints());
  }
}

} // namespace

void requireWholeArrays(vtkInformationVector** inputs, int portCount)
{
  for (int port = 0; port < portCount; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      if (vtkDataObject* data = vtkDataObject::GetData(inputs[port], i))
      {
        if (auto* surface = vtkPolyData::SafeDownCast(data))
        {
          requireWholeCells(surface);
        }
        requireWholeArrays(data);
      }
    }
  }
}

} // namespace flattening
