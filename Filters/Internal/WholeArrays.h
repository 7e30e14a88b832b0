// SPDX-License-Identifier: GPL-3.0-or-later
/// A check of the inputs of all filters.
#pragma once

class vtkInformationVector;

namespace flattening
{

/// Checks the arrays of points, cells, vertices, edges and rows, because VTK reads beyond the end of an
/// array that has fewer tuples, and the points of cells of surfaces, because VTK's readers pass on
/// those of damaged files unchecked.
/// @throws InvalidInput if an array has fewer tuples than there are elements, or if cells have points
/// that do not exist.
void requireWholeArrays(vtkInformationVector** inputs, int portCount);

} // namespace flattening
