// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/WarpImage.h"

#include "Core/Base/Errors.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace flattening
{
namespace
{

void requirePicture(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  if (size[2] != 1 || size[0] < 2 || size[1] < 2)
  {
    throw InvalidInput("the image has " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
                       " x " + std::to_string(size[2]) +
                       " pixels: pass one slice of at least two rows and columns in x and y, e.g. from "
                       "Extract Subset");
  }
  if (image->GetPointData()->GetNumberOfArrays() + image->GetCellData()->GetNumberOfArrays() == 0)
  {
    throw InvalidInput("the image has no array: pass one with values");
  }
}

// The place in units of pixels from the first one; moved to the image's outermost pixels if it is within
// the half of them that lies beyond their centres. False if it is beyond that.
bool pixelAt(vtkImageData* image, double x, double y, double index[3])
{
  const int* extent = image->GetExtent();
  const double place[3] = { x, y, image->GetBounds()[4] };
  image->TransformPhysicalPointToContinuousIndex(place, index);
  index[2] = extent[4];
  constexpr double half = 0.5 + 1e-6;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double first = extent[2 * axis];
    const double last = extent[2 * axis + 1];
    if (!(index[axis] >= first - half && index[axis] <= last + half))
    {
      return false;
    }
    index[axis] = std::clamp(index[axis], first, last);
  }
  return true;
}

// A grid of square pixels over the flat map, and over the image too if it is left where it is.
void layOut(vtkImageData* input, vtkPolyData* flat, const ResamplingRules& rules, vtkImageData* output)
{
  double bounds[6];
  flat->GetBounds(bounds);
  if (rules.LeaveUnmoved)
  {
    double old[6];
    input->GetBounds(old);
    for (int axis = 0; axis < 2; ++axis)
    {
      bounds[2 * axis] = std::min(bounds[2 * axis], old[2 * axis]);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], old[2 * axis + 1]);
    }
  }
  const double pixel =
    std::max((bounds[1] - bounds[0]) / rules.Size[0], (bounds[3] - bounds[2]) / rules.Size[1]);
  output->SetDimensions(rules.Size[0], rules.Size[1], 1);
  output->SetSpacing(pixel, pixel, 1.0);
  output->SetOrigin(0.5 * (bounds[0] + bounds[1] - (rules.Size[0] - 1) * pixel),
    0.5 * (bounds[2] + bounds[3] - (rules.Size[1] - 1) * pixel),
    input->GetBounds()[4] - rules.Warp.planeHeight());
}

Points2 pixelCentres(vtkImageData* image)
{
  Points2 centres(image->GetNumberOfPoints(), 2);
  for (vtkIdType i = 0; i < centres.rows(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    centres.row(i) << x[0], x[1];
  }
  return centres;
}

// Where what each pixel shows comes from.
CarriedPoints sourcesOf(const Points2& centres, const ResamplingRules& rules)
{
  CarriedPoints sources =
    rules.Warp.carryBack(centres, subrange(rules.Progress, 0.0, rules.LeaveUnmoved ? 0.5 : 1.0));
  if (rules.LeaveUnmoved)
  {
    const CarriedPoints covered = rules.Warp.carry(centres, subrange(rules.Progress, 0.5, 1.0));
    for (Eigen::Index i = 0; i < centres.rows(); ++i)
    {
      if (!sources.Inside[i] && !covered.Inside[i]) // else what was there is elsewhere now
      {
        sources.Inside[i] = 2;
      }
    }
  }
  return sources;
}

vtkSmartPointer<vtkPointData> interpolated(vtkImageData* input, vtkPoints* places)
{
  vtkNew<vtkPolyData> probes;
  probes->SetPoints(places);
  vtkNew<vtkProbeFilter> filter;
  filter->SetInputData(probes);
  filter->SetSourceData(input);
  filter->SetValidPointMaskArrayName(
    "vtkPlanarWarpValidPointMask"); // the default is in images of other probes
  filter->Update();
  vtkSmartPointer<vtkPointData> values = filter->GetOutput()->GetPointData();
  values->RemoveArray(filter->GetValidPointMaskArrayName());
  return values;
}

} // namespace

long long warpImage(vtkImageData* input,
  vtkPolyData* flat,
  const ResamplingRules& rules,
  vtkImageData* output)
{
  requirePicture(input);
  layOut(input, flat, rules, output);
  const CarriedPoints sources = sourcesOf(pixelCentres(output), rules);

  long long outside = 0;
  std::vector<vtkIdType> shown;
  std::vector<vtkIdType> nearest; // pixel of the input
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkUnsignedCharArray> inMap;
  inMap->SetName(InMapName);
  inMap->SetNumberOfTuples(output->GetNumberOfPoints());
  inMap->FillValue(0);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double index[3];
    if (sources.Inside[i] && pixelAt(input, sources.Positions(i, 0), sources.Positions(i, 1), index))
    {
      double place[3];
      input->TransformContinuousIndexToPhysicalPoint(index, place);
      places->InsertNextPoint(place);
      shown.push_back(i);
      int pixel[3];
      std::transform(index, index + 3, pixel, [](double k) { return static_cast<int>(std::lround(k)); });
      nearest.push_back(input->ComputePointId(pixel));
      inMap->SetValue(i, 1);
    }
    else
    {
      outside += sources.Inside[i] == 1;
    }
  }
  if (shown.empty())
  {
    throw InvalidInput(
      "no pixel of the flat map comes from the image: move the image to where the mesh's "
      "SurfacePoints are");
  }

  const vtkSmartPointer<vtkPointData> values = interpolated(input, places);
  for (int a = 0; a < values->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* from = values->GetArray(a);
    vtkDataArray* pixels = input->GetPointData()->GetArray(values->GetArrayName(a));
    if (from)
    {
      auto array = vtk::TakeSmartPointer(from->NewInstance());
      array->SetName(from->GetName());
      array->SetNumberOfComponents(from->GetNumberOfComponents());
      array->SetNumberOfTuples(output->GetNumberOfPoints());
      array->Fill(0.0);
      for (std::size_t i = 0; i < shown.size(); ++i)
      {
        if (rules.Nearest && pixels)
        {
          array->SetTuple(shown[i], nearest[i], pixels);
        }
        else
        {
          array->SetTuple(shown[i], static_cast<vtkIdType>(i), from);
        }
      }
      output->GetPointData()->AddArray(array);
    }
  }
  output->GetPointData()->AddArray(inMap);
  vtkDataArray* scalars = input->GetPointData()->GetScalars();
  output->GetPointData()->SetActiveScalars(scalars ? scalars->GetName() : nullptr);
  return outside;
}

long long addTextureCoordinates(vtkImageData* image, const Points3& before, vtkPolyData* flat)
{
  requirePicture(image);
  const int* extent = image->GetExtent();
  const int* size = image->GetDimensions();
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TCoords");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(before.rows());
  vtkNew<vtkUnsignedCharArray> inMap;
  inMap->SetName(InMapName);
  inMap->SetNumberOfTuples(before.rows());
  long long outside = 0;
  for (Eigen::Index v = 0; v < before.rows(); ++v)
  {
    const double place[3] = { before(v, 0), before(v, 1), image->GetBounds()[4] };
    double index[3];
    image->TransformPhysicalPointToContinuousIndex(place, index);
    for (int axis = 0; axis < 2; ++axis) // texture coordinates run from edge to edge of the image
    {
      coordinates->SetComponent(v, axis, (index[axis] - extent[2 * axis] + 0.5) / size[axis]);
    }
    const bool inside = pixelAt(image, before(v, 0), before(v, 1), index);
    inMap->SetValue(v, inside);
    outside += !inside;
  }
  if (outside == before.rows())
  {
    throw InvalidInput("no point of the mesh lies on the image: move the image to where the mesh's "
                       "SurfacePoints are");
  }
  flat->GetPointData()->SetTCoords(coordinates);
  flat->GetPointData()->AddArray(inMap);
  return outside;
}

} // namespace flattening
