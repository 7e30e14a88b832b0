// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/CutsOutput.h"

#include "Core/Mesh/FaceSides.h"
#include "Internal/ArrayConversion.h"
#include "Internal/PolyDataConversion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <map>
#include <vector>

namespace flattening
{

void addSeamArrays(vtkPolyData* disk, const SeamSegments& seams)
{
  disk->GetPointData()->AddArray(newArray<vtkIntArray>(SeamIdName, seams.SegmentOf));
  addPointArray(disk, "SeamDistance", seams.Distance);
}

namespace
{

constexpr int CapId = -1; // of the outlines of caps and patches

// The edges between filled faces and others, as lines of two vertices.
std::vector<std::vector<int>> outlinesOfCaps(vtkPolyData* disk)
{
  std::vector<std::vector<int>> outlines;
  vtkDataArray* filled = disk->GetCellData()->GetArray("Filled");
  if (!filled)
  {
    return outlines;
  }
  const TriangleMesh mesh = toTriangleMesh(disk);
  const std::vector<FaceSide> sides = sortedSides(mesh.Faces);
  for (std::size_t s = 1; s < sides.size(); ++s)
  {
    if (sides[s].edge() == sides[s - 1].edge() &&
        filled->GetTuple1(sides[s].face()) != filled->GetTuple1(sides[s - 1].face()))
    {
      outlines.push_back({ sides[s].From, sides[s].To });
    }
  }
  return outlines;
}

} // namespace

void setCuts(vtkPolyData* cuts, vtkPolyData* disk, const SeamSegments& seams)
{
  const std::vector<std::vector<int>> caps = outlinesOfCaps(disk);
  std::vector<const std::vector<int>*> lines;
  std::vector<int> ids;
  for (const std::vector<int>& segment : seams.Segments)
  {
    lines.push_back(&segment);
    ids.push_back(static_cast<int>(lines.size()));
  }
  for (const std::vector<int>& border : seams.Borders)
  {
    lines.push_back(&border);
    ids.push_back(0);
  }
  for (const std::vector<int>& cap : caps)
  {
    lines.push_back(&cap);
    ids.push_back(CapId);
  }

  std::map<int, vtkIdType> pointOf; // by the vertex of the disk
  vtkNew<vtkIdList> kept;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  std::vector<double> lengths;
  for (const std::vector<int>* line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line->size()));
    double length = 0.0;
    for (std::size_t i = 0; i < line->size(); ++i)
    {
      const int v = (*line)[i];
      const auto [entry, isNew] = pointOf.emplace(v, points->GetNumberOfPoints());
      if (isNew)
      {
        kept->InsertNextId(v);
        points->InsertNextPoint(disk->GetPoint(v));
      }
      cells->InsertCellPoint(entry->second);
      if (i > 0)
      {
        Eigen::Vector3d here;
        Eigen::Vector3d before;
        disk->GetPoint(v, here.data());
        disk->GetPoint((*line)[i - 1], before.data());
        length += (here - before).norm();
      }
    }
    lengths.push_back(length);
  }
  cuts->SetPoints(points);
  cuts->SetLines(cells);
  cuts->GetPointData()->CopyAllocate(disk->GetPointData(), kept->GetNumberOfIds());
  vtkNew<vtkIdList> all;
  for (vtkIdType i = 0; i < kept->GetNumberOfIds(); ++i)
  {
    all->InsertNextId(i);
  }
  cuts->GetPointData()->CopyData(disk->GetPointData(), kept, all);
  cuts->GetCellData()->AddArray(newArray<vtkIntArray>(SeamIdName, ids));
  cuts->GetCellData()->AddArray(newArray<vtkDoubleArray>("Length", lengths));
}

} // namespace flattening
