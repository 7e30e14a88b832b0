// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/AreaApproach.h"
#include "Areas/OutlineScaffold.h"
#include "Areas/ScaffoldDescent.h"
#include "Base/Errors.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/OutlineCrossings.h"
#include "Mesh/OutlineGaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace flattening;

// A flat horseshoe of squares, each cut in two: two arms of 4 x 20 on a bridge of 9 x 4, with a gap of
// the width `gap` between the arms.
TriangleMesh horseshoe(double gap)
{
  constexpr int columns = 10; // of points: five in each arm
  constexpr int rows = 25;
  TriangleMesh mesh;
  mesh.Vertices = Points3::Zero(columns * rows, 3);
  std::vector<Eigen::RowVector3i> faces;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const int v = j * columns + i;
      mesh.Vertices.row(v) << (i < 5 ? i : i - 1 + gap), j, 0.0;
      if (i + 1 < columns && j + 1 < rows && (i != 4 || j < 4))
      {
        faces.push_back({ v, v + 1, v + columns + 1 });
        faces.push_back({ v, v + columns + 1, v + columns });
      }
    }
  }
  mesh.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    mesh.Faces.row(static_cast<Eigen::Index>(f)) = faces[f];
  }
  return mesh;
}

RefinementTerms termsOf(const TriangleMesh& mesh, double shapeWeight)
{
  RefinementTerms terms(mesh, {}, 1.0, shapeWeight);
  terms.freeBoundaryWithoutNeedles(requireDisk(mesh));
  return terms;
}

TEST(AreaApproach, MeasuresTheWayInLogarithms)
{
  const TriangleMesh mesh = horseshoe(0.5);
  const Points2 positions = mesh.Vertices.leftCols<2>();
  const Eigen::VectorXd areas = signedFaceAreas(positions, mesh.Faces);
  // Half of the target area has twice its area, the other half a half of it.
  Eigen::VectorXd targets = areas;
  double sum = 0.0;
  for (Eigen::Index f = 0; f < areas.size(); ++f)
  {
    targets[f] *= sum < 0.8 * areas.sum() ? 0.5 : 2.0; // 0.4 of 0.8 is in the first
    sum += areas[f];
  }
  const AreaApproach approach(positions, mesh.Faces, targets);
  EXPECT_NEAR(approach.distance(), std::log(2.0), 2e-3);
  EXPECT_EQ(approach.steps(), 3);
  EXPECT_TRUE(approach.targets(0.0, 7.0).isApprox(areas * (7.0 / areas.sum()), 1e-12));
  EXPECT_TRUE(approach.targets(1.0, 7.0).isApprox(targets * (7.0 / targets.sum()), 1e-12));
  const Eigen::VectorXd half = approach.targets(0.5, 1.0);
  EXPECT_NEAR(half[half.size() - 1] / half[0], 2.0 * areas[half.size() - 1] / areas[0], 1e-9);
  EXPECT_LT(AreaApproach(positions, mesh.Faces, 3.0 * areas).distance(), 1e-7);
}

TEST(OutlineScaffold, AddsTheGapsAsFacesThatKeepTheirAreas)
{
  const TriangleMesh mesh = horseshoe(0.5);
  const Points2 positions = mesh.Vertices.leftCols<2>();
  const RefinementTerms terms = termsOf(mesh, 0.01);
  const Eigen::VectorXd targets = signedFaceAreas(positions, mesh.Faces);
  const OutlineScaffold scaffold(terms, positions, targets);
  const FaceMatrix& faces = scaffold.terms().Faces;
  const Eigen::Index gaps = outlineGaps(positions, terms.Outline).rows();
  ASSERT_EQ(faces.rows(), mesh.faceCount() + gaps);
  EXPECT_EQ(faces.topRows(mesh.faceCount()), mesh.Faces);
  EXPECT_TRUE(scaffold.targets(targets).isApprox(signedFaceAreas(positions, faces), 1e-12));
  EXPECT_NEAR(scaffold.targets(targets).tail(gaps).sum(), 0.5 * 20.0, 1e-9); // of the gap
  // Each gap counts as much as a face of mean area.
  const Eigen::VectorXd counts = scaffold.counts(Eigen::VectorXd::Ones(targets.size()));
  EXPECT_TRUE((counts.array() * scaffold.targets(targets).array())
                .tail(gaps)
                .isApproxToConstant(targets.mean(), 1e-9));
}

// The outer halves of both arms are to grow, so that the arms bend towards each other. Without a
// scaffold they are stuck, and areas are off by 60 %.
TEST(ScaffoldDescent, NoPartOfTheOutlineCrossesAnother)
{
  const TriangleMesh mesh = horseshoe(0.01);
  const Points2 positions = mesh.Vertices.leftCols<2>();
  const RefinementTerms terms = termsOf(mesh, 0.01);
  Eigen::VectorXd targets = signedFaceAreas(positions, mesh.Faces);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const double x = positions(mesh.Faces(f, 0), 0);
    targets[f] *= x < 2.0 || x > 6.0 ? 3.0 : 1.0;
  }
  const Points2 map = descendInScaffold(terms, positions, targets);
  EXPECT_EQ(countFlippedFaces(map, mesh.Faces), 0);
  EXPECT_FALSE(edgesCross(map, terms.Outline));
  const Eigen::VectorXd areas = signedFaceAreas(map, mesh.Faces);
  const Eigen::ArrayXd ratios = (areas / areas.sum()).array() / (targets / targets.sum()).array();
  EXPECT_LT((ratios - 1.0).abs().mean(), 0.01);
}

// A square of 8 x 8 squares, with a point above the middle of its upper side that has two faces.
TriangleMesh squareWithATip()
{
  constexpr int points = 9; // of a side
  TriangleMesh mesh;
  mesh.Vertices = Points3::Zero(points * points + 1, 3);
  std::vector<Eigen::RowVector3i> faces;
  for (int v = 0; v < points * points; ++v)
  {
    mesh.Vertices.row(v) << v % points, v / points, 0.0;
    if (v % points + 1 < points && v / points + 1 < points)
    {
      faces.push_back({ v, v + 1, v + points + 1 });
      faces.push_back({ v, v + points + 1, v + points });
    }
  }
  constexpr int tip = points * points;
  constexpr int middle = tip - 1 - points / 2;
  mesh.Vertices.row(tip) << points / 2, points, 0.0;
  faces.push_back({ middle, tip, middle - 1 });
  faces.push_back({ middle, middle + 1, tip });
  mesh.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    mesh.Faces.row(static_cast<Eigen::Index>(f)) = faces[f];
  }
  return mesh;
}

// The start has a needle twenty edges long with the area that it is to have.
TEST(ScaffoldDescent, ANeedleOfTheOutlineBecomesShort)
{
  const TriangleMesh mesh = squareWithATip();
  const int tip = mesh.vertexCount() - 1;
  const int middle = mesh.Faces(mesh.faceCount() - 1, 0);
  Points2 start = mesh.Vertices.leftCols<2>();
  constexpr double width = 0.05;
  start(middle - 1, 0) = start(middle, 0) - width;
  start(middle + 1, 0) = start(middle, 0) + width;
  start(tip, 1) = start(middle, 1) + 1.0 / width;
  const Eigen::VectorXd targets = faceAreas(mesh.Vertices, mesh.Faces);
  ASSERT_EQ(countFlippedFaces(start, mesh.Faces), 0);
  const Points2 map = descendInScaffold(termsOf(mesh, 0.01), start, targets);
  EXPECT_LT((map.row(tip) - map.row(middle)).norm(), 1.2); // 1.0, as on the surface
}

TEST(ScaffoldDescent, CanBeCancelled)
{
  const TriangleMesh mesh = horseshoe(0.5);
  EXPECT_THROW(descendInScaffold(termsOf(mesh, 0.1),
                 mesh.Vertices.leftCols<2>(),
                 Eigen::VectorXd::Ones(mesh.faceCount()),
                 [](double fraction, const char*) { return fraction < 0.01; }),
    Cancelled);
}

} // namespace
