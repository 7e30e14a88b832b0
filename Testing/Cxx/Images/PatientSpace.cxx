// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkPatientSpace.h>

#include <vtkDoubleArray.h>
#include <vtkNew.h>

#include <Eigen/Geometry>

#include <string>

namespace
{

using namespace flattening::analytic;
using namespace flattening::testing;

using RowMatrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

// A hill whose voxels are stored from right to left, sheared, and turned by 20 degrees.
RowMatrix placement(double side = -1.0)
{
  Eigen::Affine3d affine = Eigen::Translation3d(0.2, -0.1, 5.0) *
                           Eigen::AngleAxisd(0.35, Eigen::Vector3d(1, 2, 3).normalized());
  Eigen::Matrix3d voxels = Eigen::Matrix3d::Identity();
  voxels(0, 0) = side;
  voxels(0, 2) = 0.4;
  affine.linear() *= voxels;
  return affine.matrix();
}

vtkSmartPointer<vtkPolyData> hillWith(const RowMatrix& matrix)
{
  auto data = polyDataOf(sunflowerMesh(gaussianBump(0.7, 0.35), 1500).Mesh);
  addTiles(data, 0.25);
  vtkNew<vtkDoubleArray> array;
  array->SetName("PatientMatrix");
  array->SetNumberOfComponents(16);
  array->InsertNextTuple(matrix.data());
  data->GetFieldData()->AddArray(array);
  return data;
}

// Faces that are turned the wrong way are not drawn.
Image imageOfTiles(vtkPolyData* data)
{
  colourBy(data, "Tile", 0.0, 8.0);
  View view;
  view.Centre = { 0.2, -0.1, 5.0 };
  view.HalfHeight = 1.2;
  return imageOf(data, view);
}

TEST(PatientSpace, CarriesAMirroredScanToWhereItsHeaderSays)
{
  const vtkSmartPointer<vtkPolyData> hill = hillWith(placement());
  vtkNew<vtkPatientSpace> filter;
  filter->SetInputData(hill);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  expectBaseline(imageOfTiles(output), "PatientSpace");
  for (vtkIdType i = 0; i < hill->GetNumberOfPoints(); ++i)
  {
    const Eigen::Vector3d expected =
      (placement() * Eigen::Vector3d(hill->GetPoint(i)).homogeneous()).head<3>();
    ASSERT_LT((Eigen::Vector3d(output->GetPoint(i)) - expected).norm(), 1e-12);
  }
  EXPECT_EQ(figure(output, "InPatientSpace"), 1.0);

  const std::string name = "PatientSpace";
  filter->SetInputData(hillWith(placement(1.0)));
  filter->Update();
  expectNotBaseline(imageOfTiles(filter->GetOutput()), name, "left for right");
  RowMatrix straight = placement();
  straight.topLeftCorner<3, 3>() = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  filter->SetInputData(hillWith(straight));
  filter->Update();
  expectNotBaseline(imageOfTiles(filter->GetOutput()), name, "the turn left out");
  const vtkSmartPointer<vtkPolyData> insideOut = vtkSmartPointer<vtkPolyData>::New();
  insideOut->DeepCopy(hill);
  insideOut->SetPoints(output->GetPoints());
  expectNotBaseline(imageOfTiles(insideOut), name, "faces not turned");
}

} // namespace
