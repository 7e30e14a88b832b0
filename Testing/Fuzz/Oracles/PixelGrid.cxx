// SPDX-License-Identifier: GPL-3.0-or-later
#include "PixelGrid.h"

#include "../Random.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMatrix3x3.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>

namespace fuzz
{
namespace
{

constexpr int MostPixels = 100;

} // namespace

long double placeRounding(const Square& square)
{
  // The closest point on a side was found to be off by 1e-14 of the map.
  return 1e-13L * (square.Greatest + square.Side);
}

long double boundaryRounding(const Square& square)
{
  return 4e-12L * square.Side + placeRounding(square);
}

Point centreOf(vtkImageData* image, vtkIdType pixel)
{
  const int columns = image->GetDimensions()[0];
  const double* first = image->GetOrigin();
  const double* lengths = image->GetSpacing();
  return { first[0] + static_cast<double>(pixel % columns) * lengths[0],
    first[1] + static_cast<double>(pixel / columns) * lengths[1],
    0.0 };
}

void checkPixelGrid(vtkInformation* announced,
  vtkImageData* image,
  const Square& square,
  Findings& findings)
{
  const int* size = image->GetDimensions();
  const double* lengths = image->GetSpacing();
  const double* first = image->GetOrigin();
  const long double length = square.Side / size[0];
  const long double rounding = 1e-15L * (square.Greatest + square.Side);
  bool holds = size[0] == size[1] && image->GetDirectionMatrix()->IsIdentity();
  for (int k = 0; k < 2; ++k)
  {
    holds = holds && std::abs(lengths[k] - length) <= rounding / size[0] &&
            std::abs(first[k] - (square.Low[k] + 0.5L * length)) <= rounding;
  }
  findings.require(holds, "image-grid", "the pixels do not fill the square around the map");
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int* extent = image->GetExtent();
  const int* whole = announced->Get(Pipeline::WHOLE_EXTENT());
  const double* spacing = announced->Get(vtkDataObject::SPACING());
  const double* origin = announced->Get(vtkDataObject::ORIGIN());
  findings.require(whole && spacing && origin && std::equal(extent, extent + 6, whole) &&
                     std::equal(lengths, lengths + 3, spacing) && std::equal(first, first + 3, origin),
    "image-grid",
    "the grid that was announced is another");
}

std::vector<vtkIdType> somePixels(vtkImageData* image, const std::function<int(vtkIdType)>& stateOf)
{
  const vtkIdType columns = image->GetDimensions()[0];
  const vtkIdType count = columns * image->GetDimensions()[1];
  std::vector<vtkIdType> boundary;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const bool isLast = (i + 1) % columns == 0;
    const bool differs = (!isLast && stateOf(i) != stateOf(i + 1)) ||
                         (i + columns < count && stateOf(i) != stateOf(i + columns));
    if (differs)
    {
      boundary.push_back(i);
    }
  }
  Random random("pixels", static_cast<std::uint64_t>(count));
  std::vector<vtkIdType> pixels;
  for (int n = 0; n < MostPixels; ++n)
  {
    const vtkIdType any = random.integer(0, static_cast<int>(count - 1));
    const vtkIdType near = boundary.empty() ? any : random.pick(boundary);
    const vtkIdType beside = n % 4 == 1 ? 1 : n % 4 == 3 ? columns : 0;
    pixels.push_back(n % 2 == 0 ? any : std::min(near + beside, count - 1));
  }
  return pixels;
}

} // namespace fuzz
