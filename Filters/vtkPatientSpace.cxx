// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPatientSpace.h"

#include "Internal/ArrayConversion.h"
#include "Internal/FilterExecution.h"
#include "Internal/MovedPolyData.h"
#include "Internal/PatientMatrix.h"
#include "Internal/PolyDataConversion.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <optional>

vtkStandardNewMacro(vtkPatientSpace);

using flattening::InvalidInput;

void vtkPatientSpace::Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  flattening::report(flattening::progressOf(this), 0.0, "Moving to patient space");
  const std::optional<Eigen::Affine3d> toPatient = flattening::patientMatrix(input);
  output->ShallowCopy(input);
  if (flattening::inPatientSpace(input))
  {
    return;
  }
  if (!toPatient)
  {
    vtkWarningMacro(
      << this->GetBlockPrefix()
      << "there is no field array PatientMatrix, so the surface stays as it is, and its left "
         "and right are as the file has them: read the scan with a reader of Surface "
         "Flattening, which says whether the file has an orientation");
    return;
  }
  if (input->GetPointData()->HasArray(flattening::SurfacePointsName))
  {
    throw InvalidInput("this is a flat map, whose points are not in space: apply Patient Space to the "
                       "surface, before Surface To Disk");
  }
  flattening::movePolyData(output, *toPatient);
  flattening::setDatum(output->GetFieldData(), flattening::InPatientSpaceName, 1LL);
  flattening::report(flattening::progressOf(this), 1.0, "Done");
}
