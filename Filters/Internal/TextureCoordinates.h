// SPDX-License-Identifier: GPL-3.0-or-later
/// Texture coordinates of flat maps, and the square in the plane that a texture covers.
#pragma once

#include "Core/Mesh/TriangleMesh.h"

class vtkPolyData;

namespace flattening
{

/// Name of the point array (float x 2) of the active texture coordinates.
inline constexpr const char* TextureCoordinatesName = "TCoords";
/// Name on the map of the texture coordinates of the surface itself, such as those of a photograph.
inline constexpr const char* SurfaceTextureCoordinatesName = "SurfaceTCoords";

/// The smallest square around a flat map with the same centre. Its texture coordinates are [0,1]^2.
struct TextureSquare
{
  Eigen::RowVector2d Low; ///< lower left corner
  double Side;            ///< length of a side
};

/// The square around the given positions (n x 2).
TextureSquare textureSquare(const Points2& positions);

/// Adds the active array TCoords: the given positions (n x 2) relative to their square. Replaces an
/// array of that name.
void setTextureCoordinates(vtkPolyData* output, const Points2& positions);

/// Renames the array TCoords of the surface itself, if there is one, to SurfaceTCoords. If the surface
/// is a flat map already, which the array SurfacePoints tells, TCoords is that of the map: it is
/// removed, and SurfaceTCoords stays.
void keepSurfaceTextureCoordinates(vtkPolyData* output);

} // namespace flattening
