// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/WarpImage.h"

#include "Core/Base/Errors.h"
#include "Internal/ArrayConversion.h"

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

// The picture, whose pixels may have any thickness: those of a resampled plane have none, and VTK could
// not tell where a position lies.
vtkSmartPointer<vtkImageData> pictureOf(vtkImageData* image)
{
  requirePicture(image);
  double pixel[3];
  image->GetSpacing(pixel);
  for (int axis = 0; axis < 2; ++axis)
  {
    if (pixel[axis] == 0.0 || !std::isfinite(pixel[axis]))
    {
      throw InvalidInput("a pixel has the size " + formatted(pixel[axis]) + " along axis " +
                         std::to_string(axis + 1) + ": set the Spacing of the image");
    }
  }
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->ShallowCopy(image);
  picture->SetSpacing(pixel[0], pixel[1], 1.0);
  return picture;
}

// The position in units of pixels. In the outer half of the outermost pixels it is moved to their
// centres. Returns false outside the image.
bool pixelAt(vtkImageData* image, double x, double y, double index[3])
{
  const int* extent = image->GetExtent();
  const double position[3] = { x, y, image->GetBounds()[4] };
  image->TransformPhysicalPointToContinuousIndex(position, index);
  index[2] = extent[4];
  constexpr double half = 0.5 + 1e-6; // positions may be rounded to single precision
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

} // namespace

ImageGrid resampledGrid(vtkImageData* input,
  vtkPolyData* flat,
  bool leaveUnmoved,
  const int size[2],
  double planeHeight)
{
  double bounds[6];
  flat->GetBounds(bounds);
  if (leaveUnmoved)
  {
    double old[6];
    input->GetBounds(old);
    for (int axis = 0; axis < 2; ++axis)
    {
      bounds[2 * axis] = std::min(bounds[2 * axis], old[2 * axis]);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], old[2 * axis + 1]);
    }
  }
  const double pixel = std::max((bounds[1] - bounds[0]) / size[0], (bounds[3] - bounds[2]) / size[1]);
  return { { size[0], size[1], 1 },
    { 0.5 * (bounds[0] + bounds[1] - (size[0] - 1) * pixel),
      0.5 * (bounds[2] + bounds[3] - (size[1] - 1) * pixel),
      input->GetBounds()[4] - planeHeight },
    { pixel, pixel, 1.0 } };
}

namespace
{

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

// The position in the image of the point that each pixel shows. Inside is 2 for pixels that stay
// unmoved.
WarpedPoints sourcesOf(const Points2& centres, const ResamplingRules& rules)
{
  WarpedPoints sources =
    rules.Warp.warpBack(centres, subrange(rules.Progress, 0.0, rules.LeaveUnmoved ? 0.5 : 1.0));
  if (rules.LeaveUnmoved)
  {
    const WarpedPoints covered = rules.Warp.warp(centres, subrange(rules.Progress, 0.5, 1.0));
    for (Eigen::Index i = 0; i < centres.rows(); ++i)
    {
      if (!sources.Inside[i] && !covered.Inside[i]) // otherwise the mesh moved away from this pixel
      {
        sources.Inside[i] = 2;
      }
    }
  }
  return sources;
}

vtkSmartPointer<vtkPointData> interpolated(vtkImageData* input, vtkPoints* positions)
{
  vtkNew<vtkPolyData> probes;
  probes->SetPoints(positions);
  vtkNew<vtkProbeFilter> filter;
  filter->SetInputData(probes);
  filter->SetSourceData(input);
  filter->SetValidPointMaskArrayName(
    "vtkPlanarWarpValidPointMask"); // images from other probes have an array of the default name
  filter->Update();
  vtkSmartPointer<vtkPointData> values = filter->GetOutput()->GetPointData();
  values->RemoveArray(filter->GetValidPointMaskArrayName());
  return values;
}

// The pixels of the output that show a point of the image.
struct ShownPixels
{
  std::vector<vtkIdType> Ids;     // in the output
  std::vector<vtkIdType> Nearest; // the pixel of the image nearest to the point
  vtkNew<vtkPoints> Positions;    // of the point in the image
  long long Outside = 0;          // number of pixels on the flat map that show no point of the image
};

void findShownPixels(vtkImageData* input, const WarpedPoints& sources, ShownPixels& shown)
{
  shown.Positions->SetDataTypeToDouble();
  for (Eigen::Index i = 0; i < sources.Positions.rows(); ++i)
  {
    double index[3];
    if (sources.Inside[i] && pixelAt(input, sources.Positions(i, 0), sources.Positions(i, 1), index))
    {
      double position[3];
      input->TransformContinuousIndexToPhysicalPoint(index, position);
      shown.Positions->InsertNextPoint(position);
      shown.Ids.push_back(i);
      int pixel[3];
      std::transform(index, index + 3, pixel, [](double k) { return static_cast<int>(std::lround(k)); });
      shown.Nearest.push_back(input->ComputePointId(pixel));
    }
    else
    {
      shown.Outside += sources.Inside[i] == 1;
    }
  }
  if (shown.Ids.empty())
  {
    throw InvalidInput(
      "no pixel of the flat map comes from the image: move the image to where the mesh's "
      "SurfacePoints are");
  }
}

// The point array of the image that VTK interpolated to array @p a of @p probed; null for a cell array.
vtkDataArray* pixelsOf(vtkPointData* image, vtkPointData* probed, int a)
{
  if (const char* name = probed->GetArrayName(a))
  {
    return image->GetArray(name);
  }
  // VTK interpolates an array without a name only if it is active, and activates the result.
  const int attribute = probed->IsArrayAnAttribute(a);
  return attribute >= 0 ? image->GetAttribute(attribute) : nullptr;
}

// Adds an array of the output like @p values, 0 where a pixel shows no point. The values are those of
// @p pixels, an array of the image, at the nearest pixel; or, without it, the interpolated ones.
// Returns the index of the array.
int addPixels(const ShownPixels& shown, vtkDataArray* values, vtkDataArray* pixels, vtkImageData* output)
{
  auto array = vtk::TakeSmartPointer(values->NewInstance());
  array->SetName(values->GetName());
  array->SetNumberOfComponents(values->GetNumberOfComponents());
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  array->Fill(0.0);
  for (std::size_t i = 0; i < shown.Ids.size(); ++i)
  {
    pixels ? array->SetTuple(shown.Ids[i], shown.Nearest[i], pixels)
           : array->SetTuple(shown.Ids[i], static_cast<vtkIdType>(i), values);
  }
  return output->GetPointData()->AddArray(array);
}

} // namespace

long long warpImage(vtkImageData* image,
  vtkPolyData* flat,
  const ResamplingRules& rules,
  vtkImageData* output)
{
  const vtkSmartPointer<vtkImageData> input = pictureOf(image);
  setGrid(output, resampledGrid(input, flat, rules.LeaveUnmoved, rules.Size, rules.Warp.planeHeight()));
  ShownPixels shown;
  findShownPixels(input, sourcesOf(pixelCentres(output), rules), shown);

  const vtkSmartPointer<vtkPointData> values = interpolated(input, shown.Positions);
  for (int a = 0; a < values->GetNumberOfArrays(); ++a)
  {
    if (vtkDataArray* array = values->GetArray(a))
    {
      vtkDataArray* pixels = pixelsOf(input->GetPointData(), values, a);
      const int added = addPixels(shown, array, rules.Nearest ? pixels : nullptr, output);
      if (pixels && pixels == input->GetPointData()->GetScalars())
      {
        output->GetPointData()->SetActiveAttribute(added, vtkDataSetAttributes::SCALARS);
      }
    }
  }
  std::vector<char> inMap(output->GetNumberOfPoints(), 0);
  for (const vtkIdType i : shown.Ids)
  {
    inMap[i] = 1;
  }
  output->GetPointData()->AddArray(newArray<vtkUnsignedCharArray>(InMapName, inMap));
  return shown.Outside;
}

long long addTextureCoordinates(vtkImageData* input, const Points3& before, vtkPolyData* flat)
{
  const vtkSmartPointer<vtkImageData> image = pictureOf(input);
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
    const double position[3] = { before(v, 0), before(v, 1), image->GetBounds()[4] };
    double index[3];
    image->TransformPhysicalPointToContinuousIndex(position, index);
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
