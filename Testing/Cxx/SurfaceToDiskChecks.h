// SPDX-License-Identifier: GPL-3.0-or-later
/// Inputs for the tests of vtkSurfaceToDiskFilter, and what its output must be.
#pragma once

#include <vtkSurfaceToDiskFilter.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace disk_tests
{

inline constexpr double Pi = 3.14159265358979323846;

inline vtkSmartPointer<vtkPolyData> sphere(int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkSmartPointer<vtkPolyData> result = source->GetOutput();
  result->GetPointData()->Initialize();
  return result;
}

// A square of n x n quads in [0,1]^2.
inline vtkSmartPointer<vtkPolyData> square(int n)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(0, 0, 0);
  source->SetPoint1(1, 0, 0);
  source->SetPoint2(0, 1, 0);
  source->SetResolution(n, n);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkSmartPointer<vtkPolyData> result = source->GetOutput();
  result->GetPointData()->Initialize();
  return result;
}

// Position as floating point numbers, the octant as a label and as a string; the cell's id squared.
inline void addAttributes(vtkPolyData* data)
{
  vtkNew<vtkDoubleArray> position;
  position->SetName("Position");
  position->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> octant;
  octant->SetName("Octant");
  vtkNew<vtkStringArray> name;
  name->SetName("Name");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    position->InsertNextTuple(x);
    octant->InsertNextValue(100 + (x[0] > 0) + 2 * (x[1] > 0) + 4 * (x[2] > 0));
    name->InsertNextValue("octant " + std::to_string(octant->GetValue(i)));
  }
  data->GetPointData()->AddArray(position);
  data->GetPointData()->SetScalars(octant);
  data->GetPointData()->AddArray(name);
  vtkNew<vtkFloatArray> number;
  number->SetName("CellNumber");
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    number->InsertNextValue(static_cast<float>(c + 1));
  }
  data->GetCellData()->AddArray(number);
}

// n x m quads around a ring of radii 2 and 1.
inline vtkSmartPointer<vtkPolyData> torus(int n, int m)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      const double u = 2 * Pi * i / n;
      const double v = 2 * Pi * j / m;
      const double r = 2 + std::cos(v);
      points->InsertNextPoint(r * std::cos(u), r * std::sin(u), std::sin(v));
      const vtkIdType next = (i + 1) % n * m;
      const vtkIdType up = (j + 1) % m;
      const vtkIdType ids[] = { i * m + j, next + j, next + up, i * m + up };
      quads->InsertNextCell(4, ids);
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(quads);
  return result;
}

// The surface of a slab with a row of square holes, genus @p holes: unit squares, cut into 4 x 4 quads.
inline vtkSmartPointer<vtkPolyData> slabWithHoles(int holes)
{
  constexpr int Fine = 4;
  const int size[] = { Fine * (2 * holes + 1), Fine * 3, Fine };
  const auto isSolid = [&size](const std::array<int, 3>& cell)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (cell[axis] < 0 || cell[axis] >= size[axis])
      {
        return false;
      }
    }
    return cell[0] / Fine % 2 == 0 || cell[1] / Fine != 1;
  };
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  std::map<std::array<int, 3>, vtkIdType> ids;
  const auto idOf = [&](const std::array<int, 3>& corner)
  {
    const auto [entry, isNew] = ids.emplace(corner, points->GetNumberOfPoints());
    if (isNew)
    {
      points->InsertNextPoint(
        double(corner[0]) / Fine, double(corner[1]) / Fine, double(corner[2]) / Fine);
    }
    return entry->second;
  };
  for (int i = -1; i <= size[0]; ++i)
  {
    for (int j = -1; j <= size[1]; ++j)
    {
      for (int k = -1; k <= size[2]; ++k)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          const std::array<int, 3> cell{ i, j, k };
          std::array<int, 3> corner = cell;
          ++corner[axis]; // the face between this cell and the next one along the axis
          if (isSolid(cell) == isSolid(corner))
          {
            continue;
          }
          vtkIdType face[4];
          for (int n = 0; n < 4; ++n)
          {
            std::array<int, 3> at = corner;
            at[(axis + 1) % 3] += n == 1 || n == 2;
            at[(axis + 2) % 3] += n == 2 || n == 3;
            face[isSolid(cell) ? n : 3 - n] = idOf(at);
          }
          quads->InsertNextCell(4, face);
        }
      }
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(quads);
  return result;
}

inline double figure(vtkPolyData* output, const char* name)
{
  vtkDataArray* array = output->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() != 1)
  {
    ADD_FAILURE() << "no one-tuple field array " << name;
    return std::numeric_limits<double>::quiet_NaN();
  }
  return array->GetTuple1(0);
}

inline double areaOf(vtkPolyData* data)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(data);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(triangles->GetOutputPort());
  return mass->GetSurfaceArea();
}

// The boundary as a map from every point of it to the next one, by ids: points that coincide are
// different.
inline std::map<vtkIdType, vtkIdType> boundaryOf(vtkPolyData* output)
{
  std::set<std::pair<vtkIdType, vtkIdType>> sides;
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    output->GetCellPoints(c, corners);
    for (int k = 0; k < 3; ++k)
    {
      const auto side = std::make_pair(corners->GetId(k), corners->GetId((k + 1) % 3));
      EXPECT_TRUE(sides.insert(side).second)
        << "edges of three faces or of two that are not turned alike";
    }
  }
  std::map<vtkIdType, vtkIdType> next;
  for (const auto& [from, to] : sides)
  {
    if (sides.count({ to, from }) == 0)
    {
      EXPECT_TRUE(next.emplace(from, to).second) << "boundaries meet in point " << from;
    }
  }
  return next;
}

inline std::set<vtkIdType> boundaryPoints(vtkPolyData* output)
{
  std::set<vtkIdType> points;
  for (const auto& [from, to] : boundaryOf(output))
  {
    points.insert(from);
  }
  return points;
}

// Oriented, Euler number 1, one boundary.
inline void expectDisk(vtkPolyData* output)
{
  ASSERT_GT(output->GetNumberOfCells(), 0);
  EXPECT_EQ(output->GetNumberOfPolys(), output->GetNumberOfCells());
  const std::map<vtkIdType, vtkIdType> next = boundaryOf(output);
  const auto boundary = static_cast<vtkIdType>(next.size());
  ASSERT_GE(boundary, 3);
  EXPECT_EQ(boundary, figure(output, "BoundaryVertices"));
  vtkIdType steps = 1;
  for (vtkIdType i = next.at(next.begin()->first); i != next.begin()->first && steps <= boundary;
       ++steps)
  {
    i = next.at(i);
  }
  EXPECT_EQ(steps, boundary) << "more than one boundary";
  const vtkIdType faces = output->GetNumberOfCells();
  EXPECT_EQ(output->GetNumberOfPoints() - (3 * faces + boundary) / 2 + faces, 1);
}

// The points that the output flags.
inline std::set<vtkIdType> seamPoints(vtkPolyData* output)
{
  std::set<vtkIdType> points;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    if (output->GetPointData()->GetArray("Seam")->GetTuple1(i) != 0)
    {
      points.insert(i);
    }
  }
  return points;
}

inline vtkSmartPointer<vtkPolyData> run(vtkSurfaceToDiskFilter* filter, vtkPolyData* input)
{
  filter->SetInputData(input);
  filter->Update();
  vtkNew<vtkPolyData> output;
  output->ShallowCopy(filter->GetOutput());
  return output;
}

} // namespace disk_tests
