// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Disk/LabelCut.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// Flags of the faces at whose centroids the condition holds.
std::vector<char> facesWith(const TriangleMesh& mesh,
  const std::function<bool(const Eigen::RowVector3d&)>& condition)
{
  std::vector<char> flags(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    flags[f] = condition(faceCorners(mesh, f).colwise().mean());
  }
  return flags;
}

TEST(LabelCut, RemovesTheLabelAndNothingElse)
{
  const TriangleMesh mesh = sphere(4);
  const LabelCutSurface cut = cutLabel(mesh, facesWith(mesh, [](const auto& x) { return x.z() > 0.5; }));
  EXPECT_EQ(requireDisk(cut.Surface.Mesh), cut.Boundary);
  EXPECT_NEAR(cut.RemovedArea, Pi, 0.05); // a cap of height 1/2
  EXPECT_NEAR(cut.RemovedArea + totalArea(cut.Surface.Mesh), totalArea(mesh), 1e-12);
  for (const int v : cut.Boundary)
  {
    EXPECT_NEAR(cut.Surface.Mesh.Vertices(v, 2), 0.5, 0.15);
  }
}

// The rest of the face at a corner hangs on at a vertex alone.
TEST(LabelCut, LooseFacesGoToo)
{
  const TriangleMesh mesh = sphere(3);
  std::vector<char> labelled = facesWith(mesh, [](const auto& x) { return x.z() > 0.3; });
  int spared = 0;
  for (int f = 0; f < mesh.faceCount() && spared == 0; ++f)
  {
    if (faceCorners(mesh, f).col(2).minCoeff() > 0.7)
    {
      labelled[f] = 0; // an island inside of the label
      spared = f;
    }
  }
  EXPECT_TRUE(contains(messageOf<TopologyError>([&] { cutLabel(mesh, labelled); }), "2 pieces"));

  const std::vector<char> plain = facesWith(mesh, [](const auto& x) { return x.z() > 0.3; });
  const LabelCutSurface whole = cutLabel(mesh, plain);
  // A face that shares only a vertex with the rest.
  labelled = plain;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    int shared = 0;
    for (int k = 0; k < 3; ++k)
    {
      for (const int v : whole.Boundary)
      {
        shared += whole.Surface.Mesh.Vertices.row(v) == mesh.Vertices.row(mesh.Faces(f, k)) ? 1 : 0;
      }
    }
    if (plain[f] && shared == 1)
    {
      labelled[f] = 0;
      break;
    }
  }
  const LabelCutSurface cut = cutLabel(mesh, labelled);
  requireDisk(cut.Surface.Mesh);
  EXPECT_LE(totalArea(cut.Surface.Mesh), totalArea(whole.Surface.Mesh));
}

TEST(LabelCut, RejectsLabelsWithoutOneBorder)
{
  const TriangleMesh mesh = sphere(3);
  const auto rejection = [&mesh](const std::function<bool(const Eigen::RowVector3d&)>& condition)
  { return messageOf<TopologyError>([&] { cutLabel(mesh, facesWith(mesh, condition)); }); };
  EXPECT_TRUE(contains(rejection([](const auto&) { return true; }), "whole surface"));
  EXPECT_TRUE(contains(rejection([](const auto& x) { return std::abs(x.z()) > 0.7; }), "label is in 2"));
  EXPECT_TRUE(
    contains(rejection([](const auto& x) { return std::abs(x.z()) < 0.3; }), "without the label"));
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { cutLabel(mesh, std::vector<char>(mesh.faceCount(), 0)); }),
      "no face has the label"));
  // A part of a ring: the rest is connected, but its border has two loops.
  const TriangleMesh ring = torus(24, 12);
  EXPECT_TRUE(
    contains(messageOf<TopologyError>(
               [&]
               {
                 cutLabel(ring,
                   facesWith(ring, [](const auto& x) { return x.x() > 0.0 && std::abs(x.y()) < 0.5; }));
               }),
      "2 loops"));
}

} // namespace
