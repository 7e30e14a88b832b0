// SPDX-License-Identifier: GPL-3.0-or-later
#include "RegionOracle.h"

#include "MapOracle.h"
#include "MeshLengths.h"
#include "RegionCurves.h"
#include "RegionFigures.h"
#include "RegionOriginals.h"

#include <vtkDataArray.h>
#include <vtkFlattenRegion.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace fuzz
{
namespace
{

// The faces that the settings choose, before any is added or left out.
FaceSet chosenFaces(vtkFlattenRegion* filter, const Triangles& surface, vtkDataArray* labels)
{
  std::vector<bool> points(surface.Points.size());
  FaceSet faces(surface.Faces.size());
  bool ofCells = false;
  if (filter->GetRegionFrom() == vtkFlattenRegion::LABEL)
  {
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      points[p] = labels->GetTuple1(static_cast<vtkIdType>(p)) == filter->GetLabel();
    }
  }
  else
  {
    auto* node = vtkSelection::SafeDownCast(filter->GetInputDataObject(1, 0))->GetNode(0);
    auto* ids = vtkDataArray::SafeDownCast(node->GetSelectionList());
    ofCells = node->GetFieldType() == vtkSelectionNode::CELL;
    std::vector<bool>& selected = ofCells ? faces : points;
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      const double id = ids->GetTuple1(i);
      if (id >= 0.0 && id < static_cast<double>(selected.size()))
      {
        selected[static_cast<std::size_t>(id)] = true;
      }
    }
  }
  for (std::size_t f = 0; f < faces.size() && !ofCells; ++f)
  {
    const Triangle& face = surface.Faces[f];
    faces[f] = points[face[0]] + points[face[1]] + points[face[2]] >= 2;
  }
  return faces;
}

// The faces of the input of which the output has parts, or has parts in the region if @p inRegion.
FaceSet coveredFaces(const Region& region, bool inRegion)
{
  FaceSet covered(region.Surface.Faces.size());
  for (std::size_t c = 0; c < region.CellIds.size(); ++c)
  {
    if (!inRegion || region.InRegion[c])
    {
      covered[region.CellIds[c]] = true;
    }
  }
  return covered;
}

// Whether the region is the largest piece of the chosen faces, with its holes filled.
void checkPiece(const Region& region,
  vtkFlattenRegion* filter,
  const FaceSet& chosen,
  Findings& findings)
{
  vtkPolyData* output = filter->GetOutput();
  const std::vector<FaceSet> pieces = piecesOf(region.Surface, chosen);
  findings.require(figure(output, "RegionPieces") == static_cast<double>(pieces.size()),
    "region-figures",
    "RegionPieces is not " + std::to_string(pieces.size()));
  const FaceSet covered = coveredFaces(region, true);
  const auto kept = std::find_if(
    pieces.begin(), pieces.end(), [&](const FaceSet& piece) { return isIn(piece, covered); });
  if (kept == pieces.end())
  {
    findings.fail("region-piece", "no piece of the chosen faces is all in the region");
    return;
  }
  const Measure area = areaWhere(region.Surface, *kept);
  const Measure all = areaWhere(region.Surface, chosen);
  const bool isLargest = std::any_of(pieces.begin(),
    pieces.end(),
    [&](const FaceSet& piece)
    {
      return isIn(piece, covered) && std::all_of(pieces.begin(),
                                       pieces.end(),
                                       [&](const FaceSet& other)
                                       {
                                         return areaWhere(region.Surface, other).Value <=
                                                areaWhere(region.Surface, piece).Value + all.Rounding;
                                       });
    });
  findings.require(isLargest, "region-piece", "the piece that was kept is not the largest");
  if (pieces.size() == 1)
  {
    checkMeasure("DroppedArea", figure(output, "DroppedArea"), { 0.0L, 2.0L * all.Rounding }, findings);
  }
  if (touchesItself(partOf(region.Surface, *kept)))
  {
    return; // Faces are added around the points where it does.
  }
  const std::vector<FaceSet> holes = holesIn(region.Surface, *kept);
  const Measure filled = areaWhere(region.Surface, joined(FaceSet(covered.size()), holes));
  findings.require(covered == joined(*kept, holes),
    "region-piece",
    "the region is not the largest piece with its holes filled");
  findings.require(figure(output, "FilledHoles") == static_cast<double>(holes.size()),
    "region-figures",
    "FilledHoles is not " + std::to_string(holes.size()));
  checkMeasure("FilledArea", figure(output, "FilledArea"), filled, findings);
  checkMeasure("DroppedArea",
    figure(output, "DroppedArea"),
    { all.Value - area.Value, 2.0L * all.Rounding },
    findings);
  findings.require(
    filled.Value - filled.Rounding <= filter->GetLargestHoles() * (area.Value + area.Rounding),
    "region-holes",
    "holes that are larger than LargestHoles were filled");
}

// Whether the output has the faces within the width of the margin, and no others.
void checkMargin(const Region& region,
  vtkFlattenRegion* filter,
  const FaceSet& chosen,
  Findings& findings)
{
  const long double margin = figure(filter->GetOutput(), "Margin");
  if (filter->GetAutomaticMargin())
  {
    const long double edges = margin / meanSide(partOf(region.Surface, chosen));
    findings.require(margin == 0.0L || (edges < 4.5L && std::abs(edges - std::round(edges)) < 1e-9L),
      "region-margin",
      "Margin is " + std::to_string(static_cast<double>(edges)) + " mean edges of the region");
  }
  else
  {
    findings.require(
      margin == filter->GetMargin(), "region-margin", "Margin is not the one that was set");
  }
  const FaceSet core = coveredFaces(region, true);
  const FaceSet covered = coveredFaces(region, false);
  std::vector<vtkIdType> sources;
  for (const Triangle& face : partOf(region.Surface, core).Faces)
  {
    sources.insert(sources.end(), face.begin(), face.end());
  }
  const std::vector<long double> distance = distancesFrom(region.Surface, sources);
  FaceSet within(core.size());
  FaceSet nearly(core.size());
  for (std::size_t f = 0; f < core.size(); ++f)
  {
    const Triangle& face = region.Surface.Faces[f];
    const long double farthest = std::max({ distance[face[0]], distance[face[1]], distance[face[2]] });
    within[f] = core[f] || (margin > 0.0L && farthest <= margin * (1.0L - SumRounding));
    nearly[f] = core[f] || (margin > 0.0L && farthest <= margin * (1.0L + SumRounding));
  }
  findings.require(
    isIn(within, covered), "region-margin", "a face within the width of the margin is missing");
  if (within == nearly && !touchesItself(partOf(region.Surface, within)))
  {
    findings.require(covered == joined(within, holesIn(region.Surface, within)),
      "region-margin",
      "a face beyond the margin that is not in a hole");
  }
}

} // namespace

void checkRegion(vtkFlattenRegion* filter, vtkPolyData* input, vtkDataArray* labels, Findings& findings)
{
  vtkPolyData* output = filter->GetOutput();
  const std::optional<Region> read = readRegion(output, input, findings);
  if (!read)
  {
    return;
  }
  const Region& region = *read;
  findings.require(isDisk(region.Flat), "region-disk", "the output is not a disk");
  findings.require(isDisk(partOf(region.Flat, region.InRegion)),
    "region-disk",
    "the region without its margin is not a disk");
  checkMap(output, true, findings);
  checkIds(region, findings);
  const FaceSet chosen = chosenFaces(filter, region.Surface, labels);
  checkPiece(region, filter, chosen, findings);
  checkMargin(region, filter, chosen, findings);
  checkAreas(region, output, findings);
  if (checkTable(filter, findings))
  {
    checkCurves(region, filter, findings);
    checkPointValues(region, output, labels, findings);
  }
}

} // namespace fuzz
