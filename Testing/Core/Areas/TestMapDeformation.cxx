// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/DegreesOfFreedom.h"
#include "Areas/MapDeformation.h"
#include "Areas/RefinementTerms.h"
#include "Areas/ShapeDistortion.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/OutlineCrossings.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace
{

using namespace flattening;

using Place = std::function<Eigen::RowVector2d(double, double)>;

// The square of side 1 around the origin in columns x rows squares, each cut in two.
TriangleMesh squareMesh(int columns, int rows)
{
  TriangleMesh mesh = samples::rectangleGrid(columns + 1, rows + 1, std::sqrt(samples::Pi));
  mesh.Vertices /= std::sqrt(samples::Pi);
  return mesh;
}

// A flat surface and a map of it to the plane that moves its points.
struct FlatMap
{
  FlatMap(const TriangleMesh& mapped, const Place& onSurface)
    : Surface(mapped)
    , Map{ mapped.Vertices.leftCols<2>(), {} }
    , FacesOf(mapped.Faces, mapped.vertexCount())
    , Dofs(mapped.vertexCount())
  {
    for (int v = 0; v < mapped.vertexCount(); ++v)
    {
      this->Surface.Vertices.row(v).head<2>() = onSurface(mapped.Vertices(v, 0), mapped.Vertices(v, 1));
    }
    this->Targets = faceAreas(this->Surface.Vertices, this->Surface.Faces);
    const std::vector<int> loop = requireDisk(this->Surface);
    this->Terms = RefinementTerms(this->Surface, loop, 1.0, 1e-3);
    this->Terms.Intervals.clear();
    this->Terms.Outline = outlineEdges(loop);
  }

  bool deform(double areaWeight, const ProgressCallback& progress = {})
  {
    return MapDeformation(this->Surface, this->Terms, this->FacesOf, this->Dofs)
      .deform(
        this->Map, this->Targets, { DeformationEnergy::Shapes::OfSurface, areaWeight, false }, progress);
  }

  double distortion() const { return shapeDistortion(this->Terms, this->Map.Positions, this->Targets); }

  TriangleMesh Surface;
  DomainMap Map;
  VertexFaces FacesOf;
  DegreesOfFreedom Dofs;
  Eigen::VectorXd Targets;
  RefinementTerms Terms;
};

constexpr int SlitColumns = 24;
constexpr int SlitRows = 25; // odd, so that rows of squares lie on both sides of the slit's line

// The square with a slit of width 2e-5 from its right side to the third column. The vertices of the two
// banks stand opposite to the middles of the edges of the other one.
TriangleMesh slitMesh()
{
  TriangleMesh mesh = squareMesh(SlitColumns, SlitRows);
  const int row = SlitColumns + 1;
  const int below = SlitRows / 2;
  std::vector<Eigen::RowVector3i> faces;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const int first = mesh.Faces(f, 0);
    if (first / row != below || first % row < 3)
    {
      faces.push_back(mesh.Faces.row(f));
    }
  }
  mesh.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    mesh.Faces.row(static_cast<Eigen::Index>(f)) = faces[f];
  }
  const double edge = 1.0 / SlitColumns;
  for (int i = 4; i <= SlitColumns; ++i)
  {
    mesh.Vertices(below * row + i, 1) = -1e-5;
    mesh.Vertices((below + 1) * row + i, 1) = 1e-5;
    if (i < SlitColumns)
    {
      mesh.Vertices((below + 1) * row + i, 0) += 0.5 * edge;
    }
  }
  return mesh;
}

// The straight slit has to become a wave. Chords of the wave whose ends are not the same are farther
// apart than the banks, so that the deformation makes the edges of the outline cross.
TEST(MapDeformation, PartsOfTheOutlineStayApart)
{
  FlatMap map(slitMesh(),
    [](double x, double y) { return Eigen::RowVector2d(x, y + 0.05 * std::sin(4.0 * EIGEN_PI * x)); });
  ASSERT_FALSE(edgesCross(map.Map.Positions, map.Terms.Outline));
  const double before = map.distortion();
  ASSERT_TRUE(map.deform(30.0));
  EXPECT_EQ(countFlippedFaces(map.Map.Positions, map.Surface.Faces), 0);
  EXPECT_FALSE(edgesCross(map.Map.Positions, map.Terms.Outline));
  EXPECT_LT(map.distortion(), 0.2 * before);
}

// These waves have twenty times the height and a quarter of the length. The whole deformation is tried
// in vain, and then a part of it is taken.
TEST(MapDeformation, ProgressGrowsWhereASmallerShareIsTaken)
{
  FlatMap map(slitMesh(),
    [](double x, double y) { return Eigen::RowVector2d(x, y + std::sin(16.0 * EIGEN_PI * x)); });
  std::vector<double> fractions;
  map.deform(30.0,
    [&](double fraction, const char*)
    {
      fractions.push_back(fraction);
      return true;
    });
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GT(fractions.back(), 0.8);
  EXPECT_LE(fractions.back(), 1.0);
}

} // namespace
