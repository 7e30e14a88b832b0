// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilterTest.h"
#include "FormulaVolumes.h"

#include <vtkFloatArray.h>
#include <vtkRTAnalyticSource.h>
#include <vtkTable.h>

#include <cmath>
#include <string>

namespace
{

using namespace flattening;
using namespace flattening::testing;

TEST(VolumeToSurface, WhatIsNoVolumeIsAnErrorThatSaysWhy)
{
  const auto field = [](const Eigen::Vector3d& p) { return ball(p, 8.0); };
  const auto good = volumeOf(Eigen::Vector3d(20, 20, 20), field);
  const auto filter = filterAt(100.0, 0.0, good);
  const auto changed = [&good](const std::function<void(vtkImageData*)>& change)
  {
    auto data = vtkSmartPointer<vtkImageData>::New();
    data->DeepCopy(good);
    change(data);
    return data;
  };
  const auto expect = [&](vtkImageData* input, const std::string& words)
  {
    ErrorLog errors(filter);
    filter->SetInputData(input);
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u) << words;
    EXPECT_NE(errors.messages()[0].find(words), std::string::npos) << errors.messages()[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetReport()->GetNumberOfRows(), 0);
  };
  expect(volumeOf(Eigen::Vector3d(20, 20, 0), field), "a single slice, of 21 x 17 x 1 voxels");
  expect(changed([](vtkImageData* v) { v->GetPointData()->GetScalars()->Fill(7.0); }),
    "all voxels have the value 7");
  expect(changed([](vtkImageData* v) { v->GetPointData()->GetScalars()->Fill(std::nan("")); }),
    "no voxel has a value that single precision holds");
  expect(changed(
           [](vtkImageData* v)
           {
             vtkNew<vtkFloatArray> colours;
             colours->SetName("Colours");
             colours->SetNumberOfComponents(4);
             colours->SetNumberOfTuples(v->GetNumberOfPoints());
             v->GetPointData()->SetScalars(colours);
           }),
    "a voxel of \"Colours\" has 4 values");
  expect(changed([](vtkImageData* v) { v->GetPointData()->Initialize(); }), "no numbers at its voxels");
  expect(changed([](vtkImageData* v) { v->SetSpacing(1.0, 0.0, 1.0); }), "the size 0 along axis 2");
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Density");
  expect(changed(
           [](vtkImageData* v)
           {
             vtkNew<vtkFloatArray> second;
             second->SetName("Second");
             second->SetNumberOfTuples(v->GetNumberOfPoints());
             v->GetPointData()->AddArray(second);
           }),
    "the volume has no point array Density");
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Values");
  filter->SetIsovalue(5000.0);
  expect(good, "the isovalue 5000 is not between the least and greatest value");
  filter->SetIsovalue(100.0);
  filter->SetSmoothing(-1.0);
  expect(good, "the smoothing is -1");
  filter->SetSmoothing(0.0);
  filter->AutomaticAirOff();
  filter->SetAir(100.0);
  expect(good, "the value of air, 100, is not below the isovalue, 100");
  filter->SetAir(-1e39);
  expect(good, "the value of air is not a number that single precision holds");
  filter->AutomaticAirOn();
  filter->SetSmoothing(1e-200);
  filter->SetInputData(
    changed([](vtkImageData* v) { v->GetPointData()->GetScalars()->SetTuple1(5, 1e300); }));
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(figure(filter->GetOutput(), "NotFiniteVoxels"), 1);
}

TEST(VolumeToSurface, AVolumeThatMemoryCannotHoldIsRefusedBeforeItIsRead)
{
  vtkNew<vtkRTAnalyticSource> source;
  constexpr int Half = 5000; // 10,001^3 voxels: 16 TB with the steps
  source->SetWholeExtent(-Half, Half, -Half, Half, -Half, Half);
  vtkNew<vtkVolumeToSurface> filter;
  filter->SetInputConnection(source->GetOutputPort());
  ErrorLog errors(filter);
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(
    errors.messages()[0].find("a volume of 10001 x 10001 x 10001 voxels takes "), std::string::npos)
    << errors.messages()[0];
  EXPECT_NE(errors.messages()[0].find("Extract Subset"), std::string::npos);
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 1);
}

} // namespace
