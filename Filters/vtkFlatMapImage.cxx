// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFlatMapImage.h"

#include "Core/FlatMap/FlatMapPixels.h"
#include "Internal/ArrayConversion.h"
#include "Internal/AttributeTransfer.h"
#include "Internal/FilterExecution.h"
#include "Internal/ImageGrid.h"
#include "Internal/ImageMemory.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/TextureCoordinates.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkFlatMapImage);

namespace
{

using flattening::FaceMatrix;
using flattening::MapPlace;

// The weights of the corners of the triangle under each pixel: a row per pixel, empty outside the map.
flattening::VertexOrigins cornersOf(const std::vector<MapPlace>& places,
  const FaceMatrix& faces,
  int vertices)
{
  return flattening::originMatrix(places,
    vertices,
    [&faces](const MapPlace& place)
    {
      return place.Face >= 0 ? flattening::originOf(faces, place.Face, place.Weights)
                             : flattening::Origin();
    });
}

void addCellArrays(vtkPolyData* map, const std::vector<MapPlace>& places, vtkPointData* pixels)
{
  std::vector<vtkIdType> cells(places.size());
  std::transform(
    places.begin(), places.end(), cells.begin(), [](const MapPlace& place) { return place.Face; });
  vtkNew<vtkCellData> underPixels;
  flattening::transferCellData(map->GetCellData(), cells, underPixels);
  for (int i = 0; i < underPixels->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = underPixels->GetAbstractArray(i);
    while (pixels->HasArray(array->GetName()))
    {
      array->SetName((std::string(array->GetName()) + "Cell").c_str());
    }
    pixels->AddArray(array);
  }
}

// Writes NaN to the pixels without a place on the map.
void setNoNumber(vtkPointData* pixels, const std::vector<MapPlace>& places)
{
  for (int a = 0; a < pixels->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = pixels->GetArray(a);
    if (!array || (array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE))
    {
      continue;
    }
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      for (int k = 0; places[i].Face < 0 && k < array->GetNumberOfComponents(); ++k)
      {
        array->SetComponent(static_cast<vtkIdType>(i), k, std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
}

// Adds CellId and InMap. Returns the number of pixels in the map.
long long addInverse(const std::vector<MapPlace>& places, vtkPointData* pixels)
{
  std::vector<int> cells(places.size());
  std::vector<char> inMap(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    inMap[i] = places[i].Face >= 0 && places[i].Inside;
    cells[i] = inMap[i] ? places[i].Face : -1;
  }
  pixels->AddArray(flattening::newArray<vtkIdTypeArray>("CellId", cells));
  pixels->AddArray(flattening::newArray<vtkUnsignedCharArray>("InMap", inMap));
  return std::count(inMap.begin(), inMap.end(), 1);
}

// The place, the rows of the matrix of corners and their entries before it is assembled, the arrays of
// the input, and the inverse of the map with the numbers that it is made of.
std::size_t bytesPerPixel(vtkPolyData* map)
{
  constexpr std::size_t corners = 3 * (sizeof(Eigen::Triplet<double>) + sizeof(double) + sizeof(int));
  constexpr std::size_t inverse = 2 * (sizeof(vtkIdType) + sizeof(char)) + sizeof(int);
  return sizeof(MapPlace) + corners + inverse + flattening::bytesPerTuple(map->GetPointData()) +
         flattening::bytesPerTuple(map->GetCellData());
}

} // namespace

const char* vtkFlatMapImage::GetBlockOutputType(int vtkNotUsed(port),
  vtkInformationVector** vtkNotUsed(inputVector))
{
  return "vtkImageData";
}

vtkImageData* vtkFlatMapImage::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkFlatMapImage::PixelsFor(double side) const
{
  if (!(this->PixelLength > 0.0))
  {
    return this->Size;
  }
  const double pixels = std::max(2.0, std::ceil(side / this->PixelLength));
  if (!(pixels <= GreatestSize))
  {
    std::ostringstream text;
    text << "the map is " << side << " wide, which is " << pixels << " pixels of " << this->PixelLength
         << ", more than " << GreatestSize << ": raise PixelLength";
    throw flattening::InvalidInput(text.str());
  }
  return static_cast<int>(pixels);
}

int vtkFlatMapImage::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  flattening::updateInput(this, 0);
  if (vtkPolyData* map = vtkPolyData::GetData(inputVector[0])) // not composite
  {
    vtkInformation* output = outputVector->GetInformationObject(0);
    flattening::announceGridOver(map,
      output,
      [this](const flattening::TextureSquare& square)
      { return flattening::gridOver(square, this->PixelsFor(square.Side)); });
    flattening::announceScalars(output, map->GetPointData()->GetScalars());
  }
  return 1;
}

void vtkFlatMapImage::Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  const flattening::ProgressCallback progress = flattening::progressOf(this);
  flattening::report(progress, 0.0, "Reading the flat map");
  const flattening::TriangleMesh surface = flattening::surfaceOfFlattened(input);
  flattening::requireOrdinarySize(surface);
  const flattening::Points2 positions = flattening::toPlanarPositions(input);
  const flattening::FlatMapLocation map(surface, positions, flattening::subrange(progress, 0.0, 0.1));
  const flattening::TextureSquare square = flattening::textureSquare(positions);
  const int size = this->PixelsFor(square.Side);
  flattening::requireImageMemory(size,
    size,
    bytesPerPixel(input),
    this->PixelLength > 0.0 ? "raise PixelLength" : "set a smaller Size");
  const flattening::ImageGrid grid = flattening::gridOver(square, size);
  const double length = grid.Spacing[0];
  const std::vector<MapPlace> places = flattening::placesOfPixels(map,
    { { grid.Origin[0], grid.Origin[1] }, length, size, size },
    this->Margin * length,
    flattening::subrange(progress, 0.1, 0.5));

  flattening::report(progress, 0.5, "Sampling the arrays");
  flattening::setGrid(output, grid);
  vtkPointData* pixels = output->GetPointData();
  const flattening::VertexOrigins corners = cornersOf(places, surface.Faces, surface.vertexCount());
  flattening::report(progress, 0.6, "Sampling the arrays");
  flattening::transferPointData(input->GetPointData(), corners, pixels);
  flattening::report(progress, 0.8, "Sampling the arrays");
  addCellArrays(input, places, pixels);
  flattening::report(progress, 0.9, "Sampling the arrays");
  setNoNumber(pixels, places);
  const long long count = addInverse(places, pixels);
  flattening::setDatum(output->GetFieldData(), "PixelLength", length);
  flattening::setDatum(output->GetFieldData(), "PixelsInMap", count);
  flattening::report(progress, 1.0, "Done");
}

void vtkFlatMapImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "PixelLength: " << this->PixelLength << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
}
