// SPDX-License-Identifier: GPL-3.0-or-later
#include "WarpOracle.h"

#include "WarpedImages.h"
#include "WarpedPlaces.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlanarWarp.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace fuzz
{
namespace
{

// About how many points of the data are compared with all faces.
constexpr vtkIdType MostPoints = 400;

// Whether a point is where the mesh took it or, outside of the mesh, where it was.
void checkPoint(const Warp& warp,
  const Point& before,
  const Point& after,
  bool isInside,
  Findings& findings)
{
  const long double height = static_cast<long double>(before[2]) - after[2];
  const Interval& plane = warp.Before.Heights;
  const long double rounding = 1e-15L * (std::abs(static_cast<long double>(before[2])) +
                                          std::abs(plane.Low) + std::abs(plane.High));
  findings.require(height >= plane.Low - rounding && height <= plane.High + rounding,
    "warp-height",
    "a point that did not keep its height above the plane of the mesh");
  const WarpedPlaces warped = warpedPlaces(warp.Before, warp.After, before);
  findings.require(
    isInside ? warped.Distance <= SurelyOff * warp.Before.Size + PlaceRounding * warp.Before.Coordinate
             : warped.Distance >= SurelyOn * warp.Before.Size,
    "warp-outside",
    isInside ? "a point off the mesh is in the map" : "a point on the mesh is not in the map");
  findings.require(
    isInside ? fits(warped, warp.After, after) : after[0] == before[0] && after[1] == before[1],
    "warp-place",
    isInside ? "a point is not where its face of the mesh took it" : "a point outside has moved");
}

// Whether the cells are those whose points were all kept.
// @param keptAs for each point before, its id after, or -1
void checkCells(vtkCellArray* before,
  vtkCellArray* after,
  const std::vector<vtkIdType>& keptAs,
  Findings& findings)
{
  vtkNew<vtkIdList> cell;
  vtkNew<vtkIdList> warped;
  vtkIdType next = 0;
  bool holds = true;
  for (vtkIdType c = 0; c < before->GetNumberOfCells() && holds; ++c)
  {
    before->GetCellAtId(c, cell);
    std::vector<vtkIdType> ids;
    for (vtkIdType i = 0; i < cell->GetNumberOfIds(); ++i)
    {
      ids.push_back(keptAs[cell->GetId(i)]);
    }
    if (std::find(ids.begin(), ids.end(), -1) != ids.end())
    {
      continue;
    }
    holds = next < after->GetNumberOfCells();
    if (holds)
    {
      after->GetCellAtId(next++, warped);
      holds = ids == std::vector<vtkIdType>(
                       warped->GetPointer(0), warped->GetPointer(0) + warped->GetNumberOfIds());
    }
  }
  findings.require(holds && next == after->GetNumberOfCells(),
    "warp-cells",
    "the cells are not those whose points are all kept");
}

// Whether the points are those of the carried data, less those that were removed, each in its new place.
void checkPoints(const Warp& warp, vtkPolyData* carried, vtkPolyData* output, Findings& findings)
{
  vtkDataArray* surface = output->GetPointData()->GetArray("SurfacePoints");
  vtkDataArray* inMap = output->GetPointData()->GetArray("InMap");
  if (!surface || !inMap)
  {
    findings.fail("warp-arrays", "no SurfacePoints or InMap");
    return;
  }
  std::vector<vtkIdType> keptAs(carried->GetNumberOfPoints(), -1);
  const vtkIdType step = std::max<vtkIdType>(1, carried->GetNumberOfPoints() / MostPoints);
  vtkIdType next = 0;
  vtkIdType outside = 0;
  for (vtkIdType p = 0; p < carried->GetNumberOfPoints(); ++p)
  {
    Point before;
    Point place = { NAN, NAN, NAN };
    carried->GetPoint(p, before.data());
    if (next < output->GetNumberOfPoints())
    {
      surface->GetTuple(next, place.data());
    }
    if (place != before)
    {
      ++outside;
      const WarpedPlaces warped = warpedPlaces(warp.Before, warp.After, before);
      findings.require(warp.RemovesOutside && !(warped.Distance < SurelyOn * warp.Before.Size),
        "warp-outside",
        "a point on the mesh was removed");
      continue;
    }
    const bool isInside = inMap->GetTuple1(next) != 0.0;
    findings.require(
      isInside || !warp.RemovesOutside, "warp-outside", "a point outside was not removed");
    outside += !isInside;
    if (p % step == 0)
    {
      Point after;
      output->GetPoint(next, after.data());
      checkPoint(warp, before, after, isInside, findings);
    }
    keptAs[p] = next++;
  }
  findings.require(
    next == output->GetNumberOfPoints(), "warp-points", "points that the data do not have");
  findings.require(figure(output, "OutsidePoints") == static_cast<double>(outside),
    "warp-figures",
    "OutsidePoints is not " + std::to_string(outside));
  findings.require(figure(output, "InsertedPoints") == 0.0, "warp-figures", "InsertedPoints is not 0");
  checkCells(carried->GetVerts(), output->GetVerts(), keptAs, findings);
  checkCells(carried->GetPolys(), output->GetPolys(), keptAs, findings);
  checkCells(carried->GetStrips(), output->GetStrips(), keptAs, findings);
}

} // namespace

void checkWarp(vtkPlanarWarp* filter, vtkPolyData* flattened, vtkDataObject* carried, Findings& findings)
{
  const Warp warp{ planarMeshOf(trianglesOf(flattened, "SurfacePoints")),
    planarMeshOf(trianglesOf(flattened)),
    filter->GetOutsidePoints() == vtkPlanarWarp::REMOVE };
  auto* image = vtkImageData::SafeDownCast(carried);
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutput());
  if (image)
  {
    output ? checkWarpedTexture(warp, image, output, findings)
           : checkWarpedImage(warp, filter, image, flattened, findings);
  }
  else if (auto* data = vtkPolyData::SafeDownCast(carried); data->GetLines()->GetNumberOfCells() == 0)
  {
    checkPoints(warp, data, output, findings);
  }
}

} // namespace fuzz
