// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/WholeArrays.h"

#include "Core/Base/Errors.h"

#include <vtkAbstractArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkInformationVector.h>

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
      if (array->GetNumberOfTuples() < data->GetNumberOfElements(type))
      {
        const std::string name = array->GetName() ? array->GetName() : "without a name";
        throw InvalidInput("the array " + name + " has " + std::to_string(array->GetNumberOfTuples()) +
                           " tuples for " + std::to_string(data->GetNumberOfElements(type)) + " " +
                           elements +
                           ": the data set is damaged; remove the array, e.g. with Pass Arrays");
      }
    }
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
        requireWholeArrays(data);
      }
    }
  }
}

} // namespace flattening
