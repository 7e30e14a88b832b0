// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/MapMeasures.h"

#include "Internal/ArrayConversion.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <utility>
#include <vector>

namespace flattening
{
namespace
{

constexpr const char* LengthErrorName = "LengthError";

// Calls @p visit(name, values) for the measures of the faces.
template <typename Visit>
void forEachFaceMeasure(const FaceDistortion& distortion, const Visit& visit)
{
  visit("AreaDistortion", distortion.AreaDistortion);
  visit("AngleDistortion", distortion.AngleDistortion);
  visit("AreaRatio", distortion.AreaRatio);
  visit("BeltramiMagnitude", distortion.BeltramiMagnitude);
  visit("StretchL2", distortion.StretchL2);
  visit("SymmetricDirichlet", distortion.SymmetricDirichlet);
  visit("AngleError", distortion.AngleError);
}

// Calls @p visit(name, value) for the values of the lengths.
template <typename Visit>
void forEachLengthValue(const LengthDistortion& lengths, const Visit& visit)
{
  const std::pair<const char*, const LengthErrors&> kinds[] = {
    { "Local", lengths.Local }, { "WithinMap", lengths.WithinMap }, { "Global", lengths.Global }
  };
  for (const auto& [kind, errors] : kinds)
  {
    const std::string name = kind + std::string(LengthErrorName);
    visit("Mean" + name, errors.Mean);
    visit("StandardError" + name, errors.StandardError);
    visit("P95" + name, errors.P95);
  }
  visit("RingDistanceError", lengths.RingDistanceError);
  visit("LengthScale", lengths.Local.Scale);
}

} // namespace

void forEachValue(const DistortionSummary& summary,
  const std::function<void(const std::string&, double)>& visit)
{
  visit("SurfaceArea", summary.SurfaceArea);
  visit("FlatArea", summary.FlatArea);
  visit("FacesWithin2Percent", summary.FacesWithin2Percent);
  visit("RootMeanSquareStretch", summary.RootMeanSquareStretch);
  visit("SDAreaRatio", summary.SDAreaRatio);
  visit("SDLogAreaRatio", summary.SDLogAreaRatio);
  for (int m = 0; m < MeasureCount; ++m)
  {
    const std::string name = MeasureNames[m];
    const MeasureStatistics& statistics = summary.Measures[m];
    visit("Mean" + name, statistics.Mean);
    visit("AreaWeightedMean" + name, statistics.AreaWeightedMean);
    visit("P95" + name, statistics.P95);
    visit("P99" + name, statistics.P99);
    visit("Max" + name, statistics.Max);
  }
}

void addMeasures(vtkPolyData* map, const FaceDistortion& distortion)
{
  vtkCellData* cells = map->GetCellData();
  forEachFaceMeasure(distortion,
    [cells](const char* name, const Eigen::VectorXd& values)
    { cells->AddArray(newArray<vtkDoubleArray>(name, values)); });
  std::vector<char> degenerate(distortion.faceCount());
  for (int f = 0; f < distortion.faceCount(); ++f)
  {
    degenerate[f] = distortion.degenerate(f);
  }
  cells->AddArray(newArray<vtkUnsignedCharArray>("Flipped", distortion.Flipped));
  cells->AddArray(newArray<vtkUnsignedCharArray>("Degenerate", degenerate));
}

void setMeasures(vtkFieldData* data, const DistortionSummary& total)
{
  setDatum(data, "FlippedFaces", static_cast<long long>(total.FlippedFaces));
  setDatum(data, "DegenerateFaces", static_cast<long long>(total.DegenerateFaces));
  forEachValue(
    total, [data](const std::string& name, double value) { setDatum(data, name.c_str(), value); });
}

void addLengths(vtkPolyData* map, const LengthDistortion& lengths)
{
  map->GetPointData()->AddArray(newArray<vtkDoubleArray>(LengthErrorName, lengths.VertexErrors));
  forEachLengthValue(lengths,
    [data = map->GetFieldData()](const std::string& name, double value)
    { setDatum(data, name.c_str(), value); });
}

void removeLengths(vtkPolyData* map)
{
  map->GetPointData()->RemoveArray(LengthErrorName);
  forEachLengthValue({},
    [data = map->GetFieldData()](const std::string& name, double) { data->RemoveArray(name.c_str()); });
}

void removeEarlierMeasures(vtkPolyData* map)
{
  removeLengths(map);
  map->GetPointData()->RemoveArray("TargetArea");
  vtkCellData* cells = map->GetCellData();
  forEachFaceMeasure(
    {}, [cells](const char* name, const Eigen::VectorXd&) { cells->RemoveArray(name); });
  cells->RemoveArray("Flipped");
  cells->RemoveArray("Degenerate");
  vtkFieldData* data = map->GetFieldData();
  data->RemoveArray("DegenerateFaces");
  forEachValue({},
    [data](const std::string& name, double)
    {
      if (name != "SurfaceArea") // that of the disk, whatever its map
      {
        data->RemoveArray(name.c_str());
      }
    });
}

void removeEarlierReports(vtkFieldData* data)
{
  for (const char* name : { "NewtonIterations",
         "MaxCurvatureError",
         "LayoutError",
         "SpreadPoints",
         "BoundaryIterations",
         "IntrinsicFlips",
         "AddedLength",
         "RepairedFaces",
         "MovedPoints",
         "GreatestMove",
         "FlippedFaces",
         "BoundaryAnisotropy",
         "Modulus",
         "CornerPointIds",
         "Sites",
         "PowerDiagrams",
         "MaxCellAreaError",
         "CoincidentPoints",
         "Bijective",
         "WarmStart",
         "RefinementRounds",
         "RefinementRepairs",
         "FreeOutline",
         "WeightsInUse",
         "TransferredPoints",
         "LostPoints",
         "RepeatedPoints",
         "LostCells",
         "CellsAcrossSeams",
         "LargestDistance",
         "Tolerance" })
  {
    data->RemoveArray(name);
  }
}

void removeEarlierMap(vtkPolyData* map)
{
  removeEarlierMeasures(map);
  removeEarlierReports(map->GetFieldData());
  map->GetFieldData()->RemoveArray("SurfaceArea"); // that of the larger surface
  for (const char* name : { "ConformalFactor", "CellArea", "PowerWeight", "FlatPoints" })
  {
    map->GetPointData()->RemoveArray(name);
  }
}

} // namespace flattening
