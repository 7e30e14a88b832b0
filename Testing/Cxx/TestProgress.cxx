// SPDX-License-Identifier: GPL-3.0-or-later
/// Every filter: progress runs from 0 to 1 and never back, and each report names its stage. An abort at
/// any report leaves the outputs empty without an error, and the filter gives the same as ever when it
/// runs again.
#include "FilterTest.h"
#include "Internal/FilterExecution.h"
#include "IsoSurface.h"
#include "PlanarWarpSamples.h"

#include <vtkAreaWeights.h>
#include <vtkConformalDiskFilter.h>
#include <vtkContextResolution.h>
#include <vtkDistortionMetrics.h>
#include <vtkFlatMapImage.h>
#include <vtkFlatMapSlab.h>
#include <vtkFlatMapTransfer.h>
#include <vtkFlattenRegion.h>
#include <vtkMeshSaliency.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkPlanarWarp.h>
#include <vtkSurfaceToDiskFilter.h>

#include <vtkDataSet.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace flattening::testing;

struct Reports : vtkCommand
{
  std::vector<double> Fractions;
  std::vector<std::string> Stages;
  void Execute(vtkObject* caller, unsigned long, void* fraction) override
  {
    this->Fractions.push_back(*static_cast<double*>(fraction));
    const char* stage = vtkAlgorithm::SafeDownCast(caller)->GetProgressText();
    this->Stages.emplace_back(stage ? stage : "");
  }
};

void expectProgress(vtkAlgorithm* filter, std::size_t leastStages)
{
  SCOPED_TRACE(filter->GetClassName());
  auto reports = vtkSmartPointer<Reports>::Take(new Reports);
  filter->AddObserver(vtkCommand::ProgressEvent, reports);
  filter->Update();
  ASSERT_FALSE(reports->Fractions.empty());
  EXPECT_TRUE(std::is_sorted(reports->Fractions.begin(), reports->Fractions.end()));
  EXPECT_GE(reports->Fractions.front(), 0.0);
  EXPECT_DOUBLE_EQ(reports->Fractions.back(), 1.0);
  for (std::size_t i = 0; i < reports->Stages.size(); ++i)
  {
    // VTK itself reports 0 before the filter is at work.
    EXPECT_TRUE(!reports->Stages[i].empty() || reports->Fractions[i] == 0.0) << reports->Fractions[i];
  }
  std::vector<std::string> stages = reports->Stages;
  std::sort(stages.begin(), stages.end());
  const auto end = std::unique(stages.begin(), stages.end());
  EXPECT_GE(static_cast<std::size_t>(end - stages.begin()), leastStages);
}

TEST(Progress, OfEveryFilter)
{
  vtkNew<vtkSurfaceToDiskFilter> disk;
  disk->SetInputData(foldedBall(33, true));
  disk->RemeshOn();
  expectProgress(disk, 5);
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputConnection(disk->GetOutputPort());
  expectProgress(conformal, 5);
  vtkNew<vtkOMTAreaPreservingFilter> areaPreserving;
  areaPreserving->SetInputConnection(conformal->GetOutputPort());
  expectProgress(areaPreserving, 4);
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputConnection(areaPreserving->GetOutputPort());
  expectProgress(metrics, 4);
  metrics->MeasureLengthsOn();
  expectProgress(metrics, 6);
  vtkNew<vtkFlatMapTransfer> transfer;
  transfer->SetInputConnection(0, areaPreserving->GetOutputPort());
  transfer->SetInputConnection(1, disk->GetOutputPort());
  expectProgress(transfer, 1);
  vtkNew<vtkMeshSaliency> saliency;
  saliency->SetInputConnection(disk->GetOutputPort());
  expectProgress(saliency, 2);
}

TEST(Progress, OtherMethods)
{
  vtkNew<vtkSurfaceToDiskFilter> disk;
  disk->SetInputData(foldedBall(33, true));
  disk->SetCutModeToSeam();
  expectProgress(disk, 5);
  for (const int method : { vtkConformalDiskFilter::BOUNDARY_FIRST, vtkConformalDiskFilter::MEAN_VALUE })
  {
    vtkNew<vtkConformalDiskFilter> conformal;
    conformal->SetInputConnection(disk->GetOutputPort());
    conformal->SetMethod(method);
    expectProgress(conformal, 2);
  }
  vtkNew<vtkConformalDiskFilter> rectangle;
  rectangle->SetInputConnection(disk->GetOutputPort());
  rectangle->SetDomain(vtkConformalDiskFilter::RECTANGLE);
  expectProgress(rectangle, 4);
}

// Core makes steps again. Parts of the progress are copies of its callback.
TEST(Progress, OfAFilterNeverDecreases)
{
  vtkNew<vtkMeshSaliency> filter;
  const flattening::ProgressCallback progress = flattening::progressOf(filter);
  const flattening::ProgressCallback part = flattening::subrange(progress, 0.0, 0.5);
  EXPECT_TRUE(progress(0.4, "first"));
  EXPECT_TRUE(part(0.2, "second"));
  EXPECT_EQ(filter->GetProgress(), 0.4);
  EXPECT_STREQ(filter->GetProgressText(), "second");
  EXPECT_TRUE(part(1.0, "third"));
  EXPECT_EQ(filter->GetProgress(), 0.5);
  filter->SetAbortExecute(1);
  EXPECT_FALSE(part(0.0, "fourth"));
}

// Nothing where there are neither points nor rows.
vtkIdType sizeOf(vtkDataObject* data)
{
  if (auto* dataSet = vtkDataSet::SafeDownCast(data))
  {
    return dataSet->GetNumberOfPoints();
  }
  auto* table = vtkTable::SafeDownCast(data);
  return table ? table->GetNumberOfRows() : 0;
}

// Reports that are repeated while a library is at work, as often as that takes, count as one.
struct Abort : vtkCommand
{
  int At = 0;
  int Reports = 0;
  std::pair<double, std::string> Last;
  void Execute(vtkObject* caller, unsigned long, void* fraction) override
  {
    auto* filter = vtkAlgorithm::SafeDownCast(caller);
    const char* stage = filter->GetProgressText();
    const std::pair<double, std::string> report(*static_cast<double*>(fraction), stage ? stage : "");
    if (this->Reports > 0 && report == this->Last)
    {
      return;
    }
    this->Last = report;
    if (this->Reports++ == this->At)
    {
      filter->SetAbortExecute(1);
    }
  }
};

void expectAbortAtAnyReport(vtkAlgorithm* filter)
{
  SCOPED_TRACE(filter->GetClassName());
  const ErrorLog errors(filter);
  auto abort = vtkSmartPointer<Abort>::Take(new Abort);
  abort->At = -1;
  filter->Update();
  const vtkIdType size = sizeOf(filter->GetOutputDataObject(0));
  ASSERT_GT(size, 0);
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->Modified();
  filter->Update();
  const int reports = abort->Reports;
  // The report of 1 comes when all is done.
  const int last = reports - 2;
  ASSERT_GE(last, 0);
  for (int sample = 0; sample <= 4; ++sample)
  {
    abort->At = sample * last / 4;
    SCOPED_TRACE(std::to_string(abort->At) + " of " + std::to_string(reports));
    abort->Reports = 0;
    filter->Modified();
    filter->Update();
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      EXPECT_EQ(sizeOf(filter->GetOutputDataObject(port)), 0) << "port " << port;
    }
    filter->SetAbortExecute(0);
  }
  EXPECT_TRUE(errors.messages().empty());
  abort->At = -1;
  filter->Modified();
  filter->Update();
  EXPECT_EQ(sizeOf(filter->GetOutputDataObject(0)), size);
}

// The surface with the point array Label, 1 on one side.
vtkSmartPointer<vtkPolyData> labelledDisk(vtkPolyData* disk)
{
  auto labelled = vtkSmartPointer<vtkPolyData>::New();
  labelled->ShallowCopy(disk);
  double centre[3];
  disk->GetCenter(centre);
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  for (vtkIdType i = 0; i < disk->GetNumberOfPoints(); ++i)
  {
    label->InsertNextValue(disk->GetPoint(i)[0] > centre[0] ? 1 : 0);
  }
  labelled->GetPointData()->AddArray(label);
  return labelled;
}

vtkSmartPointer<vtkImageData> volumeAround(vtkPolyData* surface)
{
  auto volume = vtkSmartPointer<vtkImageData>::New();
  const double* bounds = surface->GetBounds();
  volume->SetOrigin(bounds[0], bounds[2], bounds[4]);
  volume->SetDimensions(9, 9, 9);
  volume->SetSpacing(
    (bounds[1] - bounds[0]) / 8, (bounds[3] - bounds[2]) / 8, (bounds[5] - bounds[4]) / 8);
  volume->AllocateScalars(VTK_FLOAT, 1);
  volume->GetPointData()->GetScalars()->Fill(1.0);
  return volume;
}

void chooseLabels(vtkAlgorithm* filter)
{
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Label");
}

// Every filter that takes a disk or its map, and how many stages it is to report at least.
void forEachLaterFilter(const std::function<void(vtkAlgorithm*, std::size_t leastStages)>& check)
{
  vtkNew<vtkSurfaceToDiskFilter> opened;
  opened->SetInputData(foldedBall(33, true));
  opened->RemeshOn();
  opened->Update();
  const vtkSmartPointer<vtkPolyData> disk = labelledDisk(opened->GetOutput());
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(disk);
  vtkNew<vtkOMTAreaPreservingFilter> flat;
  flat->SetInputConnection(conformal->GetOutputPort());
  flat->Update();

  vtkNew<vtkMeshSaliency> saliency;
  saliency->SetInputData(disk);
  saliency->FindRegionsOn();
  check(saliency, 2);
  vtkNew<vtkContextResolution> context;
  context->SetInputData(disk);
  context->SetContextFaces(100);
  chooseLabels(context);
  check(context, 3);
  vtkNew<vtkContextResolution> fineEnough;
  fineEnough->SetInputData(disk);
  fineEnough->SetContextFaces(VTK_INT_MAX);
  chooseLabels(fineEnough);
  check(fineEnough, 1);
  vtkNew<vtkAreaWeights> weights;
  weights->SetInputData(disk);
  chooseLabels(weights);
  check(weights, 2);
  vtkNew<vtkAreaWeights> softWeights;
  softWeights->SetInputData(disk);
  chooseLabels(softWeights);
  softWeights->SetEdgeWidth(5.0);
  check(softWeights, 3);
  vtkNew<vtkFlattenRegion> region;
  region->SetInputData(disk);
  chooseLabels(region);
  check(region, 4);
  vtkNew<vtkFlatMapImage> image;
  image->SetInputData(flat->GetOutput());
  image->SetSize(100);
  check(image, 3);
  vtkNew<vtkFlatMapTransfer> transfer;
  transfer->SetInputData(0, flat->GetOutput());
  transfer->SetInputData(1, disk);
  check(transfer, 2);
  vtkNew<vtkFlatMapSlab> slab;
  slab->SetInputData(0, flat->GetOutput());
  slab->SetInputData(1, volumeAround(disk));
  slab->SetStackSize(50);
  check(slab, 4);
  vtkNew<vtkPlanarWarp> warp;
  warp->SetInputData(0, doubled());
  warp->SetInputData(1, plane(20));
  check(warp, 2);
}

TEST(Progress, OfLaterFilters)
{
  forEachLaterFilter(expectProgress);
}

TEST(Progress, AbortOfLaterFilters)
{
  forEachLaterFilter([](vtkAlgorithm* filter, std::size_t) { expectAbortAtAnyReport(filter); });
}

} // namespace
