// SPDX-License-Identifier: GPL-3.0-or-later
/// Random changes of a surface that filters must survive.
#pragma once

#include "../Random.h"
#include "../Soup.h"

class vtkPolyData;

namespace fuzz
{

/// Multiplies the coordinates by 1e-300 to 1e300, by a power of two or of ten.
void scale(Random& random, Soup& soup);
/// Moves the surface by up to 1e15 times its size.
void offset(Random& random, Soup& soup);
/// Makes some coordinates NaN or infinite.
void spoilCoordinates(Random& random, Soup& soup);
/// Repeats and reverses faces.
void repeatFaces(Random& random, Soup& soup);
/// Gives faces copies of their points, exact or moved a little.
void repeatPoints(Random& random, Soup& soup);
/// Removes faces.
void removeFaces(Random& random, Soup& soup);
/// Adds vertices, lines and points that no cell uses.
void addOtherCells(Random& random, Soup& soup);
/// Moves points at random.
void shake(Random& random, Soup& soup);

/// Adds arrays of many types, among them the weights, labels and ghosts that filters read.
void addArrays(Random& random, vtkPolyData* data);
/// Adds an array of ghost points or ghost cells.
void addGhosts(Random& random, vtkPolyData* data);

} // namespace fuzz
