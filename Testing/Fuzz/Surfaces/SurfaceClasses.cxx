// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceClasses.h"

#include "Defects.h"
#include "Generators.h"

#include <vtkPolyData.h>

#include <functional>
#include <stdexcept>

namespace fuzz
{
namespace
{

using Generator = Soup (*)(Random&, int);
using Defect = void (*)(Random&, Soup&);

struct SurfaceClass
{
  std::string Name;
  Generator Make;
  Defect Spoil = nullptr; // what makes the class special
};

Soup severalComponents(Random& random, int faces);
Soup anySurface(Random& random, int faces);

const std::vector<Generator> Shapes = { smoothIsosurface,
  noiseIsosurface,
  voxelFaces,
  stretchedPlane,
  needlesAndCaps,
  pressedTube,
  horns,
  closedSphere,
  torus,
  polygonsAndStrips };

const std::vector<Defect> Defects = { repeatFaces, repeatPoints, removeFaces, addOtherCells, shake };

void spoil(Random& random, Soup& soup)
{
  for (int n = random.integer(1, 3); n > 0; --n)
  {
    random.pick(Defects)(random, soup);
  }
}

void makeSinglePrecision(Random& random, Soup& soup)
{
  if (random.chance(0.5))
  {
    offset(random, soup);
  }
  soup.SinglePrecision = true;
}

void nothing(Random&, Soup&) {}

const std::vector<SurfaceClass> Classes = { { "smooth", smoothIsosurface },
  { "noise", noiseIsosurface },
  { "voxels", voxelFaces },
  { "planes", stretchedPlane },
  { "slivers", needlesAndCaps },
  { "tubes", pressedTube },
  { "horns", horns },
  { "spheres", closedSphere },
  { "tori", torus },
  { "books", book },
  { "cracks", cracks },
  { "one-sided", oneSided },
  { "random-triangles", randomTriangles },
  { "tiny", tiny },
  { "polygons", polygonsAndStrips },
  { "components", severalComponents },
  { "scaled", anySurface, scale },
  { "far-away", anySurface, offset },
  { "not-finite", anySurface, spoilCoordinates },
  { "single-precision", anySurface, makeSinglePrecision },
  { "damaged", anySurface, spoil },
  { "arrays", anySurface, nothing },
  { "ghosts", anySurface, nothing } };

Soup anySurface(Random& random, int faces)
{
  return random.pick(Shapes)(random, faces);
}

Soup severalComponents(Random& random, int faces)
{
  const int parts = random.integer(2, 6);
  const double distance = random.logUniform(0.1, 10.0);
  Soup soup;
  for (int n = 0; n < parts; ++n)
  {
    Soup part = anySurface(random, std::max(8, faces / parts));
    const double size = distance * sizeOf(part);
    const Point move = { size * random.normal(), size * random.normal(), size * random.normal() };
    for (Point& point : part.Points)
    {
      for (int k = 0; k < 3; ++k)
      {
        point[k] += move[k];
      }
    }
    append(soup, part);
  }
  return soup;
}

int randomFaces(Random& random)
{
  const double share = random.uniform();
  return static_cast<int>(share < 0.01   ? random.logUniform(3000.0, 20000.0)
                          : share < 0.05 ? random.logUniform(500.0, 3000.0)
                          : share < 0.1  ? random.logUniform(4.0, 50.0)
                                         : random.logUniform(50.0, 500.0));
}

} // namespace

const std::vector<std::string>& surfaceClasses()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> all;
    for (const SurfaceClass& one : Classes)
    {
      all.push_back(one.Name);
    }
    return all;
  }();
  return names;
}

vtkSmartPointer<vtkPolyData> makeSurface(const std::string& surfaceClass, Random& random)
{
  for (const SurfaceClass& one : Classes)
  {
    if (one.Name == surfaceClass)
    {
      Soup soup = one.Make(random, randomFaces(random));
      if (one.Spoil)
      {
        one.Spoil(random, soup);
      }
      if (random.chance(0.1))
      {
        spoil(random, soup);
      }
      auto data = toPolyData(soup);
      if (surfaceClass == "arrays" || random.chance(0.05))
      {
        addArrays(random, data);
      }
      if (surfaceClass == "ghosts" || random.chance(0.01))
      {
        addGhosts(random, data);
      }
      return data;
    }
  }
  throw std::invalid_argument("there is no class of surfaces \"" + surfaceClass + "\"");
}

} // namespace fuzz
