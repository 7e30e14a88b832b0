// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPatientSpace.h"

#include "Internal/ArrayConversion.h"
#include "Internal/FilterExecution.h"
#include "Internal/PatientMatrix.h"
#include "Internal/PolyDataConversion.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>

vtkStandardNewMacro(vtkPatientSpace);

namespace
{

using flattening::InvalidInput;
using flattening::Points3;

void movePoints(vtkPolyData* output, const Eigen::Affine3d& toPatient)
{
  const Points3 moved = (flattening::pointsOf(output) * toPatient.linear().transpose()).rowwise() +
                        toPatient.translation().transpose();
  vtkNew<vtkPoints> points;
  points->SetData(flattening::newTuples<vtkDoubleArray>("Points", moved));
  output->SetPoints(points);
}

// Normals turn by the inverse transpose, which keeps them on their side of a mirrored surface.
void turnNormals(vtkDataSetAttributes* attributes, const Eigen::Affine3d& toPatient)
{
  vtkDataArray* normals = attributes->GetNormals();
  if (!normals)
  {
    return;
  }
  Points3 turned = flattening::toMatrix<3>(normals) * toPatient.linear().inverse();
  turned.rowwise().normalize();
  attributes->SetNormals(flattening::newTuples<vtkDoubleArray>(normals->GetName(), turned));
}

} // namespace

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
  if (toPatient->linear().determinant() < 0.0)
  {
    vtkNew<vtkReverseSense> reverse;
    reverse->SetInputData(output);
    reverse->ReverseCellsOn();
    reverse->ReverseNormalsOff();
    reverse->Update();
    output->ShallowCopy(reverse->GetOutput());
  }
  movePoints(output, *toPatient);
  turnNormals(output->GetPointData(), *toPatient);
  turnNormals(output->GetCellData(), *toPatient);
  flattening::setDatum(output->GetFieldData(), flattening::InPatientSpaceName, 1LL);
  flattening::report(flattening::progressOf(this), 1.0, "Done");
}
