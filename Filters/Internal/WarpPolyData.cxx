// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/WarpPolyData.h"

#include "Core/Base/Errors.h"
#include "Internal/ArrayConversion.h"
#include "Internal/AttributeTransfer.h"
#include "Internal/PolyDataConversion.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace flattening
{
namespace
{

using Cell = std::vector<vtkIdType>;

// A point of the output: (1 - Share) of input point A and Share of B.
struct PointOnLine
{
  vtkIdType A;
  vtkIdType B;
  double Share;
};

std::vector<Cell> cellsOf(vtkCellArray* array)
{
  std::vector<Cell> cells;
  auto each = vtk::TakeSmartPointer(array->NewIterator());
  for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    each->GetCurrentCell(size, ids);
    cells.emplace_back(ids, ids + size);
  }
  return cells;
}

class PolyDataWarp
{
public:
  PolyDataWarp(vtkPolyData* input, const WarpRules& rules)
    : Input(input)
    , Rules(rules)
  {
    if (input->GetNumberOfPoints() > std::numeric_limits<int>::max())
    {
      throw InvalidInput("the data have more points than can be warped (2^31): warp parts of them");
    }
    this->Before = pointsOf(input);
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      this->Origins.push_back({ i, i, 0.0 });
    }
  }

  void subdivideLines();
  void move();
  WarpCounts write(vtkPolyData* output);

private:
  Eigen::Vector3d point(vtkIdType i) const { return this->Before.row(i); }
  bool kept(vtkIdType i) const { return this->KeptAs[i] >= 0; }
  vtkSmartPointer<vtkCellArray> whole(vtkCellArray* cells);
  vtkSmartPointer<vtkCellArray> runsOfLines();
  VertexOrigins keptOrigins() const;

  vtkPolyData* Input;
  const WarpRules& Rules;
  Points3 Before; // positions of the input's points and of the inserted ones
  std::vector<PointOnLine> Origins;
  std::vector<Cell> Lines; // with the inserted points
  WarpedInSpace Warped;
  std::vector<vtkIdType> KeptAs; // id of each point in the output; -1: not kept
  vtkIdType Kept = 0;
  vtkIdType Visited = 0;              // number of cells of the input that were visited
  std::vector<vtkIdType> CellOrigins; // the input cell of each cell of the output
};

void PolyDataWarp::subdivideLines()
{
  const auto earlier = static_cast<long long>(this->Origins.size());
  for (const Cell& line : cellsOf(this->Input->GetLines()))
  {
    Cell divided(line.begin(), line.begin() + std::min<std::size_t>(1, line.size()));
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
    {
      const int parts = segmentParts(this->point(line[k]), this->point(line[k + 1]), this->Rules);
      requireRoomFor(static_cast<long long>(this->Origins.size()) - earlier + parts);
      for (int part = 1; part < parts; ++part)
      {
        divided.push_back(static_cast<vtkIdType>(this->Origins.size()));
        this->Origins.push_back({ line[k], line[k + 1], static_cast<double>(part) / parts });
      }
      divided.push_back(line[k + 1]);
    }
    this->Lines.push_back(divided);
  }
  const Points3 ends = this->Before;
  this->Before.resize(static_cast<Eigen::Index>(this->Origins.size()), 3);
  for (Eigen::Index i = 0; i < this->Before.rows(); ++i)
  {
    const PointOnLine& from = this->Origins[i];
    this->Before.row(i) =
      from.A == from.B
        ? ends.row(from.A)
        : Eigen::RowVector3d((1.0 - from.Share) * ends.row(from.A) + from.Share * ends.row(from.B));
  }
}

void PolyDataWarp::move()
{
  this->Warped = warpInSpace(this->Before, this->Rules);
  requireSomeInside(this->Warped, this->Before);
  this->KeptAs.assign(this->Origins.size(), -1);
  for (std::size_t i = 0; i < this->Origins.size(); ++i)
  {
    if (this->Warped.Inside[i] || !this->Rules.RemoveOutside)
    {
      this->KeptAs[i] = this->Kept++;
    }
  }
}

// The vertices, polygons or strips of which all points are kept.
vtkSmartPointer<vtkCellArray> PolyDataWarp::whole(vtkCellArray* cells)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  for (Cell& cell : cellsOf(cells))
  {
    if (std::all_of(cell.begin(), cell.end(), [this](vtkIdType i) { return this->kept(i); }))
    {
      std::transform(
        cell.begin(), cell.end(), cell.begin(), [this](vtkIdType i) { return this->KeptAs[i]; });
      result->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
      this->CellOrigins.push_back(this->Visited);
    }
    ++this->Visited;
  }
  return result;
}

// The parts of the lines between points that are not kept.
vtkSmartPointer<vtkCellArray> PolyDataWarp::runsOfLines()
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  for (const Cell& line : this->Lines)
  {
    Cell run;
    const auto close = [&]
    {
      if (run.size() >= std::min<std::size_t>(2, line.size()))
      {
        result->InsertNextCell(static_cast<vtkIdType>(run.size()), run.data());
        this->CellOrigins.push_back(this->Visited);
      }
      run.clear();
    };
    for (const vtkIdType i : line)
    {
      if (this->kept(i))
      {
        run.push_back(this->KeptAs[i]);
      }
      else
      {
        close();
      }
    }
    close();
    ++this->Visited;
  }
  return result;
}

VertexOrigins PolyDataWarp::keptOrigins() const
{
  std::vector<PointOnLine> kept;
  for (std::size_t i = 0; i < this->Origins.size(); ++i)
  {
    if (this->kept(static_cast<vtkIdType>(i)))
    {
      kept.push_back(this->Origins[i]);
    }
  }
  // The weights of a point of the input, which is both ends of its line, are added to 1.
  return originMatrix(kept,
    static_cast<int>(this->Input->GetNumberOfPoints()),
    [](const PointOnLine& point)
    {
      return Origin{ { static_cast<int>(point.A), 1.0 - point.Share },
        { static_cast<int>(point.B), point.Share } };
    });
}

WarpCounts PolyDataWarp::write(vtkPolyData* output)
{
  WarpCounts counts;
  Points3 surface(this->Kept, 3);
  Points3 positions(this->Kept, 3);
  std::vector<char> inMap(this->Kept);
  for (std::size_t i = 0; i < this->Origins.size(); ++i)
  {
    const bool inserted = this->Origins[i].A != this->Origins[i].B || this->Origins[i].Share > 0.0;
    counts.Outside += !inserted && !this->Warped.Inside[i];
    if (this->kept(static_cast<vtkIdType>(i)))
    {
      const vtkIdType to = this->KeptAs[i];
      counts.Inserted += inserted;
      positions.row(to) = this->Warped.Positions.row(static_cast<Eigen::Index>(i));
      surface.row(to) = this->Before.row(static_cast<Eigen::Index>(i));
      inMap[to] = this->Warped.Inside[i];
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(newTuples<vtkDoubleArray>("Points", positions));
  output->SetPoints(points);
  output->SetVerts(this->whole(this->Input->GetVerts()));
  output->SetLines(this->runsOfLines());
  output->SetPolys(this->whole(this->Input->GetPolys()));
  output->SetStrips(this->whole(this->Input->GetStrips()));
  transferPointData(this->Input->GetPointData(), this->keptOrigins(), output->GetPointData());
  transferCellData(this->Input->GetCellData(), this->CellOrigins, output->GetCellData());
  addSurfacePoints(output, surface);
  output->GetPointData()->AddArray(newArray<vtkUnsignedCharArray>(InMapName, inMap));
  return counts;
}

} // namespace

WarpCounts warpPolyData(vtkPolyData* input, const WarpRules& rules, vtkPolyData* output)
{
  PolyDataWarp warp(input, rules);
  warp.subdivideLines();
  warp.move();
  return warp.write(output);
}

} // namespace flattening
