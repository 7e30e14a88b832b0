// SPDX-License-Identifier: GPL-3.0-or-later
/// The array that a user chose for a filter to work with.
#pragma once

#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkPolyData;

namespace flattening
{

struct ChosenArray
{
  vtkDataArray* Array = nullptr; ///< nullptr: none is chosen
  bool OnCells = false;          ///< else on points
};

/// The point or cell array of @p data, of one number each, that was set as input array to process 0 of
/// the filter (SetInputArrayToProcess). None if nothing was set, an empty name or "None".
/// @param what names the array in the message, such as "the region array".
/// @throws InvalidInput if the data have no such array, or of another number of components or tuples.
ChosenArray chosenArray(vtkAlgorithm* filter, vtkPolyData* data, const std::string& what = "the array");

} // namespace flattening
