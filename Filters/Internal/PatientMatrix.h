// SPDX-License-Identifier: GPL-3.0-or-later
/// The place of data in the patient, from the field data that the readers of scans write.
#pragma once

#include <Eigen/Geometry>

#include <optional>

class vtkDataObject;

namespace flattening
{

/// Name of the field array (double x 16, one tuple, row by row): takes the coordinates of the scan's
/// voxels, index times size, to the patient's right, front and top in mm (RAS+).
inline constexpr const char* PatientMatrixName = "PatientMatrix";
/// Name of the field array (vtkIdType, one tuple): 1 if the points are in patient space already.
inline constexpr const char* InPatientSpaceName = "InPatientSpace";

/// The map of the array PatientMatrix; none if the data have no such array.
/// @throws InvalidInput if it does not have 16 finite numbers, if its last row is not 0 0 0 1, or if it
/// is singular.
std::optional<Eigen::Affine3d> patientMatrix(vtkDataObject* data);

/// Whether the data say that they are in patient space.
bool inPatientSpace(vtkDataObject* data);

/// The map that takes points of a surface to the coordinates of a volume, by what both say of the
/// patient. It is the identity, to the last bit, for data in the same coordinates.
/// @throws InvalidInput as patientMatrix does, and if the surface is in patient space and the volume has
/// no matrix.
Eigen::Affine3d surfaceToVolume(vtkDataObject* surface, vtkDataObject* volume);

} // namespace flattening
