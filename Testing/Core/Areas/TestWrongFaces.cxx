// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/WrongFaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace
{

using namespace flattening;

// A strip of triangles: the vertices 0, 1, 2, ... in two rows, every three of them in turn a face.
FaceMatrix strip(int faces)
{
  FaceMatrix matrix(faces, 3);
  for (int f = 0; f < faces; ++f)
  {
    matrix.row(f) << f, f + 1 + f % 2, f + 2 - f % 2;
  }
  return matrix;
}

TEST(WrongFaces, AreThoseBeyondTheToleranceAndFlippedOnes)
{
  Eigen::VectorXd ratios(5);
  ratios << 1.019, 0.979, 1.5, -2.0, 1.0;
  const WrongFaces wrong(ratios, 0.02);
  EXPECT_EQ(wrong.Faces, (std::vector<int>{ 1, 2, 3 }));
  EXPECT_DOUBLE_EQ(wrong.Share, 0.6);
  EXPECT_NEAR(wrong.Distance, -std::log(0.979) + std::log(1.5) - std::log(1e-3), 1e-12);
  EXPECT_EQ(WrongFaces(Eigen::VectorXd(), 0.02).Share, 0.0);
}

TEST(WrongFaces, TheirShareIsThatOfTheWholeMap)
{
  Points2 square(4, 2);
  square << 0, 0, 1, 0, 1, 1, 0, 1;
  FaceMatrix halves(2, 3);
  halves << 0, 1, 2, 0, 2, 3;
  const Eigen::Vector2d targets(3.0, 3.0); // in other units than those of the map
  EXPECT_EQ(shareOfWrongFaces(square, halves, targets, 1e-12), 0.0);
  square(3, 1) = 1.1; // its face has 1.1 of 2.1
  EXPECT_EQ(shareOfWrongFaces(square, halves, targets, 0.045), 1.0);
  EXPECT_EQ(shareOfWrongFaces(square, halves, targets, 0.05), 0.0);
}

TEST(WrongFaces, HaveNearVerticesInRings)
{
  const FaceMatrix faces = strip(20);
  const VertexFaces facesOf(faces, 22);
  for (const int rings : { 0, 1, 3 })
  {
    const std::vector<char> isNear = verticesNear({ 10 }, faces, facesOf, rings);
    ASSERT_EQ(isNear.size(), 22u);
    // Face 10 has the vertices 10 to 12, and each ring reaches two further on either side.
    EXPECT_EQ(std::accumulate(isNear.begin(), isNear.end(), 0), 3 + 4 * rings);
    EXPECT_TRUE(isNear[10 - 2 * rings] && isNear[12 + 2 * rings]);
  }
}

} // namespace
