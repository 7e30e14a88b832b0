// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/FlatMapPixels.h"
#include "Support/SampleSurfaces.h"

#include <cmath>
#include <set>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// A sheet with a hole and a bay, so that a row of pixels leaves the map and comes back to it.
TriangleMesh sheetWithBay()
{
  const TriangleMesh whole = rectangleGrid(13, 13, 2.0);
  std::set<int> gone;
  for (int f = 0; f < whole.faceCount(); ++f)
  {
    const Eigen::RowVector3d centre =
      (whole.Vertices.row(whole.Faces(f, 0)) + whole.Vertices.row(whole.Faces(f, 1)) +
        whole.Vertices.row(whole.Faces(f, 2))) /
      3.0;
    const bool inBay = centre.x() > 0.2 && std::abs(centre.y()) < 0.3;
    const bool inHole = std::abs(centre.x() + 0.5) < 0.3 && std::abs(centre.y() - 0.4) < 0.3;
    if (inBay || inHole)
    {
      gone.insert(f);
    }
  }
  return withoutFaces(whole, gone);
}

// Every pixel as if it were looked up alone, whatever is filled beyond the map.
TEST(FlatMapPixels, EveryPixelIsWhatItIsAlone)
{
  const TriangleMesh sheet = sheetWithBay();
  const FlatMapLocation map(sheet, sheet.Vertices.leftCols<2>());
  constexpr int Side = 150;
  const double length = 4.2 / Side; // half of the square lies around the sheet
  const PixelGrid grid{ Eigen::RowVector2d(-2.1, -1.9), length, Side, Side };
  for (const double reach : { 0.0, 0.5 * length, 2.0 * length, 20.0 * length, 10.0 })
  {
    const std::vector<MapPlace> places = placesOfPixels(map, grid, reach);
    ASSERT_EQ(places.size(), static_cast<std::size_t>(Side * Side));
    int inside = 0;
    int beyond = 0;
    for (int i = 0; i < Side * Side; ++i)
    {
      const Eigen::RowVector2d centre =
        grid.First + length * Eigen::RowVector2d(i % Side, static_cast<double>(i / Side));
      const MapPlace alone = map.onMap(centre);
      ASSERT_EQ(places[i].Face >= 0, alone.Inside || alone.Distance <= reach)
        << "pixel " << i << " at " << alone.Distance << ", reach " << reach;
      if (places[i].Face >= 0)
      {
        ASSERT_EQ(places[i].Inside, alone.Inside);
        ASSERT_LT((map.mapPoint(places[i]) - map.mapPoint(alone)).norm(), 1e-14);
        inside += alone.Inside;
        beyond += !alone.Inside;
      }
    }
    const double area = faceAreas(sheet.Vertices, sheet.Faces).sum();
    EXPECT_NEAR(inside * length * length, area, 0.02 * area);
    EXPECT_EQ(beyond > 0, reach > 0.0);
    if (reach == 10.0)
    {
      EXPECT_EQ(inside + beyond, Side * Side);
    }
  }
}

} // namespace
