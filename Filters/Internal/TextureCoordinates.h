// SPDX-License-Identifier: GPL-3.0-or-later
/// Texture coordinates of flat maps, and the square of the plane that a texture covers.
#pragma once

#include "Core/Mesh/TriangleMesh.h"

class vtkPolyData;

namespace flattening
{

/// Name of the point array (float x 2), the active texture coordinates.
inline constexpr const char* TextureCoordinatesName = "TCoords";
/// Name that an array TCoords of the surface itself, such as of a photograph on it, keeps on the map.
inline constexpr const char* SurfaceTextureCoordinatesName = "SurfaceTCoords";

/// The smallest square around a flat map with the same centre: [0,1]^2 of its texture.
struct TextureSquare
{
  Eigen::RowVector2d Low; ///< its lower left corner
  double Side;
};

TextureSquare textureSquare(const Points2& positions);

/// Sets TCoords, made active, to the places of @p positions in their textureSquare. Replaces an array of
/// that name.
void setTextureCoordinates(vtkPolyData* output, const Points2& positions);

/// Renames an array TCoords to SurfaceTCoords, where @p output has those of the surface itself.
void keepSurfaceTextureCoordinates(vtkPolyData* output);

} // namespace flattening
