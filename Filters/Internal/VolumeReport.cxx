// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/VolumeReport.h"

#include "Core/Base/Errors.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/ReportRows.h"

#include <vtkFieldData.h>

namespace flattening
{
namespace
{

// Components with more than this share of the area of the surface are no noise. A convention, the same
// as that of Surface To Disk.
constexpr double SmallestLeftOut = 1e-3;

} // namespace

void setReportTable(vtkTable* table, const VolumeReport& report)
{
  ReportRows rows;
  rows.addChange(
    static_cast<double>(report.NotFinite), "voxels without a finite value became air", "Air");
  if (report.Margin > 0)
  {
    rows.add(report.Margin, "voxels of margin on every side", "Margin");
    rows.add(report.Air, "value of the margin", "Air");
  }
  rows.add(report.Smoothing, "standard deviation of the smoothing", "Smoothing");
  rows.add(report.Classes.Value,
    report.Suggested ? "isovalue, which the histogram suggests (Otsu)" : "isovalue",
    "Isovalue");
  rows.add(100.0 * report.Classes.ShareBelow, "percent of the voxels are below it", "");
  rows.add(report.Classes.MeanBelow, "mean of the voxels below it", "");
  rows.add(report.Classes.MeanAbove, "mean of the voxels above it", "");
  rows.add(100.0 * report.Classes.Separation, "percent of the variance lie between both", "");
  rows.add(static_cast<double>(report.Components.Count), "components of the isosurface", "Component");
  rows.addChange(report.LeftOutArea, "area of the components that were left out", "Component");
  rows.add(report.Components.Whole - report.LeftOutArea, "area of the surface", "");
  rows.fill(table);
}

void setHistogramTable(vtkTable* table, const Histogram& histogram, double isovalue)
{
  vtkNew<vtkDoubleArray> columns[3];
  const char* names[] = { "Value", "VoxelsBelow", "VoxelsAbove" };
  for (std::size_t bin = 0; bin < histogram.Counts.size(); ++bin)
  {
    const bool below = histogram.centre(bin) < isovalue;
    columns[0]->InsertNextValue(histogram.centre(bin));
    columns[1]->InsertNextValue(below ? histogram.Counts[bin] : 0.0);
    columns[2]->InsertNextValue(below ? 0.0 : histogram.Counts[bin]);
  }
  for (int k = 0; k < 3; ++k)
  {
    columns[k]->SetName(names[k]);
    table->AddColumn(columns[k]);
  }
}

void setFieldData(vtkFieldData* data, const VolumeReport& report)
{
  setDatum(data, "Isovalue", report.Classes.Value);
  setDatum(data, "ShareBelow", report.Classes.ShareBelow);
  setDatum(data, "MeanBelow", report.Classes.MeanBelow);
  setDatum(data, "MeanAbove", report.Classes.MeanAbove);
  setDatum(data, "ClassSeparation", report.Classes.Separation);
  setDatum(data, "AirValue", report.Air);
  setDatum(data, "SmoothingLength", report.Smoothing);
  setDatum(data, "NotFiniteVoxels", report.NotFinite);
  setDatum(data, "IsosurfaceComponents", report.Components.Count);
  setDatum(data, "LeftOutArea", report.LeftOutArea);
}

std::string leftOutWarning(const VolumeReport& report)
{
  const double kept = report.Components.Largest;
  if (report.LeftOutArea <= SmallestLeftOut * kept)
  {
    return {};
  }
  const long long others = report.Components.Count - 1;
  return counted(others, "other component") + " of the isosurface, with an area of " +
         formatted(report.LeftOutArea) + ", " + (others == 1 ? "was" : "were") + " left out, beside " +
         formatted(kept) +
         " that were kept. If one of them is meant, set Component to All, and choose it "
         "in Surface To Disk";
}

} // namespace flattening
