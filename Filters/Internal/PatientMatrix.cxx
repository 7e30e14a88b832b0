// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/PatientMatrix.h"

#include "Core/Base/Errors.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>

#include <cmath>
#include <string>

namespace flattening
{
namespace
{

// The least volume of a voxel's image, relative to the product of the lengths of its edges, at which a
// matrix can be inverted with ten digits. Sheared scans have 0.5 and more; a matrix with two axes that
// are parallel in single precision has 1e-7. A greater value would refuse matrices that are merely odd.
constexpr double LeastVolume = 1e-6;

Eigen::Affine3d coordinatesToPatient(vtkDataObject* data)
{
  return inPatientSpace(data) ? Eigen::Affine3d::Identity() : *patientMatrix(data);
}

} // namespace

std::optional<Eigen::Affine3d> patientMatrix(vtkDataObject* data)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(PatientMatrixName);
  if (!array)
  {
    return std::nullopt;
  }
  if (array->GetNumberOfComponents() * array->GetNumberOfTuples() != 16)
  {
    throw InvalidInput("the field array PatientMatrix does not have 16 numbers: read the scan again");
  }
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 16; ++i)
  {
    matrix(i / 4, i % 4) =
      array->GetComponent(i / array->GetNumberOfComponents(), i % array->GetNumberOfComponents());
  }
  if (!matrix.allFinite() || matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
  {
    throw InvalidInput("the field array PatientMatrix is no place in the patient: its numbers must be "
                       "finite, and its last row 0 0 0 1");
  }
  const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>();
  if (!(std::abs(linear.determinant()) > LeastVolume * linear.colwise().norm().prod()))
  {
    throw InvalidInput(
      "the field array PatientMatrix is singular: it would make the surface flat. Correct "
      "the orientation in the header of the scan");
  }
  return Eigen::Affine3d(matrix);
}

bool inPatientSpace(vtkDataObject* data)
{
  vtkDataArray* flag = data->GetFieldData()->GetArray(InPatientSpaceName);
  return flag && flag->GetNumberOfTuples() > 0 && flag->GetTuple1(0) != 0.0;
}

Eigen::Affine3d surfaceToVolume(vtkDataObject* surface, vtkDataObject* volume)
{
  const std::optional<Eigen::Affine3d> ofSurface = patientMatrix(surface);
  const std::optional<Eigen::Affine3d> ofVolume = patientMatrix(volume);
  const bool surfaceInPatient = inPatientSpace(surface);
  const bool volumeInPatient = inPatientSpace(volume);
  if (surfaceInPatient && !volumeInPatient && !ofVolume)
  {
    throw InvalidInput(
      "the surface is in patient space, and the volume does not say where it lies in the "
      "patient: read it with a reader of Surface Flattening");
  }
  if (surfaceInPatient && volumeInPatient)
  {
    return Eigen::Affine3d::Identity();
  }
  const bool bothKnown = (surfaceInPatient || ofSurface) && (volumeInPatient || ofVolume);
  const bool sameVoxels = ofSurface && ofVolume && surfaceInPatient == volumeInPatient &&
                          ofSurface->matrix() == ofVolume->matrix();
  if (!bothKnown || sameVoxels)
  {
    return Eigen::Affine3d::Identity();
  }
  return coordinatesToPatient(volume).inverse(Eigen::Affine) * coordinatesToPatient(surface);
}

} // namespace flattening
