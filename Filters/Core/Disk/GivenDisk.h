// SPDX-License-Identifier: GPL-3.0-or-later
/// Surfaces that are a disk already, among them those that were cut open along a seam.
#pragma once

#include "Disk/SurfaceToDiskOptions.h"

#include <vector>

namespace flattening
{

/// Whether the triangles are a disk as they are, without merging points, and all of them have an area.
/// The two banks of a seam have points of their own then.
bool isDisk(const TriangleMesh& soup);

/// One flag per point: not 0 where a point must not be merged with those that coincide with it. All are
/// set on a disk for which no merge tolerance is asked, as merging its points would close its seams;
/// elsewhere those of @p options.Banks.
/// Empty if every point may be merged.
std::vector<char> pointsKeptApart(const TriangleMesh& soup, const SurfaceToDiskOptions& options);

/// Whether surfaceToDisk leaves the surface as it is: it is a disk that has seams or borders of an
/// earlier run (@p options.Banks), and nothing else is asked for by a cut, a point or remeshing.
bool passesUnchanged(const TriangleMesh& soup, const SurfaceToDiskOptions& options);

/// The disk itself, with the points of its seams.
DiskSurface givenDisk(const TriangleMesh& soup, const SurfaceToDiskOptions& options);

} // namespace flattening
