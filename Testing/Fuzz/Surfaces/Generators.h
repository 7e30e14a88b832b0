// SPDX-License-Identifier: GPL-3.0-or-later
/// Surfaces of random shape. Each function makes about the given number of faces.
#pragma once

#include "../Random.h"
#include "../Soup.h"

namespace fuzz
{

/// Isosurfaces of a sum of random waves: several components, handles, boundaries at the box.
Soup smoothIsosurface(Random& random, int faces);
/// Isosurfaces of white noise.
Soup noiseIsosurface(Random& random, int faces);
/// Faces between voxels above and below a threshold, as squares or triangles.
Soup voxelFaces(Random& random, int faces);

/// Planar meshes, uneven and stretched up to a million times in one direction, some with holes.
Soup stretchedPlane(Random& random, int faces);
/// Planar meshes with points pressed to the edges across them: needles and caps of all degrees.
Soup needlesAndCaps(Random& random, int faces);

/// Tubes, open or closed, pressed until opposite sides nearly or exactly touch.
Soup pressedTube(Random& random, int faces);
/// Spheres with thin and long protrusions.
Soup horns(Random& random, int faces);
/// Coarse closed spheres and ellipsoids.
Soup closedSphere(Random& random, int faces);
/// Tori of all proportions, some with a hole.
Soup torus(Random& random, int faces);

/// Pages that share a spine: edges of more than two faces.
Soup book(Random& random, int faces);
/// Patches whose common side is divided differently: T-junctions.
Soup cracks(Random& random, int faces);
/// A Moebius strip or a Klein bottle.
Soup oneSided(Random& random, int faces);
/// Triangles between random points.
Soup randomTriangles(Random& random, int faces);
/// None to four faces, also with repeated corners.
Soup tiny(Random& random, int faces);
/// Polygons and strips, also with points in the middle of straight sides.
Soup polygonsAndStrips(Random& random, int faces);

} // namespace fuzz
