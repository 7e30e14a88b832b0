// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "FilterTest.h"

#include <vtkConformalDiskFilter.h>
#include <vtkFlatMapSlab.h>
#include <vtkPatientSpace.h>

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>

#include <Eigen/Geometry>

#include <cmath>
#include <string>

namespace
{

using namespace flattening;
using namespace flattening::testing;

using RowMatrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

constexpr double Radius = 20.0;

void setMatrix(vtkDataObject* data, const RowMatrix& matrix)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("PatientMatrix");
  array->SetNumberOfComponents(16);
  array->InsertNextTuple(matrix.data());
  data->GetFieldData()->AddArray(array);
}

// A turn by 17 degrees about a slanted axis, a shear and a shift; mirrored if @p side is -1.
RowMatrix placement(double side)
{
  Eigen::Affine3d affine = Eigen::Translation3d(-90.0, 12.5, 33.0) *
                           Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 0.5).normalized());
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(0, 2) = 0.3;
  shear(0, 0) = side;
  affine.linear() *= shear;
  return affine.matrix();
}

vtkSmartPointer<vtkPolyData> hemisphere()
{
  TriangleMesh mesh =
    analytic::sunflowerMesh(analytic::sphericalCap(0.5 * 3.14159265358979323846), 2000).Mesh;
  mesh.Vertices *= Radius;
  return polyDataOf(mesh);
}

vtkSmartPointer<vtkPolyData> placed(vtkPolyData* surface)
{
  vtkNew<vtkPatientSpace> filter;
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

Eigen::Vector3d pointOf(vtkPolyData* data, vtkIdType id)
{
  return Eigen::Vector3d(data->GetPoint(id));
}

Eigen::Vector3d faceNormal(vtkPolyData* data, vtkIdType cell)
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(cell, corners);
  const Eigen::Vector3d a = pointOf(data, corners->GetId(0));
  return (pointOf(data, corners->GetId(1)) - a).cross(pointOf(data, corners->GetId(2)) - a);
}

TEST(PatientSpace, CarriesPointsByTheMatrixAndKeepsTheOutsideOfAMirroredSurface)
{
  const vtkSmartPointer<vtkPolyData> surface = hemisphere();
  vtkNew<vtkPolyDataNormals> withNormals;
  withNormals->SetInputData(surface);
  withNormals->SplittingOff();
  withNormals->ConsistencyOff();
  withNormals->Update();
  vtkPolyData* input = withNormals->GetOutput();
  for (const double side : { 1.0, -1.0 })
  {
    SCOPED_TRACE(side);
    const RowMatrix matrix = placement(side);
    setMatrix(input, matrix);
    const vtkSmartPointer<vtkPolyData> output = placed(input);
    ASSERT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints());
    double greatest = 0.0;
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      const Eigen::Vector3d expected = (matrix * pointOf(input, i).homogeneous()).head<3>();
      greatest = std::max(greatest, (pointOf(output, i) - expected).norm());
    }
    EXPECT_LT(greatest, 1e-12);
    // Outward of the dome is away from the image of its centre, for faces and for normals.
    const Eigen::Vector3d centre = matrix.topRightCorner<3, 1>();
    vtkDataArray* normals = output->GetPointData()->GetNormals();
    ASSERT_NE(normals, nullptr);
    for (vtkIdType f = 0; f < output->GetNumberOfCells(); ++f)
    {
      const vtkIdType corner = output->GetCell(f)->GetPointId(0);
      const Eigen::Vector3d normal = faceNormal(output, f);
      EXPECT_GT(normal.dot(pointOf(output, corner) - centre), 0.0);
      EXPECT_GT(normal.dot(Eigen::Vector3d(normals->GetTuple3(corner))), 0.0);
    }
    EXPECT_EQ(figure(output, "InPatientSpace"), 1);
    // Once more it stays where it is.
    const vtkSmartPointer<vtkPolyData> again = placed(output);
    EXPECT_EQ(pointOf(again, 7), pointOf(output, 7));
  }
}

TEST(PatientSpace, AMirroredStripKeepsItsOutside)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(1, 1, 0);
  vtkNew<vtkCellArray> strip;
  strip->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  input->SetStrips(strip);
  RowMatrix matrix = RowMatrix::Identity();
  matrix(0, 0) = -1.0;
  setMatrix(input, matrix);
  const vtkSmartPointer<vtkPolyData> output = placed(input);
  ASSERT_EQ(output->GetNumberOfCells(), 2);
  EXPECT_GT(faceNormal(output, 0).z(), 0.0);
  EXPECT_GT(faceNormal(output, 1).z(), 0.0);
}

TEST(PatientSpace, WithoutAMatrixTheSurfaceStaysAndAWarningSaysSo)
{
  vtkNew<vtkPatientSpace> filter;
  std::string warning;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&warning);
  listener->SetCallback([](vtkObject*, unsigned long, void* client, void* text)
    { *static_cast<std::string*>(client) = static_cast<const char*>(text); });
  filter->AddObserver(vtkCommand::WarningEvent, listener);
  const vtkSmartPointer<vtkPolyData> surface = hemisphere();
  filter->SetInputData(surface);
  filter->Update();
  EXPECT_EQ(pointOf(filter->GetOutput(), 5), pointOf(surface, 5));
  EXPECT_NE(warning.find("PatientMatrix"), std::string::npos);
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("InPatientSpace"));
}

TEST(PatientSpace, RefusesMatricesThatAreNoPlaceAndFlatMaps)
{
  vtkNew<vtkPatientSpace> filter;
  const vtkSmartPointer<vtkPolyData> good = hemisphere();
  setMatrix(good, placement(1.0));
  const auto with = [&good](const RowMatrix& matrix)
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(good);
    setMatrix(data, matrix);
    return data;
  };
  RowMatrix matrix = placement(1.0);
  matrix.col(1).head<3>() = matrix.col(0).head<3>();
  expectError(filter.Get(), with(matrix), "singular", good);
  matrix = placement(1.0);
  matrix(0, 3) = std::nan("");
  expectError(filter.Get(), with(matrix), "finite", good);
  matrix = placement(1.0);
  matrix(3, 0) = 0.5;
  expectError(filter.Get(), with(matrix), "last row", good);
  const vtkSmartPointer<vtkPolyData> few = with(placement(1.0));
  few->GetFieldData()->GetArray("PatientMatrix")->SetNumberOfTuples(2);
  expectError(filter.Get(), few, "16 numbers", good);
  const vtkSmartPointer<vtkPolyData> flat = with(placement(1.0));
  vtkNew<vtkDoubleArray> inSpace;
  inSpace->SetName("SurfacePoints");
  inSpace->SetNumberOfComponents(3);
  inSpace->SetNumberOfTuples(flat->GetNumberOfPoints());
  flat->GetPointData()->AddArray(inSpace);
  expectError(filter.Get(), flat, "before Surface To Disk", good);
}

// The volume whose value is x of its own voxels, around the origin.
vtkSmartPointer<vtkImageData> rampVolume()
{
  auto volume = vtkSmartPointer<vtkImageData>::New();
  volume->SetDimensions(61, 61, 61);
  volume->SetOrigin(-30, -30, -30);
  vtkNew<vtkDoubleArray> ramp;
  ramp->SetName("X");
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    ramp->InsertNextValue(volume->GetPoint(i)[0]);
  }
  volume->GetPointData()->SetScalars(ramp);
  return volume;
}

vtkSmartPointer<vtkPolyData> flatMapOf(vtkPolyData* surface)
{
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(surface);
  conformal->Update();
  return conformal->GetOutput();
}

TEST(PatientSpace, ASlabOfASurfaceInPatientSpaceSamplesTheVoxelsUnderIt)
{
  const vtkSmartPointer<vtkPolyData> surface = hemisphere();
  const vtkSmartPointer<vtkImageData> volume = rampVolume();
  setMatrix(surface, placement(-1.0));
  setMatrix(volume, placement(-1.0));
  const vtkSmartPointer<vtkPolyData> inPatient = placed(surface);
  const vtkSmartPointer<vtkPolyData> map = flatMapOf(inPatient);
  EXPECT_EQ(figure(map, "InPatientSpace"), 1);
  vtkNew<vtkFlatMapSlab> slab;
  slab->SetInputData(map);
  slab->SetVolumeData(volume);
  slab->ClearDepths();
  slab->AddDepth(0.0);
  slab->SetStackSize(0);
  slab->Update();
  vtkDataArray* samples = slab->GetOutput()->GetPointData()->GetArray("XSlab");
  vtkDataArray* where = slab->GetOutput()->GetPointData()->GetArray("SurfacePoints");
  ASSERT_NE(samples, nullptr);
  const Eigen::Matrix4d back = placement(-1.0).inverse();
  double greatest = 0.0;
  for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); ++i)
  {
    const Eigen::Vector3d inVoxels =
      (back * Eigen::Vector3d(where->GetTuple3(i)).homogeneous()).head<3>();
    greatest = std::max(greatest, std::abs(samples->GetTuple1(i) - inVoxels.x()));
  }
  EXPECT_LT(greatest, 1e-4); // samples are in single precision
  EXPECT_EQ(figure(slab->GetOutput(), "OutsideSamples"), 0);

  // A volume that does not know where it lies is refused.
  ErrorLog errors(slab);
  slab->SetVolumeData(rampVolume());
  slab->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages()[0].find("where it lies in the patient"), std::string::npos);

  // A surface that is still in voxels has the coordinates of the volume.
  vtkNew<vtkFlatMapSlab> inVoxels;
  inVoxels->SetInputData(flatMapOf(surface));
  inVoxels->SetVolumeData(rampVolume());
  inVoxels->Update();
  EXPECT_EQ(figure(inVoxels->GetOutput(), "OutsideSamples"), 0);
}

} // namespace
