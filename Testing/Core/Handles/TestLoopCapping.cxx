// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/LoopCapping.h"
#include "Support/SampleSurfaces.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using namespace flattening;
using namespace flattening::samples;

constexpr int LoopSize = 100;

std::vector<Eigen::Vector3d> circle()
{
  std::vector<Eigen::Vector3d> loop;
  for (int i = 0; i < LoopSize; ++i)
  {
    const double angle = 2.0 * Pi * i / LoopSize;
    loop.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  return loop;
}

struct Measured
{
  double Area = 0.0;
  double LongestEdge = 0.0;
  double WorstWeights = 0.0; // how far vertices lie from what their weights say, or weights from 1
};

Measured measure(const LoopCap& cap)
{
  const std::vector<Eigen::Vector3d> loop = circle();
  std::vector<Eigen::Vector3d> points = loop;
  points.insert(points.end(), cap.Inside.begin(), cap.Inside.end());
  Measured result;
  for (const auto& face : cap.Faces)
  {
    result.Area += // signed: the loop runs about +z
      0.5 * (points[face[1]] - points[face[0]]).cross(points[face[2]] - points[face[0]]).z();
    for (int k = 0; k < 3; ++k)
    {
      result.LongestEdge =
        std::max(result.LongestEdge, (points[face[(k + 1) % 3]] - points[face[k]]).norm());
    }
  }
  for (std::size_t i = 0; i < cap.Inside.size(); ++i)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0.0;
    for (const auto& [corner, weight] : cap.Weights[i])
    {
      sum += weight * loop[corner];
      weights += weight;
    }
    result.WorstWeights =
      std::max({ result.WorstWeights, std::abs(weights - 1.0), (sum - cap.Inside[i]).norm() });
  }
  return result;
}

// Points on a straight line there and back, along x or not.
std::vector<Eigen::Vector3d> pressedLoop(const Eigen::Vector3d& along, double noise)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-noise, noise);
  std::vector<Eigen::Vector3d> loop;
  for (int i = 0; i < 13; ++i)
  {
    const double t = std::cos(2.0 * Pi * i / 13.0);
    loop.emplace_back(Eigen::Vector3d(-115.278, -121.331, 59.5) + t * along +
                      Eigen::Vector3d(0.0, off(random), off(random)));
  }
  return loop;
}

// The centre of such a loop lies off the line by rounding alone.
TEST(LoopCapping, ALoopOnALineHasACone)
{
  for (const Eigen::Vector3d& along :
    { Eigen::Vector3d(0.9, 0.0, 0.0), Eigen::Vector3d(0.0, 0.0, 0.9), Eigen::Vector3d(0.3, -0.7, 0.5) })
  {
    const LoopCap cap = coneCap(pressedLoop(along, 0.0));
    EXPECT_EQ(cap.Faces.size(), 13u);
    EXPECT_EQ(cap.Inside.size(), 1u);
  }
  for (const double noise : { 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1e-1 })
  {
    const LoopCap cap = coneCap(pressedLoop({ 0.9, 0.0, 0.0 }, noise));
    EXPECT_EQ(cap.Faces.size(), 11 + 2 * cap.Inside.size()) << "a disk, with noise " << noise;
  }
}

TEST(LoopCapping, CoversACircle)
{
  const double area = 0.5 * LoopSize * std::sin(2.0 * Pi / LoopSize);
  for (const auto& makeCap : { spanningCap, coneCap })
  {
    const LoopCap cap = makeCap(circle());
    const Measured found = measure(cap);
    EXPECT_NEAR(found.Area, area, 1e-12);
    EXPECT_LT(found.WorstWeights, 1e-9);
    EXPECT_EQ(cap.Faces.size(), LoopSize - 2 + 2 * cap.Inside.size()); // a disk
  }
}

// A cap that spans the loop must not have faces as large as the loop.
TEST(LoopCapping, HasVerticesAsCloseAsTheLoopsAre)
{
  const double side = 2.0 * std::sin(Pi / LoopSize);
  EXPECT_LT(measure(spanningCap(circle())).LongestEdge, 4.0 * side);
}

// Around a circle many triangulations are equally good, and among them CGAL's search in a Delaunay
// triangulation chooses by addresses. The circle is one of a torus, whose caps differed.
TEST(LoopCapping, GivesTheSameWhereverMemoryIsAllocated)
{
  constexpr int Size = 24;
  const Eigen::Vector3d outwards(std::cos(0.2 * Pi), std::sin(0.2 * Pi), 0.0);
  std::vector<Eigen::Vector3d> loop;
  for (int i = 0; i < Size; ++i)
  {
    const double angle = 0.5 * Pi + 2.0 * Pi * i / Size;
    loop.emplace_back((2.0 + 0.5 * std::cos(angle)) * outwards);
    loop.back().z() = 0.5 * std::sin(angle);
  }
  const LoopCap first = spanningCap(loop);
  std::mt19937 random(5);
  std::vector<std::vector<char>> blocks(1000);
  for (int repetition = 0; repetition < 200; ++repetition)
  {
    for (int i = 0; i < 1000; ++i)
    {
      blocks[random() % blocks.size()] =
        std::vector<char>(random() % (random() % 20 == 0 ? 50000 : 500));
    }
    const LoopCap again = spanningCap(loop);
    ASSERT_EQ(again.Inside, first.Inside);
    ASSERT_EQ(again.Weights, first.Weights);
    ASSERT_EQ(again.Faces, first.Faces);
  }
}

// An isovalue that is a value of the volume makes loops without area.
TEST(LoopCapping, OfALoopWithoutAreaIsADisk)
{
  const Eigen::Vector3d a(41.0, 32.0, 29.0);
  const Eigen::Vector3d b(42.0, 32.0, 29.0);
  for (const auto& loop : { std::vector<Eigen::Vector3d>(6, a),
         std::vector<Eigen::Vector3d>{ a, b, 0.5 * (a + b) },
         std::vector<Eigen::Vector3d>{ a, 0.25 * a + 0.75 * b, b, 0.5 * (a + b) } })
  {
    const LoopCap cap = coneCap(loop);
    EXPECT_EQ(cap.Faces.size(), loop.size() - 2 + 2 * cap.Inside.size());
    ASSERT_EQ(cap.Weights.size(), cap.Inside.size());
    for (std::size_t i = 0; i < cap.Inside.size(); ++i)
    {
      EXPECT_NEAR((cap.Inside[i] - a).dot(b - a), 0.5, 0.5);
      double weights = 0.0;
      for (const auto& [corner, weight] : cap.Weights[i])
      {
        weights += weight;
      }
      EXPECT_NEAR(weights, 1.0, 1e-12);
    }
    const LoopCap spanning = spanningCap(loop); // may be empty
    EXPECT_EQ(
      spanning.Faces.empty() ? 0 : loop.size() - 2 + 2 * spanning.Inside.size(), spanning.Faces.size());
  }
}

} // namespace
