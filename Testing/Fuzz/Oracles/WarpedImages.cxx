// SPDX-License-Identifier: GPL-3.0-or-later
#include "WarpedImages.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPlanarWarp.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace fuzz
{
namespace
{

// About how many pixels are compared with all faces.
constexpr vtkIdType MostPixels = 400;
// How far off the edge of the image a place may be taken for one on the other side of it, in pixels.
constexpr long double EdgeRounding = 2e-6L;

/// An image of one slice.
struct Picture
{
  explicit Picture(vtkImageData* image)
    : Values(image->GetPointData()->GetScalars())
  {
    image->GetDimensions(this->Size);
    image->GetOrigin(this->Origin);
    image->GetSpacing(this->Spacing);
  }

  // The position in units of pixels.
  Position indexOf(const Position& place) const
  {
    return { (place[0] - this->Origin[0]) / this->Spacing[0],
      (place[1] - this->Origin[1]) / this->Spacing[1] };
  }
  // The distance of a position from the edge of the image with the outer halves of its pixels, in
  // pixels; negative outside.
  long double depthAt(const Position& index) const
  {
    return std::min(std::min(index[0], this->Size[0] - 1.0L - index[0]),
             std::min(index[1], this->Size[1] - 1.0L - index[1])) +
           0.5L;
  }
  // The value at a position, moved to the centres of the outermost pixels.
  long double valueAt(const Position& index, bool nearest, int component) const
  {
    long double value = 0.0L;
    std::array<std::array<std::pair<int, long double>, 2>, 2> pixels;
    for (int k = 0; k < 2; ++k)
    {
      const long double x = std::clamp(index[k], 0.0L, this->Size[k] - 1.0L);
      const int low = std::clamp(static_cast<int>(std::floor(x)), 0, this->Size[k] - 2);
      const long double share = nearest ? (x - low >= 0.5L ? 1.0L : 0.0L) : x - low;
      pixels[k] = { std::make_pair(low, 1.0L - share), std::make_pair(low + 1, share) };
    }
    for (const auto& [i, a] : pixels[0])
    {
      for (const auto& [j, b] : pixels[1])
      {
        value +=
          a * b * this->Values->GetComponent(i + static_cast<vtkIdType>(j) * this->Size[0], component);
      }
    }
    return value;
  }

  vtkDataArray* Values;
  int Size[3];
  double Origin[3];
  double Spacing[3];
};

// Whether a value is that of the image at a position, which is known up to rounding.
bool shows(const Picture& picture,
  const Position& index,
  const Position& rounding,
  bool nearest,
  const double* value)
{
  for (int component = 0; component < picture.Values->GetNumberOfComponents(); ++component)
  {
    long double low = HUGE_VALL;
    long double high = -HUGE_VALL;
    bool isOneOf = false;
    for (const int i : { -1, 0, 1 })
    {
      for (const int j : { -1, 0, 1 })
      {
        const long double v = picture.valueAt(
          { index[0] + i * rounding[0], index[1] + j * rounding[1] }, nearest, component);
        low = std::min(low, v);
        high = std::max(high, v);
        isOneOf = isOneOf || v == value[component];
      }
    }
    // The values are whole numbers, to which VTK rounds or cuts.
    if (nearest ? !isOneOf : value[component] < low - 1.001L || value[component] > high + 1.001L)
    {
      return false;
    }
  }
  return true;
}

/// The values of the image before that a pixel can show.
struct PixelContent
{
  bool MayShow = false;    // a place of the image may have been taken to the pixel
  bool MayNotShow = false; // a place outside of the image may have been taken there
  bool IsRight = false;    // the value is that of a place that may have been taken there
};

PixelContent contentFrom(const WarpedPlaces& sources,
  const Picture& before,
  bool nearest,
  const double* value)
{
  PixelContent content;
  for (const WarpedPlace& source : sources.Places)
  {
    const Position index = before.indexOf(source.Place);
    const Position rounding = { source.Rounding / before.Spacing[0] + 1e-9L,
      source.Rounding / before.Spacing[1] + 1e-9L };
    const long double depth = before.depthAt(index);
    const long double most = std::max(rounding[0], rounding[1]) + EdgeRounding;
    content.MayShow = content.MayShow || depth >= -most;
    content.MayNotShow = content.MayNotShow || depth <= most;
    content.IsRight =
      content.IsRight || (depth >= -most && shows(before, index, rounding, nearest, value));
  }
  return content;
}

// Whether the pixels are square and as small as they can be.
void checkGrid(const Warp& warp,
  vtkImageData* carried,
  const Picture& output,
  vtkPolyData* flattened,
  Findings& findings)
{
  double bounds[6];
  flattened->GetBounds(bounds);
  double old[6];
  carried->GetBounds(old);
  long double pixel = 0.0L;
  for (int k = 0; k < 2; ++k)
  {
    const double low = warp.RemovesOutside ? bounds[2 * k] : std::min(bounds[2 * k], old[2 * k]);
    const double high =
      warp.RemovesOutside ? bounds[2 * k + 1] : std::max(bounds[2 * k + 1], old[2 * k + 1]);
    pixel = std::max(pixel, (static_cast<long double>(high) - low) / output.Size[k]);
    const long double first = output.Origin[k] - 0.5L * output.Spacing[k];
    const long double last = output.Origin[k] + (output.Size[k] - 0.5L) * output.Spacing[k];
    const long double rounding = 1e-12L * (std::abs(low) + std::abs(high));
    findings.require(first <= low + rounding && last >= high - rounding,
      "warp-grid",
      "the image does not cover the flat map");
  }
  findings.require(
    output.Spacing[0] == output.Spacing[1] && std::abs(output.Spacing[0] - pixel) <= 1e-9L * pixel,
    "warp-grid",
    "the pixels are not square or not as small as they can be");
}

} // namespace

void checkWarpedImage(const Warp& warp,
  vtkPlanarWarp* filter,
  vtkImageData* carried,
  vtkPolyData* flattened,
  Findings& findings)
{
  auto* image = vtkImageData::SafeDownCast(filter->GetOutput());
  const Picture before(carried);
  const Picture after(image);
  vtkDataArray* inMap = image->GetPointData()->GetArray("InMap");
  if (!inMap || !after.Values)
  {
    findings.fail("warp-arrays", "no InMap, or no values");
    return;
  }
  checkGrid(warp, carried, after, flattened, findings);
  const vtkIdType step = std::max<vtkIdType>(1, image->GetNumberOfPoints() / MostPixels);
  vtkIdType outside = 0;
  vtkIdType unclear = 0;
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); p += step)
  {
    Point centre;
    image->GetPoint(p, centre.data());
    WarpedPlaces sources = warpedPlaces(warp.After, warp.Before, centre);
    const bool isOn = sources.Distance < SurelyOn * warp.After.Size;
    const bool isOff = sources.Distance > SurelyOff * warp.After.Size;
    if (!warp.RemovesOutside && !isOn)
    {
      // The pixel may show its own place if the mesh did not move away from there.
      const WarpedPlaces covered = warpedPlaces(warp.Before, warp.After, centre);
      if (covered.Distance >= SurelyOn * warp.Before.Size)
      {
        const long double rounding = 1e-15L * (std::abs(centre[0]) + std::abs(centre[1]));
        sources.Places.push_back({ { centre[0], centre[1] }, rounding, {} });
      }
    }
    PixelContent content =
      contentFrom(sources, before, filter->GetNearestPixel(), after.Values->GetTuple(p));
    content.MayShow = content.MayShow && (!isOff || !warp.RemovesOutside);
    content.MayNotShow = content.MayNotShow || !isOn;
    const bool shown = inMap->GetTuple1(p) != 0.0;
    outside += isOn && !shown;
    unclear += !isOn && !isOff;
    findings.require(shown ? content.MayShow : content.MayNotShow,
      "warp-outside",
      shown ? "a pixel shows a place that is not in the image" : "a pixel on the map does not show it");
    findings.require(
      !shown || !content.MayShow || content.IsRight, "warp-place", "a pixel has a wrong value");
  }
  const double reported = figure(image, "OutsidePoints");
  findings.require(step > 1 || (reported >= static_cast<double>(outside) &&
                                 reported <= static_cast<double>(outside + unclear)),
    "warp-figures",
    "OutsidePoints is " + std::to_string(reported) + " instead of " + std::to_string(outside));
}

void checkWarpedTexture(const Warp& warp, vtkImageData* carried, vtkPolyData* output, Findings& findings)
{
  const Picture picture(carried);
  vtkDataArray* coordinates = output->GetPointData()->GetTCoords();
  vtkDataArray* inMap = output->GetPointData()->GetArray("InMap");
  if (!coordinates || !inMap)
  {
    findings.fail("warp-arrays", "no TCoords or InMap");
    return;
  }
  vtkIdType outside = 0;
  for (std::size_t p = 0; p < warp.Before.Mesh.Points.size(); ++p)
  {
    const auto id = static_cast<vtkIdType>(p);
    const Point& place = warp.Before.Mesh.Points[p];
    const Position index = picture.indexOf({ place[0], place[1] });
    for (int k = 0; k < 2; ++k)
    {
      const long double expected = (index[k] + 0.5L) / picture.Size[k];
      findings.require(
        std::abs(coordinates->GetComponent(id, k) - expected) <= 1e-6L * (1.0L + std::abs(expected)),
        "warp-place",
        "TCoords is not the place in the image");
    }
    const bool isInside = inMap->GetTuple1(id) != 0.0;
    const long double depth = picture.depthAt(index);
    findings.require(isInside ? depth >= -EdgeRounding : depth <= EdgeRounding,
      "warp-outside",
      "InMap of a textured point is wrong");
    outside += !isInside;
  }
  findings.require(figure(output, "OutsidePoints") == static_cast<double>(outside),
    "warp-figures",
    "OutsidePoints is not " + std::to_string(outside));
}

} // namespace fuzz
