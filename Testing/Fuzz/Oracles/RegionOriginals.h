// SPDX-License-Identifier: GPL-3.0-or-later
/// The output of Flatten Region, and whether its points and cells are those of the input.
#pragma once

#include "../Findings.h"
#include "FaceSets.h"

#include <optional>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace fuzz
{

struct Region
{
  Triangles Surface;               ///< all faces of the input, in space
  Triangles Space;                 ///< the output in space
  Triangles Flat;                  ///< the output in the plane
  std::vector<vtkIdType> PointIds; ///< for each point of the output, its original or -1
  std::vector<vtkIdType> CellIds;  ///< for each cell of the output, its original
  FaceSet InRegion;                ///< the faces of the output that are not in its margin
};

/// Reads the output. Nothing, with a failure, if an array is missing or a cell has no original.
std::optional<Region> readRegion(vtkPolyData* output, vtkPolyData* input, Findings& findings);

/// Whether the points lie where their originals do, and the cells are their originals or fill them.
void checkIds(const Region& region, Findings& findings);

/// Whether the points have the labels of their originals, and texture coordinates that are their places
/// in the smallest square around the map.
void checkPointValues(const Region& region,
  vtkPolyData* output,
  vtkDataArray* labels,
  Findings& findings);

} // namespace fuzz
