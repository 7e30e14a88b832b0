// SPDX-License-Identifier: GPL-3.0-or-later
/// Every filter: progress runs from 0 to 1 and never back, and each report names its stage.
#include "FilterTest.h"
#include "IsoSurface.h"

#include <vtkConformalDiskFilter.h>
#include <vtkDistortionMetrics.h>
#include <vtkFlatMapTransfer.h>
#include <vtkMeshSaliency.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkSurfaceToDiskFilter.h>

#include <vtkNew.h>

#include <algorithm>
#include <string>
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

} // namespace
