// SPDX-License-Identifier: GPL-3.0-or-later
#include "Shrinking.h"

#include "CaseRuns.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <vector>

namespace fuzz
{
namespace
{

bool failsWith(const Case& one, const std::string& kind, const Limits& limits)
{
  const std::vector<Failure> failures = runInChild(one, limits).Shown.Failures;
  return std::any_of(
    failures.begin(), failures.end(), [&](const Failure& failure) { return failure.Kind == kind; });
}

// The chosen cells with all points, in the order of polydata: vertices, lines, polygons, strips.
vtkSmartPointer<vtkPolyData> withCells(vtkPolyData* data, const std::vector<vtkIdType>& kept)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(data->GetPoints());
  result->GetPointData()->ShallowCopy(data->GetPointData());
  result->GetFieldData()->ShallowCopy(data->GetFieldData());
  result->GetCellData()->CopyAllOn();
  result->GetCellData()->CopyAllocate(data->GetCellData(), static_cast<vtkIdType>(kept.size()));
  vtkCellArray* sources[] = { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() };
  vtkNew<vtkCellArray> targets[4];
  vtkIdType first = 0;
  vtkIdType cells = 0;
  vtkNew<vtkIdList> corners;
  for (int kind = 0; kind < 4; ++kind)
  {
    const vtkIdType end = first + sources[kind]->GetNumberOfCells();
    for (const vtkIdType id : kept)
    {
      if (id >= first && id < end)
      {
        sources[kind]->GetCellAtId(id - first, corners);
        targets[kind]->InsertNextCell(corners);
        result->GetCellData()->CopyData(data->GetCellData(), id, cells++);
      }
    }
    first = end;
  }
  result->SetVerts(targets[0]);
  result->SetLines(targets[1]);
  result->SetPolys(targets[2]);
  result->SetStrips(targets[3]);
  return result;
}

// The same cells, without the points that no cell uses.
vtkSmartPointer<vtkPolyData> withoutUnusedPoints(vtkPolyData* data)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->GetFieldData()->ShallowCopy(data->GetFieldData());
  result->GetCellData()->ShallowCopy(data->GetCellData());
  result->GetPointData()->CopyAllOn();
  result->GetPointData()->CopyAllocate(data->GetPointData());
  vtkNew<vtkPoints> points;
  points->SetDataType(data->GetPoints()->GetDataType());
  std::vector<vtkIdType> newIds(data->GetNumberOfPoints(), -1);
  const auto renumbered = [&](vtkCellArray* cells)
  {
    auto copy = vtkSmartPointer<vtkCellArray>::New();
    vtkNew<vtkIdList> corners;
    for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
    {
      cells->GetCellAtId(c, corners);
      for (vtkIdType& corner : *corners)
      {
        vtkIdType& id = newIds[corner];
        if (id < 0)
        {
          id = points->InsertNextPoint(data->GetPoint(corner));
          result->GetPointData()->CopyData(data->GetPointData(), corner, id);
        }
        corner = id;
      }
      copy->InsertNextCell(corners);
    }
    return copy;
  };
  result->SetVerts(renumbered(data->GetVerts()));
  result->SetLines(renumbered(data->GetLines()));
  result->SetPolys(renumbered(data->GetPolys()));
  result->SetStrips(renumbered(data->GetStrips()));
  result->SetPoints(points);
  return result;
}

class Shrinking
{
  using Clock = std::chrono::steady_clock;

public:
  Shrinking(Case one, const std::string& kind, const Limits& limits, double seconds)
    : Best(std::move(one))
    , Kind(kind)
    , Limit(limits)
    , End(Clock::now() + std::chrono::milliseconds(static_cast<int>(1000.0 * seconds)))
  {
  }

  void removeCells()
  {
    vtkIdType chunk = std::max<vtkIdType>(1, this->Best.Surface->GetNumberOfCells() / 2);
    while (this->hasTime())
    {
      bool removed = false;
      for (vtkIdType first = 0; first < this->Best.Surface->GetNumberOfCells() && this->hasTime();)
      {
        const bool worked = this->tryWithout(first, first + chunk);
        removed = removed || worked;
        first += worked ? 0 : chunk;
      }
      if (chunk == 1 && !removed)
      {
        return;
      }
      chunk = removed
                ? std::min(chunk, std::max<vtkIdType>(1, this->Best.Surface->GetNumberOfCells() / 2))
                : std::max<vtkIdType>(1, chunk / 2);
    }
  }

  void removeSettings()
  {
    const Settings all = this->Best.Values;
    for (const auto& [name, values] : all)
    {
      Case trial = this->Best;
      trial.Values.erase(name);
      this->take(trial);
    }
  }

  void removePoints()
  {
    Case trial = this->Best;
    trial.Surface = withoutUnusedPoints(this->Best.Surface);
    this->take(trial);
  }

  Case Best;

private:
  bool hasTime() const { return Clock::now() < this->End; }

  bool tryWithout(vtkIdType first, vtkIdType end)
  {
    const vtkIdType count = this->Best.Surface->GetNumberOfCells();
    end = std::min(end, count);
    std::vector<vtkIdType> kept(count);
    std::iota(kept.begin(), kept.end(), 0);
    kept.erase(kept.begin() + first, kept.begin() + end);
    Case trial = this->Best;
    trial.Surface = withCells(this->Best.Surface, kept);
    return this->take(trial);
  }

  // Keeps the trial if it fails in the same way.
  bool take(const Case& trial)
  {
    if (!this->hasTime() || !failsWith(trial, this->Kind, this->Limit))
    {
      return false;
    }
    this->Best = trial;
    return true;
  }

  std::string Kind;
  Limits Limit;
  Clock::time_point End;
};

} // namespace

Case shrink(Case one, const std::string& kind, const Limits& limits, double seconds)
{
  Limits trial = limits;
  if (kind == "hang") // a fourth of the time shows it well enough
  {
    trial.Seconds /= 4.0;
  }
  Shrinking shrinking(std::move(one), kind, trial, seconds);
  shrinking.removeSettings();
  shrinking.removeCells();
  shrinking.removePoints();
  return shrinking.Best;
}

} // namespace fuzz
