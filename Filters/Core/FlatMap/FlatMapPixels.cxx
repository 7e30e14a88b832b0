// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/FlatMapPixels.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace flattening
{
namespace
{

// The number of rows between two reports of progress, at which an abort is noticed.
constexpr int RowsPerReport = 64;

// The number of pixels after one at a given distance from the map that must be beyond @p reach, too:
// from one pixel to the next the distance changes by at most a pixel.
int pixelsBeyond(double distance, double reach, double pixel)
{
  constexpr double Rounding =
    1e-6; // of a pixel; one pixel too few costs a search, one too many an error
  return static_cast<int>(std::min(std::max((distance - reach) / pixel - Rounding, 0.0), 1e9));
}

void fillRow(const FlatMapLocation& map, const PixelGrid& grid, int row, double reach, MapPlace* places)
{
  int near = -1;
  for (int column = 0; column < grid.Columns; ++column)
  {
    const Eigen::RowVector2d centre =
      grid.First +
      grid.Length * Eigen::RowVector2d(static_cast<double>(column), static_cast<double>(row));
    MapPlace place = near < 0 ? map.onMap(centre) : map.onMap(centre, near);
    near = place.Face;
    int last = column;
    if (!place.Inside && place.Distance > reach)
    {
      place.Face = -1;
      last += std::min(pixelsBeyond(place.Distance, reach, grid.Length), grid.Columns - 1 - column);
    }
    std::fill(places + column, places + last + 1, place);
    column = last;
  }
}

} // namespace

std::vector<MapPlace> placesOfPixels(const FlatMapLocation& map,
  const PixelGrid& grid,
  double reach,
  const ProgressCallback& progress)
{
  std::vector<MapPlace> places(static_cast<std::size_t>(grid.Columns) * grid.Rows);
  for (int begin = 0; begin < grid.Rows; begin += RowsPerReport)
  {
    report(progress, static_cast<double>(begin) / grid.Rows, "Looking up the pixels");
    tbb::parallel_for(begin,
      std::min(begin + RowsPerReport, grid.Rows),
      [&](int row)
      { fillRow(map, grid, row, reach, places.data() + static_cast<std::size_t>(row) * grid.Columns); });
  }
  return places;
}

} // namespace flattening
