// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/AttributeTransfer.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

namespace flattening
{
namespace
{

// Adds an empty array of the same type, name and active role.
vtkAbstractArray* addArrayLike(vtkDataSetAttributes* from,
  vtkAbstractArray* array,
  vtkIdType tuples,
  vtkDataSetAttributes* to)
{
  auto copy = vtk::TakeSmartPointer(array->NewInstance());
  copy->SetName(array->GetName());
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  copy->CopyComponentNames(array);
  copy->SetNumberOfTuples(tuples);
  if (array->HasInformation())
  {
    copy->CopyInformation(array->GetInformation());
  }
  const int index = to->AddArray(copy);
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    if (from->GetAbstractAttribute(type) == array)
    {
      to->SetActiveAttribute(index, type);
    }
  }
  return copy;
}

// Calls @p transfer(array, result) for each array and its counterpart.
template <typename Transfer>
void forEachArray(vtkDataSetAttributes* from,
  vtkIdType tuples,
  vtkDataSetAttributes* to,
  Transfer&& transfer)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    if (array != from->GetGlobalIds())
    {
      transfer(array, addArrayLike(from, array, tuples, to));
    }
  }
}

void setZero(vtkAbstractArray* array, vtkIdType tuple)
{
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    for (int component = 0; component < numbers->GetNumberOfComponents(); ++component)
    {
      numbers->SetComponent(tuple, component, 0.0);
    }
  }
}

bool isFloatingPoint(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

} // namespace

void transferPointData(vtkPointData* from, const VertexOrigins& origins, vtkPointData* to)
{
  std::vector<vtkIdType> nearest(origins.rows(), -1);
  for (int v = 0; v < origins.rows(); ++v)
  {
    double largest = 0.0;
    for (VertexOrigins::InnerIterator weight(origins, v); weight; ++weight)
    {
      if (weight.value() > largest)
      {
        largest = weight.value();
        nearest[v] = weight.col();
      }
    }
  }

  vtkNew<vtkIdList> ids;
  std::vector<double> weights;
  const auto transfer = [&](vtkAbstractArray* array, vtkAbstractArray* result)
  {
    const bool interpolates = isFloatingPoint(array);
    for (int v = 0; v < origins.rows(); ++v)
    {
      ids->Reset();
      weights.clear();
      for (VertexOrigins::InnerIterator weight(origins, v); interpolates && weight; ++weight)
      {
        ids->InsertNextId(weight.col());
        weights.push_back(weight.value());
      }
      if (nearest[v] < 0)
      {
        setZero(result, v);
      }
      else if (weights.size() > 1)
      {
        result->InterpolateTuple(v, ids, array, weights.data());
      }
      else
      {
        result->SetTuple(v, nearest[v], array); // exactly, as a sum of one term might be rounded
      }
    }
  };
  forEachArray(from, origins.rows(), to, transfer);
}

void transferCellData(vtkCellData* from, const std::vector<vtkIdType>& origins, vtkCellData* to)
{
  const auto cells = static_cast<vtkIdType>(origins.size());
  const auto transfer = [&](vtkAbstractArray* array, vtkAbstractArray* result)
  {
    for (vtkIdType cell = 0; cell < cells; ++cell)
    {
      if (origins[cell] >= 0)
      {
        result->SetTuple(cell, origins[cell], array);
      }
      else
      {
        setZero(result, cell);
      }
    }
  };
  forEachArray(from, cells, to, transfer);
}

} // namespace flattening
