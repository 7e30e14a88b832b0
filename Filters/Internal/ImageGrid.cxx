// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/ImageGrid.h"

#include "Internal/PolyDataConversion.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <exception>

namespace flattening
{

ImageGrid gridOver(const TextureSquare& square, int size)
{
  const double length = square.Side / size;
  return { { size, size, 1 },
    { square.Low.x() + 0.5 * length, square.Low.y() + 0.5 * length, 0.0 },
    { length, length, length } };
}

ImageGrid gridOf(vtkImageData* image)
{
  ImageGrid grid;
  image->GetDimensions(grid.Size);
  image->GetOrigin(grid.Origin);
  image->GetSpacing(grid.Spacing);
  return grid;
}

void setGrid(vtkImageData* image, const ImageGrid& grid)
{
  image->SetDimensions(grid.Size);
  image->SetOrigin(grid.Origin);
  image->SetSpacing(grid.Spacing);
}

void updateInput(vtkAlgorithm* filter, int port)
{
  int output = 0;
  if (vtkAlgorithm* input = filter->GetInputAlgorithm(port, 0, output))
  {
    input->Update(output);
  }
}

void announceGrid(vtkInformation* output, const std::function<ImageGrid()>& grid)
{
  ImageGrid announced = NoImage;
  try
  {
    announced = grid();
  }
  catch (const std::exception&)
  {
  }
  const int* size = announced.Size;
  output->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), 0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1);
  output->Set(vtkDataObject::ORIGIN(), announced.Origin, 3);
  output->Set(vtkDataObject::SPACING(), announced.Spacing, 3);
}

void announceScalars(vtkInformation* output, vtkDataArray* scalars, int type)
{
  if (scalars)
  {
    vtkDataObject::SetPointDataActiveScalarInfo(output, type, scalars->GetNumberOfComponents());
  }
}

void announceScalars(vtkInformation* output, vtkDataArray* scalars)
{
  announceScalars(output, scalars, scalars ? scalars->GetDataType() : VTK_DOUBLE);
}

void announceGridOver(vtkPolyData* map,
  vtkInformation* output,
  const std::function<ImageGrid(const TextureSquare&)>& grid)
{
  announceGrid(
    output, [&] { return isEmpty(map) ? NoImage : grid(textureSquare(toPlanarPositions(map))); });
}

} // namespace flattening
