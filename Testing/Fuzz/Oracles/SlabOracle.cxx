// SPDX-License-Identifier: GPL-3.0-or-later
#include "SlabOracle.h"

#include "PixelGrid.h"
#include "VoxelValues.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFlatMapSlab.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace fuzz
{
namespace
{

constexpr vtkIdType MostPoints = 200;

struct Slab
{
  vtkFlatMapSlab* Filter;
  vtkImageData* Volume;
  vtkPolyData* Output;
  vtkImageData* Stack;
  Triangles Map;
  Triangles Surface;
  Square Around;
  std::vector<Point> Normals; // those of the output, once they are found to be right
  std::vector<double> Depths;
  double Sign; // of the normals
};

using Vector = std::array<long double, 3>;

// Whether the normals are those of the triangles around each point, weighted by their areas.
void checkNormals(const Slab& slab, Findings& findings)
{
  std::vector<Vector> sums(slab.Surface.Points.size());
  std::vector<long double> errors(slab.Surface.Points.size());
  for (const Triangle& face : slab.Surface.Faces)
  {
    Vector u;
    Vector v;
    long double lengths[2] = { 0.0L, 0.0L };
    for (int k = 0; k < 3; ++k)
    {
      const long double from = slab.Surface.Points[face[0]][k];
      u[k] = slab.Surface.Points[face[1]][k] - from;
      v[k] = slab.Surface.Points[face[2]][k] - from;
      lengths[0] += u[k] * u[k];
      lengths[1] += v[k] * v[k];
    }
    const Vector area = {
      u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
    };
    for (const vtkIdType p : face)
    {
      errors[p] += 1e-15L * std::sqrt(lengths[0]) * std::sqrt(lengths[1]);
      for (int k = 0; k < 3; ++k)
      {
        sums[p][k] += area[k];
      }
    }
  }
  for (std::size_t p = 0; p < sums.size(); ++p)
  {
    const long double length = std::hypot(sums[p][0], sums[p][1], sums[p][2]);
    const Point& normal = slab.Normals[p];
    const double unit = std::hypot(normal[0], normal[1], normal[2]);
    bool holds = std::abs(unit - 1.0) < 1e-14 || (unit == 0.0 && length <= errors[p]);
    for (int k = 0; k < 3 && length > errors[p]; ++k)
    {
      holds = holds && std::abs(normal[k] - sums[p][k] / length) <= 4.0L * errors[p] / length + 1e-15L;
    }
    findings.require(holds, "slab-normals", "the normal of point " + std::to_string(p) + " is wrong");
  }
}

// The sample in tuples of arrays; @p first is the first component of an array with several depths.
Sample sampleOf(const Slab& slab, vtkPointData* arrays, vtkIdType tuple, int depth, bool ofMap)
{
  Sample sample{ arrays->GetArray("InVolume")->GetComponent(tuple, ofMap ? depth : 0) != 0.0, {} };
  for (vtkDataArray* voxels : numbersOf(slab.Volume))
  {
    const int width = voxels->GetNumberOfComponents();
    vtkDataArray* values =
      arrays->GetArray((std::string(voxels->GetName()) + (ofMap ? "Slab" : "")).c_str());
    sample.Values.emplace_back();
    for (int k = 0; k < width; ++k)
    {
      sample.Values.back().push_back(values->GetComponent(tuple, k + (ofMap ? depth * width : 0)));
    }
  }
  return sample;
}

void checkPoints(const Slab& slab, Findings& findings)
{
  const auto count = static_cast<vtkIdType>(slab.Surface.Points.size());
  const vtkIdType step = std::max<vtkIdType>(1, count / MostPoints);
  for (vtkIdType p = 0; p < count; p += step)
  {
    for (std::size_t d = 0; d < slab.Depths.size(); ++d)
    {
      Box3 box;
      for (int k = 0; k < 3; ++k)
      {
        const long double from = slab.Surface.Points[p][k];
        const long double way =
          static_cast<long double>(slab.Depths[d]) * slab.Sign * slab.Normals[p][k];
        const long double rounding = 1e-15L * (std::abs(from) + std::abs(way));
        box[k] = { from + way - rounding, from + way + rounding };
      }
      const Sample sample = sampleOf(slab, slab.Output->GetPointData(), p, static_cast<int>(d), true);
      const std::string fault = faultOf(sample, slab.Volume, box, slab.Filter->GetNearestVoxel());
      findings.require(fault.empty(),
        "slab-point",
        "the sample of point " + std::to_string(p) + " at depth " + std::to_string(slab.Depths[d]) +
          " " + fault);
    }
  }
}

// The unit normal at a place, between those of the corners; false if rounding decides it.
bool normalAt(const Slab& slab, const FlatPlace& place, Box3& normal)
{
  long double squared = 0.0L;
  long double widest = 0.0L;
  for (int k = 0; k < 3; ++k)
  {
    std::array<long double, 3> corners;
    for (int c = 0; c < 3; ++c)
    {
      corners[c] = slab.Normals[slab.Map.Faces[place.Face][c]][k];
    }
    normal[k] = valuesAt(place, corners, placeRounding(slab.Around));
    const long double middle = 0.5L * (normal[k].Low + normal[k].High);
    squared += middle * middle;
    widest = std::max(widest, normal[k].High - normal[k].Low);
  }
  const long double length = std::sqrt(squared);
  if (!(length > 10.0L * widest + 1e-6L))
  {
    return false;
  }
  for (Interval& x : normal)
  {
    const long double middle = 0.5L * (x.Low + x.High) / length;
    const long double error = 2.0L * widest / length + 4e-16L / length;
    x = { middle - error, middle + error };
  }
  return true;
}

// The box in space in which the sample of a pixel of the stack lies, if the pixel shows the given place.
Box3 boxAt(const Slab& slab, const FlatPlace& place, double depth)
{
  Box3 normal;
  if (!normalAt(slab, place, normal))
  {
    normal.fill({ -1.0L, 1.0L });
  }
  Box3 box;
  for (int k = 0; k < 3; ++k)
  {
    std::array<long double, 3> corners;
    long double greatest = std::abs(static_cast<long double>(depth));
    for (int c = 0; c < 3; ++c)
    {
      corners[c] = slab.Surface.Points[slab.Map.Faces[place.Face][c]][k];
      greatest = std::max(greatest, std::abs(corners[c]));
    }
    const Interval from = valuesAt(place, corners, placeRounding(slab.Around));
    const long double way = static_cast<long double>(depth) * slab.Sign;
    const long double ends[2] = { way * normal[k].Low, way * normal[k].High };
    const long double rounding = 1e-15L * greatest;
    box[k] = { from.Low + std::min(ends[0], ends[1]) - rounding,
      from.High + std::max(ends[0], ends[1]) + rounding };
  }
  return box;
}

void checkPixel(const Slab& slab, vtkIdType pixel, Findings& findings)
{
  const vtkIdType perLayer =
    static_cast<vtkIdType>(slab.Stack->GetDimensions()[0]) * slab.Stack->GetDimensions()[1];
  const long double boundary = boundaryRounding(slab.Around);
  const std::vector<FlatPlace> places = nearestPlaces(slab.Map, centreOf(slab.Stack, pixel), boundary);
  for (std::size_t d = 0; d < slab.Depths.size(); ++d)
  {
    const vtkIdType tuple = static_cast<vtkIdType>(d) * perLayer + pixel;
    const Sample sample = sampleOf(slab, slab.Stack->GetPointData(), tuple, static_cast<int>(d), false);
    const auto isNaN = [](const std::vector<double>& values)
    { return std::all_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }); };
    bool holds = !sample.IsInside && (places.empty() || places.front().Distance > 0.0L) &&
                 std::all_of(sample.Values.begin(), sample.Values.end(), isNaN);
    std::string fault = "is outside of the map";
    for (std::size_t n = 0; n < places.size() && !holds && places[n].Distance <= boundary; ++n)
    {
      fault = faultOf(
        sample, slab.Volume, boxAt(slab, places[n], slab.Depths[d]), slab.Filter->GetNearestVoxel());
      holds = fault.empty();
    }
    findings.require(holds,
      "slab-pixel",
      "pixel " + std::to_string(pixel) + " at depth " + std::to_string(slab.Depths[d]) + " " + fault);
  }
}

// Whether the arrays are there, with their types, components and names; nothing else is read otherwise.
bool hasArrays(const Slab& slab, vtkPointData* arrays, bool ofMap)
{
  const int layers = ofMap ? static_cast<int>(slab.Depths.size()) : 1;
  vtkDataArray* mask = arrays->GetArray("InVolume");
  bool holds =
    mask && mask->GetDataType() == VTK_UNSIGNED_CHAR && mask->GetNumberOfComponents() == layers;
  for (vtkDataArray* voxels : numbersOf(slab.Volume))
  {
    const int width = voxels->GetNumberOfComponents();
    vtkDataArray* values =
      arrays->GetArray((std::string(voxels->GetName()) + (ofMap ? "Slab" : "")).c_str());
    const bool isDouble = slab.Filter->GetNearestVoxel() && voxels->GetDataType() != VTK_FLOAT &&
                          voxels->GetDataTypeSize() > 2;
    holds = holds && values && values->GetDataType() == (isDouble ? VTK_DOUBLE : VTK_FLOAT) &&
            values->GetNumberOfComponents() == width * layers;
    for (int k = 0; holds && ofMap && k < width * layers; ++k)
    {
      const char* name = values->GetComponentName(k);
      const double depth = slab.Depths[k / width];
      holds = name && std::abs(std::strtod(name, nullptr) - depth) <= 1e-5 * std::abs(depth);
    }
  }
  return holds;
}

void checkFields(const Slab& slab, vtkDataObject* output, Findings& findings)
{
  vtkDataArray* depths = output->GetFieldData()->GetArray("Depths");
  bool holds = depths && depths->GetNumberOfValues() == static_cast<vtkIdType>(slab.Depths.size());
  for (std::size_t d = 0; holds && d < slab.Depths.size(); ++d)
  {
    holds = depths->GetTuple1(static_cast<vtkIdType>(d)) == slab.Depths[d];
  }
  findings.require(holds, "slab-fields", "Depths are others");
  vtkIdType outside = 0;
  vtkDataArray* mask = slab.Output->GetPointData()->GetArray("InVolume");
  for (vtkIdType p = 0; p < mask->GetNumberOfTuples(); ++p)
  {
    for (int d = 0; d < mask->GetNumberOfComponents(); ++d)
    {
      outside += mask->GetComponent(p, d) == 0.0;
    }
  }
  const double reported = figure(output, "OutsideSamples");
  findings.require(reported == static_cast<double>(outside),
    output == slab.Stack ? "slab-stack-fields" : "slab-fields",
    "OutsideSamples is " + std::to_string(reported) + ", " + std::to_string(outside) + " are outside");
}

// Whether z is the depth, if the depths ascend in equal steps; otherwise layers are one pixel apart.
bool hasLayers(const Slab& slab)
{
  const std::vector<double>& depths = slab.Depths;
  const bool isEqual =
    depths.size() == 2 ? depths[1] > depths[0] : depths == std::vector<double>{ 0.0, 1.0, 2.0 };
  const double* lengths = slab.Stack->GetSpacing();
  return slab.Stack->GetDimensions()[2] == static_cast<int>(depths.size()) &&
         (isEqual ? lengths[2] == depths[1] - depths[0] && slab.Stack->GetOrigin()[2] == depths[0]
                  : lengths[2] == lengths[0]);
}

void checkStack(const Slab& slab, Findings& findings)
{
  if (slab.Filter->GetStackSize() < 2)
  {
    findings.require(
      slab.Stack->GetNumberOfPoints() == 0, "slab-stack", "a stack that was not asked for");
    return;
  }
  const int* size = slab.Stack->GetDimensions();
  if (size[0] != slab.Filter->GetStackSize() || size[1] != size[0] || !hasLayers(slab) ||
      !hasArrays(slab, slab.Stack->GetPointData(), false))
  {
    findings.fail("slab-stack", "the stack has another size, or not the arrays that are promised");
    return;
  }
  checkPixelGrid(slab.Filter->GetOutputInformation(1), slab.Stack, slab.Around, findings);
  checkFields(slab, slab.Stack, findings);
  vtkDataArray* mask = slab.Stack->GetPointData()->GetArray("InVolume");
  const auto stateOf = [mask](vtkIdType pixel) { return static_cast<int>(mask->GetTuple1(pixel)); };
  for (const vtkIdType pixel : somePixels(slab.Stack, stateOf))
  {
    checkPixel(slab, pixel, findings);
  }
}

bool hasPlaceInPatient(vtkDataObject* data)
{
  return data->GetFieldData()->HasArray("PatientMatrix") != 0 ||
         data->GetFieldData()->HasArray("InPatientSpace") != 0;
}

} // namespace

void checkSlab(vtkFlatMapSlab* filter, Findings& findings)
{
  auto* map = vtkPolyData::SafeDownCast(filter->GetInputDataObject(0, 0));
  Slab slab{ filter,
    vtkImageData::SafeDownCast(filter->GetInputDataObject(1, 0)),
    vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)),
    filter->GetStack(),
    trianglesOf(map),
    trianglesOf(map, "SurfacePoints"),
    {},
    {},
    {},
    filter->GetOutwards() ? 1.0 : -1.0 };
  if (hasPlaceInPatient(map) || hasPlaceInPatient(slab.Volume))
  {
    return;
  }
  slab.Around = squareAround(slab.Map);
  for (int d = 0; d < filter->GetNumberOfDepths(); ++d)
  {
    slab.Depths.push_back(filter->GetDepth(d));
  }
  vtkDataArray* normals = slab.Output->GetPointData()->GetArray("SurfaceNormals");
  if (!normals || normals->GetDataType() != VTK_DOUBLE || normals->GetNumberOfComponents() != 3 ||
      !hasArrays(slab, slab.Output->GetPointData(), true) ||
      trianglesOf(slab.Output).Points != slab.Map.Points ||
      trianglesOf(slab.Output).Faces != slab.Map.Faces)
  {
    findings.fail("slab-arrays", "the map is another, or has not the arrays that are promised");
    return;
  }
  slab.Normals = trianglesOf(slab.Output, "SurfaceNormals").Points;
  checkNormals(slab, findings);
  checkFields(slab, slab.Output, findings);
  checkPoints(slab, findings);
  checkStack(slab, findings);
}

} // namespace fuzz
