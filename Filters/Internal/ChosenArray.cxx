// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/ChosenArray.h"

#include "Core/Base/Errors.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace flattening
{
namespace
{

vtkDataArray* arrayOf(vtkDataSetAttributes* attributes, vtkInformation* choice)
{
  return choice->Has(vtkDataObject::FIELD_NAME())
           ? attributes->GetArray(choice->Get(vtkDataObject::FIELD_NAME()))
           : chosenAttribute(attributes, choice);
}

} // namespace

std::string nameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "without a name";
}

vtkDataArray* chosenAttribute(vtkDataSetAttributes* attributes, vtkInformation* choice)
{
  const int type = choice->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  return type >= 0 && type < vtkDataSetAttributes::NUM_ATTRIBUTES ? attributes->GetAttribute(type)
                                                                  : nullptr;
}

ChosenArray chosenArray(vtkAlgorithm* filter, vtkPolyData* data, const std::string& what, int index)
{
  vtkInformation* choice = filter->GetInputArrayInformation(index);
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  const std::string chosen = name ? name : "";
  if (!choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()) && (chosen.empty() || chosen == "None"))
  {
    return {};
  }
  const int association = choice->Get(vtkDataObject::FIELD_ASSOCIATION());
  ChosenArray result;
  if (association == vtkDataObject::FIELD_ASSOCIATION_POINTS ||
      association == vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
  {
    result.Array = arrayOf(data->GetPointData(), choice);
  }
  if (!result.Array && association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    result = { arrayOf(data->GetCellData(), choice), true };
  }
  const std::string called = what + (chosen.empty() ? "" : " " + chosen);
  if (!result.Array || result.Array->GetNumberOfComponents() != 1)
  {
    throw InvalidInput(called + " is not a point or cell array of one component: choose another");
  }
  return result;
}

} // namespace flattening
