// SPDX-License-Identifier: GPL-3.0-or-later
/// What the tests of the filters ask of VTK: surfaces as polydata, figures, errors, an abort.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace flattening::testing
{

inline vtkSmartPointer<vtkPolyData> polyDataOf(const TriangleMesh& mesh)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    points->InsertNextPoint(mesh.Vertices.row(v).data());
  }
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const vtkIdType corners[] = { mesh.Faces(f, 0), mesh.Faces(f, 1), mesh.Faces(f, 2) };
    triangles->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

/// The value of a one-tuple array in field data.
inline double figure(vtkDataObject* output, const char* name)
{
  vtkDataArray* array = output->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() != 1)
  {
    ADD_FAILURE() << "no one-tuple field array " << name;
    return std::numeric_limits<double>::quiet_NaN();
  }
  return array->GetTuple1(0);
}

/// Sum over the tuples of a one-component array.
inline double sum(vtkDataArray* array)
{
  double total = 0.0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    total += array->GetTuple1(i);
  }
  return total;
}

/// Listens to the errors of a filter as long as it lives, and keeps its executive's from the terminal.
class ErrorLog
{
public:
  explicit ErrorLog(vtkAlgorithm* filter)
    : Filter(filter)
    , FilterTag(filter->AddObserver(vtkCommand::ErrorEvent, this, &ErrorLog::record))
    , ExecutiveTag(filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &ErrorLog::ignore))
  {
  }
  ErrorLog(const ErrorLog&) = delete;
  ErrorLog& operator=(const ErrorLog&) = delete;
  ~ErrorLog()
  {
    this->Filter->RemoveObserver(this->FilterTag);
    this->Filter->GetExecutive()->RemoveObserver(this->ExecutiveTag);
  }
  const std::vector<std::string>& messages() const { return this->Messages; }

private:
  void record(vtkObject*, unsigned long, void* text)
  {
    this->Messages.emplace_back(static_cast<const char*>(text));
  }
  void ignore(vtkObject*, unsigned long, void*) {}

  vtkAlgorithm* Filter;
  unsigned long FilterTag;
  unsigned long ExecutiveTag;
  std::vector<std::string> Messages;
};

/// Runs the filter on @p input: exactly one error, with these words, and no data on any output port.
/// Then runs it on @p good, which it must do without an error.
template <typename Filter>
void expectError(Filter* filter, vtkPolyData* input, const std::string& words, vtkPolyData* good)
{
  SCOPED_TRACE(words);
  ErrorLog errors(filter);
  filter->SetInputData(input);
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find(words), std::string::npos) << errors.messages().front();
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_EQ(filter->GetOutputDataObject(port)->GetNumberOfElements(vtkDataObject::POINT), 0);
    EXPECT_EQ(filter->GetOutputDataObject(port)->GetNumberOfElements(vtkDataObject::CELL), 0);
    EXPECT_EQ(filter->GetOutputDataObject(port)->GetFieldData()->GetNumberOfArrays(), 0);
  }
  filter->SetInputData(good);
  filter->Update();
  EXPECT_EQ(errors.messages().size(), 1u) << "an error on good input: " << errors.messages().back();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), good->GetNumberOfCells());
}

/// Asks the filter to stop at its first report of at least @p fraction: no data on any output port, no
/// error; then lets it run.
template <typename Filter>
void expectAbort(Filter* filter, vtkPolyData* input, double fraction)
{
  struct Stop : vtkCommand
  {
    double Fraction = 0.0;
    int Reports = 0;
    void Execute(vtkObject* caller, unsigned long, void* progress) override
    {
      if (*static_cast<double*>(progress) >= this->Fraction)
      {
        ++this->Reports;
        vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
      }
    }
  };
  SCOPED_TRACE(fraction);
  ErrorLog errors(filter);
  auto stop = vtkSmartPointer<Stop>::Take(new Stop);
  stop->Fraction = fraction;
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->SetInputData(input);
  filter->Modified();
  filter->Update();
  filter->RemoveObserver(tag);
  EXPECT_GE(stop->Reports, 1);
  EXPECT_TRUE(errors.messages().empty());
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_EQ(filter->GetOutputDataObject(port)->GetNumberOfElements(vtkDataObject::POINT), 0);
  }
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  EXPECT_TRUE(errors.messages().empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), input->GetNumberOfCells());
}

} // namespace flattening::testing
