// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/SlabLayers.h"

#include "Internal/ArrayConversion.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <sstream>

namespace flattening
{

Layers sampleLayers(const VolumeSampling& volume,
  const Points3& points,
  const Points3& inward,
  const std::vector<double>& depths,
  const ProgressCallback& progress)
{
  Layers layers;
  const auto count = static_cast<double>(depths.size());
  for (std::size_t d = 0; d < depths.size(); ++d)
  {
    layers.push_back(
      volume.at(points + depths[d] * inward, subrange(progress, d / count, (d + 1) / count)));
  }
  return layers;
}

std::string depthText(double depth)
{
  std::ostringstream text;
  text << depth;
  return text.str();
}

void addSlabArrays(vtkPolyData* output, const Layers& layers, const std::vector<double>& depths)
{
  for (std::size_t a = 0; a < layers.front().size(); ++a)
  {
    vtkDataArray* first = layers.front()[a].Values;
    const int width = first->GetNumberOfComponents();
    const auto slab = vtk::TakeSmartPointer(first->NewInstance());
    slab->SetName((std::string(first->GetName()) + "Slab").c_str());
    slab->SetNumberOfComponents(width * static_cast<int>(depths.size()));
    slab->SetNumberOfTuples(first->GetNumberOfTuples());
    for (std::size_t d = 0; d < depths.size(); ++d)
    {
      for (int k = 0; k < width; ++k)
      {
        const int component = static_cast<int>(d) * width + k;
        slab->CopyComponent(component, layers[d][a].Values, k);
        slab->SetComponentName(component,
          (depthText(depths[d]) + (width > 1 ? "_" + std::to_string(k) : std::string())).c_str());
      }
    }
    output->GetPointData()->AddArray(slab);
  }
}

long long addMask(vtkPolyData* output, const Layers& layers)
{
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("InVolume");
  mask->SetNumberOfComponents(static_cast<int>(layers.size()));
  mask->SetNumberOfTuples(output->GetNumberOfPoints());
  long long outside = 0;
  for (std::size_t d = 0; d < layers.size(); ++d)
  {
    const std::vector<char>& inside = layers[d].front().Inside;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      mask->SetTypedComponent(i, static_cast<int>(d), inside[i] ? 1 : 0);
      outside += !inside[i];
    }
  }
  output->GetPointData()->AddArray(mask);
  return outside;
}

namespace
{

// Whether the depths ascend in equal steps.
bool haveEqualSteps(const std::vector<double>& depths)
{
  for (std::size_t d = 2; d < depths.size(); ++d)
  {
    const double first = depths[1] - depths[0];
    if (std::abs(depths[d] - depths[d - 1] - first) > 1e-6 * std::abs(first))
    {
      return false;
    }
  }
  return depths.size() > 1 && depths[1] > depths[0];
}

} // namespace

ImageGrid stackGrid(const ImageGrid& pixels, const std::vector<double>& depths)
{
  ImageGrid grid = pixels;
  grid.Size[2] = static_cast<int>(depths.size());
  if (haveEqualSteps(depths))
  {
    grid.Origin[2] = depths[0];
    grid.Spacing[2] = depths[1] - depths[0];
  }
  return grid;
}

void fillStack(vtkImageData* stack,
  vtkImageData* pixels,
  const Layers& layers,
  const std::vector<double>& depths)
{
  const auto count = static_cast<int>(depths.size());
  setGrid(stack, stackGrid(gridOf(pixels), depths));
  const vtkIdType perLayer = pixels->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("InVolume");
  mask->SetNumberOfTuples(perLayer * count);
  for (std::size_t a = 0; a < layers.front().size(); ++a)
  {
    vtkDataArray* first = layers.front()[a].Values;
    const auto values = vtk::TakeSmartPointer(first->NewInstance());
    values->SetName(first->GetName());
    values->SetNumberOfComponents(first->GetNumberOfComponents());
    values->SetNumberOfTuples(perLayer * count);
    for (int d = 0; d < count; ++d)
    {
      values->InsertTuples(d * perLayer, perLayer, 0, layers[d][a].Values);
      for (vtkIdType i = 0; i < perLayer; ++i)
      {
        mask->SetValue(d * perLayer + i, layers[d][a].Inside[i] ? 1 : 0);
      }
    }
    a == 0 ? stack->GetPointData()->SetScalars(values) : stack->GetPointData()->AddArray(values);
  }
  stack->GetPointData()->AddArray(mask);
}

void setDepths(vtkDataObject* output, const std::vector<double>& depths)
{
  output->GetFieldData()->AddArray(newArray<vtkDoubleArray>("Depths", depths));
}

} // namespace flattening
