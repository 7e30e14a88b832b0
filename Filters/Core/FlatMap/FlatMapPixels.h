// SPDX-License-Identifier: GPL-3.0-or-later
/// Point location on a flat map for the pixels of a grid.
#pragma once

#include "Base/Progress.h"
#include "FlatMap/FlatMapLocation.h"

#include <vector>

namespace flattening
{

struct PixelGrid
{
  Eigen::RowVector2d First; ///< centre of the pixel in column 0 and row 0
  double Length;            ///< side of a pixel, > 0
  int Columns;
  int Rows;
};

/// The place of the map under the centre of every pixel, row by row; outside the map the nearest place,
/// with Inside false, or the Face -1 if that is farther away than @p reach. Rows are distributed to
/// threads; the result does not depend on their number.
std::vector<MapPlace> placesOfPixels(const FlatMapLocation& map,
  const PixelGrid& grid,
  double reach,
  const ProgressCallback& progress = {});

} // namespace flattening
