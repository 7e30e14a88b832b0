// SPDX-License-Identifier: GPL-3.0-or-later
#include "SameData.h"

#include <vtkBitArray.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <cstring>

namespace fuzz
{
namespace
{

bool isSame(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (!a || !b || a->GetDataType() != b->GetDataType() ||
      a->GetNumberOfValues() != b->GetNumberOfValues() ||
      a->GetNumberOfComponents() != b->GetNumberOfComponents())
  {
    return a == b;
  }
  const vtkIdType count = a->GetNumberOfValues();
  if (auto* numbers = vtkDataArray::SafeDownCast(a); numbers && !vtkBitArray::SafeDownCast(a))
  {
    const std::size_t bytes = static_cast<std::size_t>(count) * numbers->GetDataTypeSize();
    return count == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes) == 0;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (a->GetVariantValue(i) != b->GetVariantValue(i))
    {
      return false;
    }
  }
  return true;
}

std::string difference(vtkFieldData* a, vtkFieldData* b)
{
  if (!a || !b)
  {
    return a == b ? "" : "attributes";
  }
  if (a->GetNumberOfArrays() != b->GetNumberOfArrays())
  {
    return "the number of arrays";
  }
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = a->GetAbstractArray(i);
    if (!isSame(array, b->GetAbstractArray(i)))
    {
      return std::string("the array ") + (array->GetName() ? array->GetName() : "without a name");
    }
  }
  return {};
}

std::string difference(vtkCellArray* a, vtkCellArray* b)
{
  if (a->GetNumberOfCells() != b->GetNumberOfCells())
  {
    return "the number of cells";
  }
  vtkNew<vtkIdList> one;
  vtkNew<vtkIdList> other;
  for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c)
  {
    a->GetCellAtId(c, one);
    b->GetCellAtId(c, other);
    if (!std::equal(one->begin(), one->end(), other->begin(), other->end()))
    {
      return "a cell";
    }
  }
  return {};
}

std::string leafDifference(vtkDataObject* a, vtkDataObject* b)
{
  auto* points = vtkPointSet::SafeDownCast(a);
  auto* otherPoints = vtkPointSet::SafeDownCast(b);
  if (points && otherPoints && points->GetNumberOfPoints() > 0 &&
      (points->GetNumberOfPoints() != otherPoints->GetNumberOfPoints() ||
        !isSame(points->GetPoints()->GetData(), otherPoints->GetPoints()->GetData())))
  {
    return "the points";
  }
  auto* cells = vtkPolyData::SafeDownCast(a);
  auto* otherCells = vtkPolyData::SafeDownCast(b);
  if (cells && otherCells)
  {
    const std::string cellDifference = difference(cells->GetPolys(), otherCells->GetPolys());
    if (!cellDifference.empty())
    {
      return cellDifference;
    }
  }
  for (int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::FIELD })
  {
    const std::string arrays =
      difference(a->GetAttributesAsFieldData(kind), b->GetAttributesAsFieldData(kind));
    if (!arrays.empty())
    {
      return arrays;
    }
  }
  return {};
}

} // namespace

std::string difference(vtkDataObject* a, vtkDataObject* b)
{
  if (!a || !b || std::strcmp(a->GetClassName(), b->GetClassName()) != 0)
  {
    return a == b ? "" : "the class of the output";
  }
  auto* blocks = vtkCompositeDataSet::SafeDownCast(a);
  if (!blocks)
  {
    return leafDifference(a, b);
  }
  auto* otherBlocks = vtkCompositeDataSet::SafeDownCast(b);
  const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    const std::string inLeaf = difference(leaf->GetCurrentDataObject(), otherBlocks->GetDataSet(leaf));
    if (!inLeaf.empty())
    {
      return inLeaf;
    }
  }
  return {};
}

} // namespace fuzz
