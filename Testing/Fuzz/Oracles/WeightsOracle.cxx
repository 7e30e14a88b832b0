// SPDX-License-Identifier: GPL-3.0-or-later
#include "WeightsOracle.h"

#include "Triangles.h"

#include <vtkAreaWeights.h>
#include <vtkCellData.h>
#include <vtkContextResolution.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImplicitFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace fuzz
{
namespace
{

// The rounding of a sum of areas and weights, as a share of it.
constexpr long double SumRounding = 1e-9L;
// The rounding of the area of a needle, as a share of its squared length.
constexpr long double NeedleRounding = 1e-14L;

using Flags = std::vector<bool>; // one per point

/// The areas around points, and what they may be off.
struct Areas
{
  std::vector<long double> Of;
  std::vector<long double> Rounding;
};

Areas areasOf(const Triangles& mesh)
{
  Areas areas;
  areas.Of.assign(mesh.Points.size(), 0.0L);
  areas.Rounding = areas.Of;
  for (const Triangle& face : mesh.Faces)
  {
    const long double area = areaOf(mesh, face);
    for (const vtkIdType p : face)
    {
      areas.Of[p] += area / 3.0L;
      areas.Rounding[p] += SumRounding * area + NeedleRounding * greatestSquaredSide(mesh, face);
    }
  }
  return areas;
}

Flags selectedPoints(vtkAreaWeights* filter, const Triangles& mesh)
{
  auto* node = vtkSelection::SafeDownCast(filter->GetInputDataObject(1, 0))->GetNode(0);
  auto* ids = vtkDataArray::SafeDownCast(node->GetSelectionList());
  const bool ofCells = node->GetFieldType() == vtkSelectionNode::CELL;
  Flags inside(mesh.Points.size());
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const auto id = static_cast<std::ptrdiff_t>(ids->GetTuple1(i));
    const std::size_t count = ofCells ? mesh.Faces.size() : mesh.Points.size();
    if (id < 0 || id >= static_cast<std::ptrdiff_t>(count))
    {
      continue;
    }
    for (int k = 0; k < (ofCells ? 3 : 1); ++k)
    {
      inside[ofCells ? mesh.Faces[id][k] : id] = true;
    }
  }
  return inside;
}

// The points of the region. The table has the label 1 alone.
Flags regionOf(vtkAreaWeights* filter, vtkPolyData* input, const Triangles& mesh, vtkDataArray* labels)
{
  if (filter->GetWeightsFrom() == vtkAreaWeights::SELECTION)
  {
    return selectedPoints(filter, mesh);
  }
  Flags inside(mesh.Points.size());
  for (std::size_t p = 0; p < inside.size(); ++p)
  {
    const auto id = static_cast<vtkIdType>(p);
    if (filter->GetWeightsFrom() == vtkAreaWeights::IMPLICIT_FUNCTION)
    {
      const double value = filter->GetImplicitFunction()->FunctionValue(input->GetPoint(id));
      inside[p] = filter->GetInsideOut() ? value >= 0.0 : value <= 0.0;
    }
    else
    {
      const bool isTable = filter->GetWeightsFrom() == vtkAreaWeights::LABEL_TABLE;
      inside[p] = labels->GetTuple1(id) == (isTable ? 1 : filter->GetLabel());
    }
  }
  return inside;
}

void expect(vtkPolyData* output,
  const char* name,
  long double value,
  long double rounding,
  Findings& findings)
{
  const long double reported = figure(output, name);
  findings.require(std::abs(reported - value) <= rounding,
    "weights-figures",
    std::string(name) + " is " + std::to_string(static_cast<double>(reported / value)) +
      " of what it should be");
}

// The new factors: the output's weights without those of the input.
std::vector<long double> factorsOf(vtkPolyData* input, vtkDataArray* weights)
{
  vtkDataArray* earlier = input->GetPointData()->GetArray("AreaWeight");
  std::vector<long double> factors;
  for (vtkIdType p = 0; p < weights->GetNumberOfTuples(); ++p)
  {
    factors.push_back(
      weights->GetTuple1(p) / static_cast<long double>(earlier ? earlier->GetTuple1(p) : 1.0));
  }
  return factors;
}

// Whether points inside the region have its factor, and with sharp edges all others another.
void checkFactors(vtkAreaWeights* filter,
  const Flags& inside,
  const std::vector<long double>& factors,
  const Areas& areas,
  const std::vector<long double>& before,
  Findings& findings)
{
  const bool isSharp = filter->GetEdgeWidth() == 0.0;
  const bool isTable = filter->GetWeightsFrom() == vtkAreaWeights::LABEL_TABLE;
  const bool isRelative = filter->GetFactorMeaning() == vtkAreaWeights::RELATIVE_TO_REST;
  long double least[2] = { HUGE_VALL, HUGE_VALL };
  long double greatest[2] = { 0.0L, 0.0L };
  long double sums[2] = { 0.0L, 0.0L };
  long double rounding = 0.0L;
  for (std::size_t p = 0; p < inside.size(); ++p)
  {
    least[inside[p]] = std::min(least[inside[p]], factors[p]);
    greatest[inside[p]] = std::max(greatest[inside[p]], factors[p]);
    sums[0] += before[p] * areas.Of[p];
    sums[1] += factors[p] * before[p] * areas.Of[p];
    rounding += (1.0L + factors[p]) * before[p] * areas.Rounding[p];
  }
  findings.require(greatest[1] <= least[1] * (1.0L + SumRounding),
    "weights-factor",
    "the points of the region have several factors");
  findings.require(isTable || std::abs(least[1] - filter->GetFactor()) <= SumRounding * least[1],
    "weights-factor",
    "the points of the region have another factor");
  if (isSharp)
  {
    findings.require(greatest[0] <= least[0] * (1.0L + SumRounding),
      "weights-factor",
      "the points outside the region have several factors");
    findings.require(
      !isRelative || least[0] == 1.0L, "weights-factor", "the factor of the rest is not 1");
  }
  // A magnified region has its factor only if the total of the areas stays as it was.
  findings.require(isRelative || std::abs(sums[1] - sums[0]) <= SumRounding * sums[0] + rounding,
    "weights-factor",
    "magnification changes the total to " + std::to_string(static_cast<double>(sums[1] / sums[0])));
}

void checkScalars(vtkAreaWeights* filter,
  vtkDataArray* labels,
  const std::vector<long double>& factors,
  Findings& findings)
{
  vtkPiecewiseFunction* curve = filter->GetTransferCurve();
  for (std::size_t p = 0; p < factors.size(); ++p)
  {
    const double value = labels->GetTuple1(static_cast<vtkIdType>(p));
    // The curve of the campaign goes from (0, 1) to a point at 2.
    double end[4] = { 2.0, value, 0.5, 0.0 };
    if (curve->GetSize() == 2)
    {
      curve->GetNodeValue(1, end);
    }
    const long double expected =
      curve->GetSize() == 2 ? 1.0L + (end[1] - 1.0L) * std::clamp(value, 0.0, 2.0) / 2.0L : value;
    findings.require(std::abs(factors[p] - expected) <= SumRounding * expected,
      "weights-factor",
      "a factor is not the value of the transfer curve");
  }
}

// Whether the figures of the region are true.
// @param scale what a weight is multiplied by for the area on the map, and @p share its rounding
void checkRegions(vtkAreaWeights* filter,
  const Flags& inside,
  const std::vector<long double>& factors,
  const Areas& areas,
  long double scale,
  long double share,
  Findings& findings)
{
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* weights = output->GetPointData()->GetArray("AreaWeight");
  long double area = 0.0L;
  long double flatArea = 0.0L;
  long double off[2] = { 0.0L, 0.0L };
  std::vector<long double> before;
  for (std::size_t p = 0; p < inside.size(); ++p)
  {
    const long double weight = weights->GetTuple1(static_cast<vtkIdType>(p));
    before.push_back(weight / factors[p]);
    if (inside[p])
    {
      area += areas.Of[p];
      flatArea += scale * weight * areas.Of[p];
      off[0] += areas.Rounding[p];
      off[1] += scale * weight * areas.Rounding[p];
    }
  }
  expect(output,
    "RegionPoints",
    static_cast<long double>(std::count(inside.begin(), inside.end(), true)),
    0.0L,
    findings);
  expect(output, "RegionArea", area, off[0], findings);
  expect(output, "RegionFlatArea", flatArea, off[1] + share * flatArea, findings);
  checkFactors(filter, inside, factors, areas, before, findings);
}

} // namespace

void checkWeights(vtkAreaWeights* filter, vtkPolyData* input, vtkDataArray* labels, Findings& findings)
{
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* weights = output->GetPointData()->GetArray("AreaWeight");
  if (!weights)
  {
    findings.fail("weights-arrays", "no AreaWeight");
    return;
  }
  const Triangles mesh = trianglesOf(input, "SurfacePoints");
  const Areas areas = areasOf(mesh);
  long double sums[2] = { 0.0L, 0.0L };
  long double rounding[2] = { 0.0L, 0.0L };
  long double range[2] = { HUGE_VALL, 0.0L };
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    const double weight = weights->GetTuple1(static_cast<vtkIdType>(p));
    findings.require(std::isfinite(weight) && weight > 0.0,
      "weights-positive",
      "a weight is " + std::to_string(weight));
    sums[0] += areas.Of[p];
    sums[1] += weight * areas.Of[p];
    rounding[0] += areas.Rounding[p];
    rounding[1] += weight * areas.Rounding[p];
    range[0] = std::min<long double>(range[0], weight);
    range[1] = std::max<long double>(range[1], weight);
  }
  const long double scale = sums[0] / sums[1];
  const long double share = SumRounding + rounding[0] / sums[0] + rounding[1] / sums[1];
  expect(output, "SmallestMagnification", range[0] * scale, share * range[0] * scale, findings);
  expect(output, "GreatestMagnification", range[1] * scale, share * range[1] * scale, findings);
  const std::vector<long double> factors = factorsOf(input, weights);
  if (filter->GetWeightsFrom() == vtkAreaWeights::SCALARS)
  {
    findings.require(!output->GetFieldData()->HasArray("RegionArea"),
      "weights-figures",
      "RegionArea of scalars, which have no region");
    checkScalars(filter, labels, factors, findings);
    return;
  }
  checkRegions(filter, regionOf(filter, input, mesh, labels), factors, areas, scale, share, findings);
}

namespace
{

// The figures of a shape that stay: points less edges plus faces, and the number of boundaries.
std::pair<std::ptrdiff_t, std::size_t> topologyOf(const Triangles& mesh)
{
  std::set<vtkIdType> points;
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  for (const Triangle& face : mesh.Faces)
  {
    points.insert(face.begin(), face.end());
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType a = face[k];
      const vtkIdType b = face[(k + 1) % 3];
      edges.insert({ std::min(a, b), std::max(a, b) });
    }
  }
  return { static_cast<std::ptrdiff_t>(points.size() + mesh.Faces.size()) -
             static_cast<std::ptrdiff_t>(edges.size()),
    boundaryLoops(mesh).size() };
}

// A face that begins with its smallest corner.
Triangle turned(Triangle face)
{
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

} // namespace

void checkContext(vtkContextResolution* filter,
  vtkPolyData* input,
  vtkDataArray* labels,
  Findings& findings)
{
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* pointIds = output->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* cellIds = output->GetCellData()->GetArray("vtkOriginalCellIds");
  const Triangles before = trianglesOf(input);
  const Triangles after = trianglesOf(output);
  if (!pointIds || !cellIds ||
      cellIds->GetNumberOfTuples() != static_cast<vtkIdType>(after.Faces.size()))
  {
    findings.fail("context-ids", "an array is missing, or there are cells that are no triangles");
    return;
  }
  std::vector<vtkIdType> origins;
  std::set<vtkIdType> kept;
  for (std::size_t p = 0; p < after.Points.size(); ++p)
  {
    const auto id = static_cast<vtkIdType>(pointIds->GetTuple1(static_cast<vtkIdType>(p)));
    findings.require(
      id >= -1 && id < input->GetNumberOfPoints(), "context-ids", "a point id out of range");
    findings.require(id < 0 || before.Points[id] == after.Points[p],
      "context-ids",
      "point " + std::to_string(p) + " is not where its original " + std::to_string(id) + " is");
    findings.require(id < 0 || kept.insert(id).second,
      "context-ids",
      "point " + std::to_string(id) + " of the input is there twice");
    origins.push_back(id);
  }
  // The cells of the output, with the points of the input and the cell that they say they are.
  std::set<std::pair<Triangle, vtkIdType>> cells;
  for (std::size_t c = 0; c < after.Faces.size(); ++c)
  {
    const Triangle& face = after.Faces[c];
    const auto id = static_cast<vtkIdType>(cellIds->GetTuple1(static_cast<vtkIdType>(c)));
    findings.require(id >= 0 && id < input->GetNumberOfCells(), "context-ids", "a cell id out of range");
    cells.insert({ turned({ origins[face[0]], origins[face[1]], origins[face[2]] }), id });
  }
  vtkIdType around = 0;
  for (std::size_t f = 0; f < before.Faces.size(); ++f)
  {
    const Triangle& face = before.Faces[f];
    if (std::any_of(face.begin(), face.end(), [&](vtkIdType p) { return labels->GetTuple1(p) != 0.0; }))
    {
      ++around;
      findings.require(cells.count({ turned(face), static_cast<vtkIdType>(f) }) == 1,
        "context-region",
        "cell " + std::to_string(f) + " at a region was changed, or has another id");
    }
  }
  vtkIdType points = 0;
  for (vtkIdType p = 0; p < labels->GetNumberOfTuples(); ++p)
  {
    points += labels->GetTuple1(p) != 0.0;
  }
  const auto context = static_cast<vtkIdType>(after.Faces.size()) - around;
  const auto contextBefore = static_cast<vtkIdType>(before.Faces.size()) - around;
  const auto require = [&](const char* name, vtkIdType value)
  {
    findings.require(figure(output, name) == static_cast<double>(value),
      "context-figures",
      std::string(name) + " is not " + std::to_string(value));
  };
  require("RegionPoints", points);
  require("KeptCells", around);
  require("ContextCells", context);
  findings.require(
    context <= contextBefore, "context-figures", "the context has more cells than before");
  findings.require(contextBefore > filter->GetContextFaces() || context == contextBefore,
    "context-figures",
    "a context that is small enough was changed");
  findings.require(
    topologyOf(before) == topologyOf(after), "context-topology", "the topology has changed");
}

} // namespace fuzz
