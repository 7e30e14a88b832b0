// SPDX-License-Identifier: GPL-3.0-or-later
/// Stage 1 of the flattening: any set of triangles becomes one clean, oriented disk, which all other
/// stages ask for.
#pragma once

#include "Base/Progress.h"
#include "Disk/SurfaceToDiskOptions.h"
#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// Makes a disk in these steps: repairs the triangles (repairTriangleSoup), keeps one component, orients
/// it outward (orientOutward), flattens spikes and fins (flattenSpikesAndFins), keeps one side of a
/// plane if asked, fills all boundaries but one (fillHoles), removes handles (removeHandles), remeshes
/// if asked (remeshIsotropically), opens the surface by a hole, a seam or a cut graph (openSurface), and
/// checks the result (requireDisk).
///
/// A boundary shorter than the boundary of the hole that would be cut is filled too, and the surface is
/// opened there: so short a boundary cannot become that of the flat disk. A boundary of the input gets 8
/// vertices at least (refineBoundary), or Hole.BoundaryVertices if these are fewer.
/// @throws InvalidInput for coordinates that are not finite, zero area, and options that are out of
/// range or name a missing component, point or plane; TopologyError if the component is one-sided, or
/// has handles and these are errors; Cancelled.
DiskSurface surfaceToDisk(const TriangleMesh& soup,
  const SurfaceToDiskOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
