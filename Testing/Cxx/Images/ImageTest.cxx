// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImageTest.h"

#include "../FilterTest.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkImageDifference.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace flattening::testing
{

namespace
{

std::array<double, 3> colourOf(double value, double low, double high)
{
  if (std::isnan(value))
  {
    return { 255.0, 255.0, 255.0 };
  }
  const double t = std::round(8.0 * std::clamp((value - low) / (high - low), 0.0, 1.0)) / 8.0;
  return { 255.0 * t, 255.0 * (1.0 - std::abs(2.0 * t - 1.0)), 255.0 * (1.0 - t) };
}

vtkSmartPointer<vtkUnsignedCharArray> noColours()
{
  auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colours->SetName("Colours");
  colours->SetNumberOfComponents(3);
  return colours;
}

double meanOfCorners(vtkPolyData* data, vtkIdType cell, vtkDataArray* array, int component)
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(cell, corners);
  double total = 0.0;
  for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
  {
    total += array->GetComponent(corners->GetId(k), component);
  }
  return total / static_cast<double>(corners->GetNumberOfIds());
}

void write(const Image& image, const std::string& file)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetCompressionLevel(9);
  writer->SetInputData(image);
  writer->Write();
}

std::string baselineFile(const std::string& name)
{
  return BASELINE_DIRECTORY "/" + name + ".png";
}

double differenceOf(const Image& image, const Image& expected)
{
  std::array<int, 3> size{};
  std::array<int, 3> expectedSize{};
  image->GetDimensions(size.data());
  expected->GetDimensions(expectedSize.data());
  if (size != expectedSize)
  {
    ADD_FAILURE() << "images of different size";
    return 0.0;
  }
  vtkNew<vtkImageDifference> compare;
  compare->SetInputData(image);
  compare->SetImageData(expected);
  compare->SetThreshold(16);
  compare->Update();
  return compare->GetThresholdedError();
}

double differenceFromBaseline(const Image& image, const std::string& name)
{
  vtkNew<vtkPNGReader> reader;
  const std::string file = baselineFile(name);
  if (!reader->CanReadFile(file.c_str()))
  {
    ADD_FAILURE() << "no baseline " << file;
    return 0.0;
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  return differenceOf(image, reader->GetOutput());
}

} // namespace

vtkSmartPointer<vtkPolyData> radialMap(const analytic::RevolutionMesh& mesh,
  const analytic::SurfaceOfRevolution::Function& radius)
{
  auto flat = polyDataOf(mesh.Mesh);
  vtkNew<vtkDoubleArray> surface;
  surface->DeepCopy(flat->GetPoints()->GetData());
  surface->SetName("SurfacePoints");
  flat->GetPointData()->AddArray(surface);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    const double r = radius(mesh.Parameter[i]);
    flat->GetPoints()->SetPoint(i, r * std::cos(mesh.Angle[i]), r * std::sin(mesh.Angle[i]), 0.0);
  }
  return flat;
}

double distanceFromRadialMap(const analytic::RevolutionMesh& mesh,
  vtkPolyData* flat,
  const analytic::SurfaceOfRevolution::Function& radius)
{
  double greatest = 0.0;
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    double x[3];
    flat->GetPoint(i, x);
    const double r = radius(mesh.Parameter[i]);
    greatest = std::max(
      greatest, std::hypot(x[0] - r * std::cos(mesh.Angle[i]), x[1] - r * std::sin(mesh.Angle[i])));
  }
  return greatest;
}

void addTiles(vtkPolyData* surface, double ring)
{
  vtkNew<vtkIntArray> tiles;
  tiles->SetName("Tile");
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkDataArray* points = surface->GetPoints()->GetData();
    const double x = meanOfCorners(surface, cell, points, 0);
    const double y = meanOfCorners(surface, cell, points, 1);
    const double angle = std::atan2(y, x) / EIGEN_PI;
    const int sector = static_cast<int>(std::floor(6.0 * (angle + 1.0)));
    const int circle = static_cast<int>(std::floor(std::hypot(x, y) / ring));
    const bool marked = angle > 0.0 && angle < 0.5;
    const int tile = (sector + circle) % 2 + (marked ? 2 : 0);
    tiles->InsertNextValue(2 * tile + 1 + static_cast<int>(cell % 2));
  }
  surface->GetCellData()->AddArray(tiles);
}

void colourBy(vtkPolyData* data, const char* name, double low, double high, int component)
{
  vtkDataArray* ofCells = data->GetCellData()->GetArray(name);
  vtkDataArray* ofPoints = data->GetPointData()->GetArray(name);
  ASSERT_TRUE(ofCells || ofPoints) << "no array " << name;
  const auto colours = noColours();
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const double value =
      ofCells ? ofCells->GetComponent(cell, component) : meanOfCorners(data, cell, ofPoints, component);
    colours->InsertNextTuple(colourOf(value, low, high).data());
  }
  data->GetCellData()->SetScalars(colours);
}

Image imageOf(vtkPolyData* data, const View& view)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScalarModeToUseCellData();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->BackfaceCullingOn();
  actor->GetProperty()->SetEdgeVisibility(view.Edges);
  actor->GetProperty()->SetEdgeColor(0.0, 0.0, 0.0);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(view.Size, view.Size);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(view.HalfHeight);
  camera->SetFocalPoint(view.Centre.data());
  const double distance = 10.0 * view.HalfHeight; // beyond the data, which would be cut off otherwise
  camera->SetPosition(view.Centre[0] + distance * view.Towards[0],
    view.Centre[1] + distance * view.Towards[1],
    view.Centre[2] + distance * view.Towards[2]);
  camera->SetViewUp(view.Up.data());
  renderer->ResetCameraClippingRange();
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->Update();
  auto image = Image::New();
  image->DeepCopy(grab->GetOutput());
  return image;
}

Image imageOf(vtkImageData* image, const char* name, double low, double high)
{
  auto coloured = Image::New();
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  if (!array)
  {
    ADD_FAILURE() << "no array " << name;
    return coloured;
  }
  coloured->SetDimensions(image->GetDimensions());
  const auto colours = noColours();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    colours->InsertNextTuple(colourOf(array->GetTuple1(i), low, high).data());
  }
  coloured->GetPointData()->SetScalars(colours);
  return coloured;
}

void expectBaseline(const Image& image, const std::string& name)
{
  const std::string file = TEMPORARY_DIRECTORY "/" + name + ".png";
  write(image, file);
  if (std::getenv("WRITE_BASELINES"))
  {
    write(image, baselineFile(name));
  }
  EXPECT_LT(differenceFromBaseline(image, name), BaselineTolerance) << "see " << file;
}

void expectNotBaseline(const Image& image,
  const std::string& name,
  const std::string& wrong,
  double times)
{
  const double difference = differenceFromBaseline(image, name);
  std::printf("%s, %s: %.0f\n", name.c_str(), wrong.c_str(), difference);
  EXPECT_GE(difference, times * BaselineTolerance) << wrong << " does not show";
}

} // namespace flattening::testing
