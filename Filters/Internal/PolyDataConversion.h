// SPDX-License-Identifier: GPL-3.0-or-later
/// Conversion between vtkPolyData and the meshes of Core, and the arrays that all filters share.
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

/// Name of the point array (double x 3, input units): where the flat point lies on the surface.
inline constexpr const char* SurfacePointsName = "SurfacePoints";
/// Name of the point array (vtkIdType): id of the same point in the input, -1 for a new point.
inline constexpr const char* OriginalPointIdsName = "vtkOriginalPointIds";
/// Name of the cell array (vtkIdType): id of the input cell that a cell is part of, -1 for a new cell.
inline constexpr const char* OriginalCellIdsName = "vtkOriginalCellIds";

/// Whether the data have neither points nor cells nor vertices of a graph.
bool isEmpty(vtkDataObject* data);

/// The positions of the points (n x 3).
Points3 pointsOf(vtkPolyData* data);

/// The points and triangles of @p data, one to one with its points and cells.
/// @throws InvalidInput if it has cells other than triangles.
TriangleMesh toTriangleMesh(vtkPolyData* data);

/// The distance from the greatest coordinate to the next number of the type in which points are stored:
/// floating point types store the coordinates to half of it.
/// @param type that of VTK, such as VTK_FLOAT.
double coordinateStep(const Points3& points, int type);

/// The surface in space of a flattened surface: its triangles with the points of its array
/// SurfacePoints.
/// @throws InvalidInput as toTriangleMesh does, and if the array is missing or does not have 3
/// components.
TriangleMesh surfaceOfFlattened(vtkPolyData* flattened);

/// Checks the surface of a filter whose parameters are lengths or areas in its units.
/// @throws InvalidInput if the surface extends over less than 2^-32 or more than 2^32 units (some 2e-10
/// and 4e9).
void requireOrdinarySize(const TriangleMesh& surface);

/// The surface in space, of an ordinary size: surfaceOfFlattened if @p data have an array SurfacePoints,
/// else toTriangleMesh.
/// @throws InvalidInput as these and requireOrdinarySize do.
TriangleMesh surfaceInSpace(vtkPolyData* data);

/// The x and y coordinates of the points (n x 2).
/// @throws InvalidInput if a point is not finite, or if z is not constant to 1e-6 of the larger of the
/// extents in x and y.
Points2 toPlanarPositions(vtkPolyData* flattened);

/// Points in double precision with z = 0.
vtkPoints* newPlanarPoints(const Points2& positions);

/// Turns active normals into plain arrays, as the normals of the surface would shade the flat map.
void deactivateNormals(vtkPolyData* flattened);

/// Sets the points, in double precision, and the triangles of @p output.
void setTriangles(vtkPolyData* output, const TriangleMesh& mesh);

/// Adds the point array SurfacePoints.
void addSurfacePoints(vtkPolyData* output, const Points3& surface);

/// Adds a point array of one component; replaces an array of that name.
void addPointArray(vtkPolyData* output, const char* name, const Eigen::VectorXd& values);

/// Stores a value as an array of one tuple in field data, where it survives composite data sets and the
/// transfer between client and server.
void setDatum(vtkFieldData* fieldData, const char* name, double value);
void setDatum(vtkFieldData* fieldData, const char* name, long long value);
void setDatum(vtkFieldData* fieldData, const char* name, const std::string& value);

/// Stores an array of point ids in field data.
void setIds(vtkFieldData* fieldData, const char* name, const std::vector<int>& ids);

} // namespace flattening
