// SPDX-License-Identifier: GPL-3.0-or-later
/// Between vtkPolyData and Core's plain meshes, and the arrays that the filters agree on.
#pragma once

#include "Core/Mesh/TriangleMesh.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkFieldData;
class vtkPoints;
class vtkPolyData;

namespace flattening
{

/// Name of the point array (double x 3, input units) that says where each flattened point came from.
inline constexpr const char* SurfacePointsName = "SurfacePoints";

/// True if there is nothing to work on: no points, no cells, no vertices of a graph.
bool isEmpty(vtkDataObject* data);

/// The triangles of @p data with its points; one to one with its points and cells.
/// @throws InvalidInput if it has cells other than triangles.
TriangleMesh toTriangleMesh(vtkPolyData* data);

/// The triangles of a flattened surface with the points of its array SurfacePoints.
/// @throws InvalidInput as toTriangleMesh, and if the array is missing or not of 3 components.
TriangleMesh surfaceOfFlattened(vtkPolyData* flattened);

/// The surface in space that @p data is or, if it has an array SurfacePoints, was flattened from.
/// @throws InvalidInput as surfaceOfFlattened.
TriangleMesh surfaceInSpace(vtkPolyData* data);

/// x and y of the points (n x 2). @throws InvalidInput if one is not finite, or if z is not constant (to
/// 1e-6 of the larger of the extents in x and y).
Points2 toPlanarPositions(vtkPolyData* flattened);

/// Points in double precision with z = 0.
vtkPoints* newPlanarPoints(const Points2& positions);

/// Keeps the arrays of normals but as plain arrays: those of the surface would shade the flat picture.
void deactivateNormals(vtkPolyData* flattened);

/// Sets @p output's SurfacePoints array from @p surface.
void addSurfacePoints(vtkPolyData* output, const Points3& surface);

/// Adds a per-point array; returns nothing, replaces an array of that name.
void addPointArray(vtkPolyData* output, const char* name, const Eigen::VectorXd& values);

/// One-tuple arrays in field data, so that figures survive composite data sets and client/server.
void setDatum(vtkFieldData* fieldData, const char* name, double value);
void setDatum(vtkFieldData* fieldData, const char* name, long long value);
void setDatum(vtkFieldData* fieldData, const char* name, const std::string& value);

/// An array of point ids in field data.
void setIds(vtkFieldData* fieldData, const char* name, const std::vector<int>& ids);

} // namespace flattening
