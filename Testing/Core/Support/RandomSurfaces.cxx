// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/RandomSurfaces.h"

#include "Support/RandomShapes.h"
#include "Support/SurfaceDefects.h"

namespace flattening::samples
{
namespace
{

RandomSurface randomShape(RandomNumbers& random)
{
  switch (random.integer(0, 3))
  {
    case 0:
      return { bumpySphere(random), "bumpy sphere" };
    case 1: {
      const int rings = random.integer(1, 4);
      return { chainOfRings(random, rings), "chain of " + std::to_string(rings) + " rings" };
    }
    case 2: {
      const int smoothing = random.integer(0, 3);
      const bool padded = random.chance(0.7);
      return { noiseSurface(random, smoothing, padded),
        "noise smoothed " + std::to_string(smoothing) + " times" + (padded ? "" : ", cut off") };
    }
    default:
      return { piercedVoxels(random), "pierced voxels" };
  }
}

} // namespace

RandomSurface randomSurface(std::uint64_t seed)
{
  RandomNumbers random(seed);
  RandomSurface surface = randomShape(random);
  if (surface.Mesh.faceCount() == 0)
  {
    return surface;
  }
  const auto& defects = surfaceDefects();
  const double probability = random.integer(0, 4) / static_cast<double>(defects.size());
  for (const SurfaceDefect& defect : defects)
  {
    if (random.chance(probability))
    {
      defect.Apply(surface.Mesh, random);
      surface.Recipe += std::string(" + ") + defect.Name;
    }
  }
  shuffleAndScale(surface.Mesh, random);
  if (random.chance(1.0 / 30.0))
  {
    surface.Recipe += " + " + damage(surface.Mesh, random);
  }
  return surface;
}

} // namespace flattening::samples
