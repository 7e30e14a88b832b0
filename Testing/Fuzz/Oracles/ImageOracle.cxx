// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImageOracle.h"

#include "FlatPlaces.h"
#include "PixelGrid.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFlatMapImage.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace fuzz
{
namespace
{

// The rounding of a sum of three products, as a share of the greatest value.
constexpr long double DoubleRounding = 1e-15L;
constexpr long double FloatRounding = 2e-7L;
// How far from the end of the margin a pixel may be in it or not, in pixels.
constexpr long double MarginRounding = 1e-9L;
// How much farther than the nearest position that of a pixel in the margin may be, in pixels: beside
// needles CGAL's search takes one that is farther by the height of a needle.
constexpr long double MarginSlack = 1e-3L;

// An array of the map and what it has become in the image.
struct Pair
{
  vtkAbstractArray* From;
  vtkAbstractArray* To;
};

struct Image
{
  Triangles Map;
  Square Around;
  vtkImageData* Data;
  std::vector<Pair> PointArrays;
  std::vector<Pair> CellArrays;
  vtkDataArray* CellId;
  vtkDataArray* InMap;
  long double Reach; // of the margin
};

bool isFloatingPoint(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

// Whether a tuple of an array has the values of a tuple of another.
bool hasTuple(const Pair& pair, vtkIdType to, vtkIdType from)
{
  const int components = pair.From->GetNumberOfComponents();
  for (int k = 0; k < components; ++k)
  {
    const vtkVariant expected = pair.From->GetVariantValue(from * components + k);
    const vtkVariant value = pair.To->GetVariantValue(to * components + k);
    const bool areNumbers = isFloatingPoint(pair.From);
    if (areNumbers && std::isnan(expected.ToDouble()) && std::isnan(value.ToDouble()))
    {
      continue;
    }
    if (!(expected == value))
    {
      return false;
    }
  }
  return true;
}

bool isBlank(vtkAbstractArray* array, vtkIdType tuple)
{
  const int components = array->GetNumberOfComponents();
  for (int k = 0; k < components; ++k)
  {
    const vtkVariant value = array->GetVariantValue(tuple * components + k);
    const bool holds = isFloatingPoint(array) ? std::isnan(value.ToDouble())
                       : value.IsString()     ? value.ToString().empty()
                                              : value.ToDouble() == 0.0;
    if (!holds)
    {
      return false;
    }
  }
  return true;
}

// Fills the pairs of arrays, whose names do not depend on the values.
void pairArrays(vtkDataSetAttributes* from,
  bool ofCells,
  Image& image,
  std::set<std::string>& names,
  Findings& findings)
{
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (!array->GetName() || array == from->GetGlobalIds())
    {
      continue;
    }
    std::string name = array->GetName();
    while (ofCells && names.count(name) > 0)
    {
      name += "Cell";
    }
    names.insert(name);
    if (name == "CellId" || name == "InMap") // the filter's own
    {
      continue;
    }
    vtkAbstractArray* to = image.Data->GetPointData()->GetAbstractArray(name.c_str());
    const bool isAlike = to && to->GetDataType() == array->GetDataType() &&
                         to->GetNumberOfComponents() == array->GetNumberOfComponents();
    findings.require(isAlike, "image-arrays", "the array " + name + " is missing, or of another type");
    if (isAlike)
    {
      (ofCells ? image.CellArrays : image.PointArrays).push_back({ array, to });
    }
  }
}

// Whether an interpolated array has the values of the place.
bool isInterpolated(const Image& image,
  const Pair& pair,
  const FlatPlace& place,
  vtkIdType pixel,
  long double placeError)
{
  auto* from = vtkDataArray::SafeDownCast(pair.From);
  auto* to = vtkDataArray::SafeDownCast(pair.To);
  for (int k = 0; k < from->GetNumberOfComponents(); ++k)
  {
    std::array<long double, 3> corners;
    long double greatest = 0.0L;
    for (int c = 0; c < 3; ++c)
    {
      corners[c] = from->GetComponent(image.Map.Faces[place.Face][c], k);
      greatest = std::isfinite(corners[c]) ? std::max(greatest, std::abs(corners[c])) : HUGE_VALL;
    }
    if (!std::isfinite(greatest)) // a number times 0 is none, and whether a weight is 0 is rounding
    {
      continue;
    }
    const Interval expected = valuesAt(place, corners, placeError);
    const long double rounding =
      greatest * (from->GetDataType() == VTK_FLOAT ? FloatRounding : DoubleRounding);
    const long double value = to->GetComponent(pixel, k);
    if (!(value >= expected.Low - rounding && value <= expected.High + rounding))
    {
      return false;
    }
  }
  return true;
}

// Whether an array that is not interpolated has the value of the corner with the greatest weight.
bool isOfCorner(const Image& image,
  const Pair& pair,
  const FlatPlace& place,
  vtkIdType pixel,
  long double placeError)
{
  std::array<Interval, 3> weights;
  long double greatest = 0.0L;
  for (int k = 0; k < 3; ++k)
  {
    const long double error = weightRounding(place, k, placeError);
    weights[k] = { place.Weights[k] - error, place.Weights[k] + error };
    greatest = std::max(greatest, weights[k].Low);
  }
  for (int k = 0; k < 3; ++k)
  {
    if (weights[k].High >= greatest && hasTuple(pair, pixel, image.Map.Faces[place.Face][k]))
    {
      return true;
    }
  }
  return false;
}

// The name of an array that has not the values of a place, which is off by at most @p placeError; empty
// if there is none.
std::string arrayUnlike(const Image& image,
  const FlatPlace& place,
  vtkIdType pixel,
  long double placeError)
{
  for (const Pair& pair : image.PointArrays)
  {
    if (!(isFloatingPoint(pair.From) ? isInterpolated(image, pair, place, pixel, placeError)
                                     : isOfCorner(image, pair, place, pixel, placeError)))
    {
      return pair.To->GetName();
    }
  }
  for (const Pair& pair : image.CellArrays)
  {
    if (!hasTuple(pair, pixel, static_cast<vtkIdType>(place.Face)))
    {
      return pair.To->GetName();
    }
  }
  return {};
}

void checkBlank(const Image& image, vtkIdType pixel, Findings& findings)
{
  for (const std::vector<Pair>* pairs : { &image.PointArrays, &image.CellArrays })
  {
    for (const Pair& pair : *pairs)
    {
      findings.require(isBlank(pair.To, pixel),
        "image-outside",
        std::string(pair.To->GetName()) + " has a value at pixel " + std::to_string(pixel) +
          ", far from the map");
    }
  }
}

bool isBlankEverywhere(const Image& image, vtkIdType pixel)
{
  Findings faults;
  checkBlank(image, pixel, faults);
  return faults.Failures.empty();
}

void checkPixel(const Image& image, vtkIdType pixel, Findings& findings)
{
  const Point centre = centreOf(image.Data, pixel);
  const std::vector<FlatPlace> places = nearestPlaces(image.Map, centre, placeRounding(image.Around));
  if (places.empty())
  {
    findings.fail("image-mask", "an image of a map without area");
    return;
  }
  const long double distance = places.front().Distance;
  const long double boundary = boundaryRounding(image.Around);
  const std::string at = " at pixel " + std::to_string(pixel);
  if (image.InMap->GetTuple1(pixel) != 0.0)
  {
    findings.require(distance <= boundary, "image-mask", "InMap is 1" + at + ", outside of the map");
    const FlatPlace place =
      placeOn(image.Map, static_cast<std::size_t>(image.CellId->GetTuple1(pixel)), centre);
    findings.require(place.Distance <= boundary, "image-cell", "CellId is a triangle elsewhere" + at);
    const std::string array = arrayUnlike(image, place, pixel, placeRounding(image.Around));
    findings.require(array.empty(), "image-value", array + " is not that of the triangle" + at);
    return;
  }
  findings.require(distance > 0.0L, "image-mask", "InMap is 0" + at + ", which lies in the map");
  const long double rounding =
    MarginRounding * image.Data->GetSpacing()[0] + placeRounding(image.Around) + boundary;
  if (distance > image.Reach + rounding)
  {
    checkBlank(image, pixel, findings);
    return;
  }
  std::string array;
  const long double slack = rounding + MarginSlack * image.Data->GetSpacing()[0];
  const std::vector<FlatPlace> nearby = nearestPlaces(image.Map, centre, slack);
  const bool holds = std::any_of(nearby.begin(),
    nearby.end(),
    [&](const FlatPlace& place)
    {
      array = arrayUnlike(image, place, pixel, slack);
      return array.empty();
    });
  const bool mayBeBlank = distance >= image.Reach - rounding;
  findings.require(holds || (mayBeBlank && isBlankEverywhere(image, pixel)),
    "image-margin",
    array + " is not that of the nearest position" + at);
}

void checkFigures(const Image& image, Findings& findings)
{
  const vtkIdType faces = static_cast<vtkIdType>(image.Map.Faces.size());
  vtkIdType inMap = 0;
  bool agree = true;
  for (vtkIdType i = 0; i < image.Data->GetNumberOfPoints(); ++i)
  {
    const double flag = image.InMap->GetTuple1(i);
    const double cell = image.CellId->GetTuple1(i);
    inMap += flag == 1.0;
    agree = agree && (flag == 1.0 ? cell >= 0.0 && cell < static_cast<double>(faces)
                                  : flag == 0.0 && cell == -1.0);
  }
  findings.require(agree, "image-mask", "InMap and CellId do not agree");
  findings.require(figure(image.Data, "PixelsInMap") == static_cast<double>(inMap),
    "image-figures",
    "PixelsInMap is not the number of pixels in the map");
  findings.require(figure(image.Data, "PixelLength") == image.Data->GetSpacing()[0],
    "image-figures",
    "PixelLength is not the side of a pixel");
}

// Whether the number of pixels is what the settings ask for.
void checkSize(vtkFlatMapImage* filter, const Image& image, Findings& findings)
{
  const int size = image.Data->GetDimensions()[0];
  const long double greatest = filter->GetPixelLength();
  const bool holds = greatest > 0.0L
                       ? image.Around.Side / size <= greatest * (1.0L + 1e-12L) &&
                           (size == 2 || image.Around.Side / (size - 1) >= greatest * (1.0L - 1e-12L))
                       : size == filter->GetSize();
  findings.require(
    holds, "image-grid", std::to_string(size) + " pixels per side are not what the settings ask for");
}

} // namespace

void checkImage(vtkFlatMapImage* filter, Findings& findings)
{
  auto* map = vtkPolyData::SafeDownCast(filter->GetInputDataObject(0, 0));
  Image image{ trianglesOf(map), {}, filter->GetOutput(), {}, {}, nullptr, nullptr, 0.0L };
  image.Around = squareAround(image.Map);
  image.Reach = static_cast<long double>(filter->GetMargin()) * image.Data->GetSpacing()[0];
  checkSize(filter, image, findings);
  checkPixelGrid(filter->GetOutputInformation(0), image.Data, image.Around, findings);
  std::set<std::string> names;
  pairArrays(map->GetPointData(), false, image, names, findings);
  pairArrays(map->GetCellData(), true, image, names, findings);
  vtkPointData* arrays = image.Data->GetPointData();
  vtkDataArray* points = arrays->GetArray("SurfacePoints");
  image.CellId = arrays->GetArray("CellId");
  image.InMap = arrays->GetArray("InMap");
  if (!points || points->GetDataType() != VTK_DOUBLE || !image.CellId ||
      image.CellId->GetDataType() != VTK_ID_TYPE || !image.InMap ||
      image.InMap->GetDataType() != VTK_UNSIGNED_CHAR)
  {
    findings.fail("image-arrays", "an image without SurfacePoints, CellId or InMap of the right type");
    return;
  }
  checkFigures(image, findings);
  if (!findings.Failures.empty()) // a CellId may be out of range
  {
    return;
  }
  const auto stateOf = [&](vtkIdType pixel)
  {
    return image.InMap->GetTuple1(pixel) != 0.0 ? 2 : std::isnan(points->GetComponent(pixel, 0)) ? 0 : 1;
  };
  for (const vtkIdType pixel : somePixels(image.Data, stateOf))
  {
    checkPixel(image, pixel, findings);
  }
}

} // namespace fuzz
