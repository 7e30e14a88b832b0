// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects.h"

#include <vtkBitArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSignedCharArray.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedLongLongArray.h>

#include <cmath>

namespace fuzz
{
namespace
{

template <typename Array, typename Draw>
vtkSmartPointer<Array> newArray(const char* name, vtkIdType tuples, int components, Draw draw)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (vtkIdType i = 0; i < tuples * components; ++i)
  {
    array->InsertNextValue(draw());
  }
  return array;
}

void addArray(Random& random, vtkDataSetAttributes* data, vtkIdType n)
{
  switch (random.integer(0, 9))
  {
    case 0:
      data->AddArray(newArray<vtkStringArray>(
        "Names", n, 1, [&] { return std::string("name ") + std::to_string(random.integer(0, 9)); }));
      break;
    case 1:
      data->AddArray(newArray<vtkBitArray>("Bits", n, 1, [&] { return random.integer(0, 1); }));
      break;
    case 2:
      data->AddArray(newArray<vtkIntArray>("Labels", n, 1, [&] { return random.integer(-1, 3); }));
      break;
    case 3:
      data->AddArray(newArray<vtkDoubleArray>("Vectors", n, 3, [&] { return random.normal(); }));
      break;
    case 4:
      data->SetNormals(newArray<vtkFloatArray>("Normals", n, 3, [&] { return random.normal(); }));
      break;
    case 5:
      data->SetTCoords(newArray<vtkFloatArray>("TCoords", n, 2, [&] { return random.uniform(); }));
      break;
    case 6:
      data->SetGlobalIds(
        newArray<vtkIdTypeArray>("GlobalIds", n, 1, [&, i = 0]() mutable { return i++; }));
      break;
    case 7:
      data->AddArray(newArray<vtkDoubleArray>(
        "Holes", n, 1, [&] { return random.chance(0.1) ? std::nan("") : random.normal(); }));
      break;
    case 8:
      data->AddArray(newArray<vtkUnsignedLongLongArray>("Large", n, 1, [&] { return random.bits(); }));
      break;
    default:
      data->AddArray(newArray<vtkSignedCharArray>(nullptr, n, 2, [&] { return random.integer(-9, 9); }));
      break;
  }
}

} // namespace

void addArrays(Random& random, vtkPolyData* data)
{
  for (int n = random.integer(0, 4); n > 0; --n)
  {
    addArray(random, data->GetPointData(), data->GetNumberOfPoints());
  }
  for (int n = random.integer(0, 3); n > 0; --n)
  {
    addArray(random, data->GetCellData(), data->GetNumberOfCells());
  }
  const bool smallWeights = random.chance(0.8);
  if (random.chance(0.3))
  {
    data->GetPointData()->AddArray(newArray<vtkDoubleArray>("AreaWeight",
      data->GetNumberOfPoints(),
      1,
      [&] { return smallWeights ? random.logUniform(0.25, 4.0) : random.logUniform(1e-12, 1e12); }));
  }
}

void addGhosts(Random& random, vtkPolyData* data)
{
  const double share = random.uniform(0.0, 0.5);
  const bool ofPoints = random.chance(0.3);
  vtkDataSetAttributes* attributes = data->GetCellData();
  vtkIdType tuples = data->GetNumberOfCells();
  unsigned char flag = vtkDataSetAttributes::DUPLICATECELL;
  if (ofPoints)
  {
    attributes = data->GetPointData();
    tuples = data->GetNumberOfPoints();
    flag = vtkDataSetAttributes::DUPLICATEPOINT;
  }
  if (random.chance(0.3))
  {
    flag = ofPoints ? static_cast<unsigned char>(vtkDataSetAttributes::HIDDENPOINT)
                    : static_cast<unsigned char>(vtkDataSetAttributes::HIDDENCELL);
  }
  attributes->AddArray(newArray<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(),
    tuples,
    1,
    [&] { return random.chance(share) ? flag : static_cast<unsigned char>(0); }));
}

} // namespace fuzz
