// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/SeamLines.h"

#include "Core/Base/Errors.h"
#include "Internal/CutsOutput.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStripper.h>

#include <limits>

namespace flattening
{

namespace
{

// The lines without those that an output of cuts marks as borders.
vtkSmartPointer<vtkCellArray> linesOfSeams(vtkPolyData* data)
{
  vtkDataArray* ids = data->GetCellData()->GetArray(SeamIdName);
  if (!ids || ids->GetNumberOfTuples() != data->GetNumberOfCells())
  {
    return data->GetLines();
  }
  auto seams = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> points;
  for (vtkIdType k = 0; k < data->GetNumberOfLines(); ++k)
  {
    if (ids->GetComponent(data->GetNumberOfVerts() + k, 0) > 0.0) // lines follow the vertices
    {
      data->GetLines()->GetCellAtId(k, points);
      seams->InsertNextCell(points);
    }
  }
  return seams;
}

} // namespace

SeamLines seamLines(vtkPolyData* data)
{
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(data->GetPoints());
  lines->SetLines(linesOfSeams(data));
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputData(lines);
  merged->ConvertLinesToPointsOff();
  vtkNew<vtkStripper> joined;
  joined->SetInputConnection(merged->GetOutputPort());
  joined->SetJoinContiguousSegments(true);
  joined->SetMaximumLength(std::numeric_limits<int>::max());
  joined->Update();

  SeamLines seam;
  auto line = vtk::TakeSmartPointer(joined->GetOutput()->GetLines()->NewIterator());
  for (line->GoToFirstCell(); !line->IsDoneWithTraversal(); line->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    line->GetCurrentCell(size, ids);
    if (!seam.Points.empty())
    {
      seam.PathStarts.push_back(static_cast<int>(seam.Points.size()));
    }
    for (vtkIdType i = 0; i < size; ++i)
    {
      Eigen::Vector3d point;
      joined->GetOutput()->GetPoint(ids[i], point.data());
      if (!point.allFinite())
      {
        throw InvalidInput("a point of the seam's lines is not finite: remove such points first");
      }
      if (i == 0 || point != seam.Points.back()) // vtkStripper repeats the point where it joins lines
      {
        seam.Points.push_back(point);
      }
    }
  }
  if (seam.Points.empty())
  {
    throw InvalidInput("the second input has no line to cut along: connect lines or polylines, such as "
                       "those of Poly Line Source");
  }
  return seam;
}

} // namespace flattening
