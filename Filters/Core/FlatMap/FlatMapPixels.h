// SPDX-License-Identifier: GPL-3.0-or-later
/// A flat map seen through a grid of square pixels.
#pragma once

#include "Base/Progress.h"
#include "FlatMap/FlatMapLocation.h"

#include <vector>

namespace flattening
{

struct PixelGrid
{
  Eigen::RowVector2d First; ///< centre of the pixel in column 0 and row 0
  double Length;            ///< of a pixel's sides, > 0
  int Columns;
  int Rows;
};

/// The place of the map under the centre of every pixel, row by row; beyond the map the nearest place,
/// with Inside false, or the Face -1 if that is farther away than @p reach. Rows are shared out to
/// threads; the answer does not depend on how.
std::vector<MapPlace> placesOfPixels(const FlatMapLocation& map,
  const PixelGrid& grid,
  double reach,
  const ProgressCallback& progress = {});

} // namespace flattening
