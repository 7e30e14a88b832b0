// SPDX-License-Identifier: GPL-3.0-or-later
/// The array that a user chose for a filter to work with.
#pragma once

#include <string>

class vtkAbstractArray;
class vtkAlgorithm;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkInformation;
class vtkPolyData;

namespace flattening
{

struct ChosenArray
{
  vtkDataArray* Array = nullptr; ///< nullptr if none is chosen
  bool OnCells = false;          ///< whether it is a cell array, else a point array
};

/// The array's name for messages.
std::string nameOf(vtkAbstractArray* array);

/// The array that is the attribute, such as the scalars, which @p choice, an input array to process,
/// names; nullptr if there is none.
vtkDataArray* chosenAttribute(vtkDataSetAttributes* attributes, vtkInformation* choice);

/// The point or cell array of one component that was set as input array to process @p index of the
/// filter (SetInputArrayToProcess). None if nothing, an empty name or "None" was set.
/// @param what name of the array in messages, such as "the region array".
/// @throws InvalidInput if the data have no such array, or if it has several components.
ChosenArray chosenArray(vtkAlgorithm* filter,
  vtkPolyData* data,
  const std::string& what = "the array",
  int index = 0);

} // namespace flattening
