// SPDX-License-Identifier: GPL-3.0-or-later
/// Copies between VTK arrays and the matrices and vectors of Core.
#pragma once

#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include <algorithm>

namespace flattening
{

/// A VTK array of one component with the given values, a vector of the standard library or of Eigen.
template <typename Array, typename Values>
vtkSmartPointer<Array> newArray(const char* name, const Values& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), vtk::DataArrayValueRange<1>(array.Get()).begin());
  return array;
}

/// A VTK array with a tuple for each row of a matrix.
template <typename Array, typename Matrix>
vtkSmartPointer<Array> newTuples(const char* name, const Matrix& rows)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(rows.cols()));
  array->SetNumberOfTuples(rows.rows());
  const auto values = rows.template reshaped<Eigen::RowMajor>();
  std::copy(values.begin(), values.end(), vtk::DataArrayValueRange(array.Get()).begin());
  return array;
}

/// The tuples of a VTK array of any type of numbers as the rows of a matrix (n x Columns).
template <int Columns>
Eigen::Matrix<double, Eigen::Dynamic, Columns, Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>
toMatrix(vtkDataArray* array)
{
  Eigen::Matrix<double, Eigen::Dynamic, Columns, Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor> rows(
    array->GetNumberOfTuples(), Columns);
  const auto values = vtk::DataArrayValueRange<Columns>(array);
  std::copy(values.begin(), values.end(), rows.data());
  return rows;
}

} // namespace flattening
