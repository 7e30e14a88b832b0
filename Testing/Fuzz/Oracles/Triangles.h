// SPDX-License-Identifier: GPL-3.0-or-later
/// Triangles read from polydata, and their measures in extended precision, whose exponents hold the
/// square of every double.
#pragma once

#include "../Soup.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkPolyData;

namespace fuzz
{

using Triangle = std::array<vtkIdType, 3>;

struct Triangles
{
  std::vector<Point> Points;
  std::vector<Triangle> Faces;
};

/// The triangles of polydata, with the positions of a point array of 3 components or, by default, its
/// points.
Triangles trianglesOf(vtkPolyData* data, const char* positions = nullptr);

long double areaOf(const Triangles& mesh, const Triangle& face);
long double totalArea(const Triangles& mesh);

/// Greatest squared length of a side.
long double greatestSquaredSide(const Triangles& mesh, const Triangle& face);

/// Greatest absolute value of a coordinate.
long double greatestCoordinate(const Triangles& mesh);

/// Distance of a point from the face, a triangle that may have no area.
long double distanceTo(const Triangles& mesh, const Triangle& face, const Point& point);

/// The boundary loops, each in the direction of its faces.
std::vector<std::vector<vtkIdType>> boundaryLoops(const Triangles& mesh);

/// The value of a field array of one tuple; NaN if there is none.
double figure(vtkDataObject* data, const char* name);

} // namespace fuzz
