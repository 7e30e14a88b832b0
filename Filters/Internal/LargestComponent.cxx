// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/LargestComponent.h"

#include "Internal/InnerProgress.h"

#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace flattening
{
namespace
{

constexpr const char* Stage = "Finding the components";
constexpr const char* RegionName = "RegionId"; // as vtkPolyDataConnectivityFilter names it

std::vector<double> areasOf(vtkPolyData* surface, vtkDataArray* regions, int count)
{
  std::vector<double> areas(count, 0.0);
  vtkNew<vtkIdList> corners;
  for (vtkIdType face = 0; face < surface->GetNumberOfCells(); ++face)
  {
    surface->GetCellPoints(face, corners);
    double p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      surface->GetPoint(corners->GetId(k), p[k]);
    }
    areas[static_cast<std::size_t>(regions->GetTuple1(corners->GetId(0)))] +=
      vtkTriangle::TriangleArea(p[0], p[1], p[2]);
  }
  return areas;
}

} // namespace

ComponentAreas takeLargestComponent(vtkPolyData* surface,
  bool keepLargest,
  const ProgressCallback& progress)
{
  vtkNew<vtkPolyDataConnectivityFilter> connectivity;
  connectivity->SetInputData(surface);
  connectivity->SetExtractionModeToAllRegions();
  connectivity->ColorRegionsOn();
  {
    const InnerProgress forwarding(connectivity, progress, Stage);
    connectivity->Update();
  }
  report(progress, 0.5, Stage);
  vtkPolyData* regions = connectivity->GetOutput();
  ComponentAreas found;
  found.Count = connectivity->GetNumberOfExtractedRegions();
  const std::vector<double> areas =
    areasOf(regions, regions->GetPointData()->GetArray(RegionName), static_cast<int>(found.Count));
  const auto largest = std::max_element(areas.begin(), areas.end());
  found.Whole = std::accumulate(areas.begin(), areas.end(), 0.0);
  found.Largest = *largest;
  if (keepLargest && found.Count > 1)
  {
    connectivity->SetExtractionModeToSpecifiedRegions();
    connectivity->AddSpecifiedRegion(static_cast<int>(largest - areas.begin()));
    vtkNew<vtkCleanPolyData> unusedPoints;
    unusedPoints->SetInputConnection(connectivity->GetOutputPort());
    unusedPoints->PointMergingOff();
    unusedPoints->Update();
    report(progress, 1.0, Stage);
    surface->ShallowCopy(unusedPoints->GetOutput());
    surface->GetPointData()->RemoveArray(RegionName);
    surface->GetCellData()->RemoveArray(RegionName);
  }
  return found;
}

} // namespace flattening
