// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPlanarWarp.h"

#include "Internal/FilterExecution.h"
#include "Internal/ImageMemory.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/WarpGraph.h"
#include "Internal/WarpImage.h"
#include "Internal/WarpPolyData.h"

#include <vtkDirectedGraph.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUndirectedGraph.h>

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkPlanarWarp);

namespace
{

using flattening::InvalidInput;

// The greatest length of a segment; 0 for no limit.
double segmentLength(bool subdivide, double maximum, double meanSide)
{
  if (!(maximum >= 0.0) || !std::isfinite(maximum))
  {
    throw InvalidInput("the maximal segment length is " + flattening::formatted(maximum) +
                       ": set it to a length, or to 0 for half of the mean side of the triangles");
  }
  if (!subdivide)
  {
    return 0.0;
  }
  return maximum > 0.0 ? maximum : 0.5 * meanSide;
}

} // namespace

vtkPlanarWarp::vtkPlanarWarp()
{
  this->SetNumberOfInputPorts(2);
}

int vtkPlanarWarp::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkGraph");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  }
  return 1;
}

const char* vtkPlanarWarp::GetBlockOutputType(int vtkNotUsed(port), vtkInformationVector** inputVector)
{
  vtkDataObject* data = vtkDataObject::GetData(inputVector[1]);
  if (vtkImageData::SafeDownCast(data) && this->ImageOutput == RESAMPLED_IMAGE)
  {
    return "vtkImageData";
  }
  if (vtkGraph::SafeDownCast(data))
  {
    return vtkDirectedGraph::SafeDownCast(data) ? "vtkDirectedGraph" : "vtkUndirectedGraph";
  }
  return "vtkPolyData";
}

int vtkPlanarWarp::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  if (!vtkImageData::GetData(outputVector))
  {
    return 1;
  }
  flattening::updateInput(this, 0);
  flattening::updateInput(this, 1);
  vtkPolyData* flat = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  if (flat && image) // not composite
  {
    flattening::announceGrid(outputVector->GetInformationObject(0),
      [&]
      {
        if (flattening::isEmpty(flat) || flattening::isEmpty(image))
        {
          return flattening::NoImage;
        }
        return flattening::resampledGrid(image,
          flat,
          this->OutsidePoints == LEAVE_UNMOVED,
          this->SizeOfImage(image),
          flattening::planeHeight(flattening::surfaceOfFlattened(flat)));
      });
    flattening::announceScalars(
      outputVector->GetInformationObject(0), image->GetPointData()->GetScalars());
  }
  return 1;
}

const int* vtkPlanarWarp::SizeOfImage(vtkImageData* image) const
{
  const bool isChosen = this->ImageSize[0] != 0 || this->ImageSize[1] != 0;
  const int* size = isChosen ? this->ImageSize : image->GetDimensions();
  if (std::min(size[0], size[1]) < 2 || std::max(size[0], size[1]) > 65535)
  {
    throw InvalidInput("the output image has " + std::to_string(size[0]) + " x " +
                       std::to_string(size[1]) +
                       " pixels: set both numbers from 2 to 65535, or both to 0");
  }
  return size;
}

void vtkPlanarWarp::Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* flat = vtkPolyData::GetData(inputVector[0]);
  vtkDataObject* data = vtkDataObject::GetData(inputVector[1]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  const flattening::TriangleMesh mesh = flattening::surfaceOfFlattened(flat);
  flattening::requireOrdinarySize(mesh);
  const flattening::Points2 positions = flattening::toPlanarPositions(flat);
  const auto progress = flattening::progressOf(this);
  const flattening::PlanarWarp warp(mesh, positions, flattening::subrange(progress, 0.0, 0.2));
  if (warp.facesDown())
  {
    vtkWarningMacro(
      << this->GetBlockPrefix()
      << "the mesh faced down (towards negative z) before it was flattened, so that the "
         "warped data are mirrored: reverse its triangles first, e.g. with Flip Normals in "
         "Generate Surface Normals");
  }
  const flattening::WarpRules rules{ warp,
    this->OutsidePoints == REMOVE,
    segmentLength(this->SubdivideLines, this->MaximumSegmentLength, warp.meanSide()),
    flattening::subrange(progress, 0.2, 1.0) };
  flattening::WarpCounts counts;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    counts.Outside = this->WarpImage(image, flat, rules, output);
  }
  else if (auto* graph = vtkGraph::SafeDownCast(data))
  {
    counts = flattening::warpGraph(graph, rules, vtkGraph::SafeDownCast(output));
  }
  else
  {
    counts = flattening::warpPolyData(
      vtkPolyData::SafeDownCast(data), rules, vtkPolyData::SafeDownCast(output));
  }
  flattening::setDatum(output->GetFieldData(), "OutsidePoints", counts.Outside);
  flattening::setDatum(output->GetFieldData(), "InsertedPoints", counts.Inserted);
}

long long vtkPlanarWarp::WarpImage(vtkImageData* image,
  vtkPolyData* flat,
  const flattening::WarpRules& rules,
  vtkDataObject* output)
{
  if (auto* textured = vtkPolyData::SafeDownCast(output))
  {
    textured->ShallowCopy(flat);
    return flattening::addTextureCoordinates(
      image, flattening::surfaceOfFlattened(flat).Vertices, textured);
  }
  const int* size = this->SizeOfImage(image);
  // Points in the plane there and back, points in space, and the arrays as they are probed and copied.
  constexpr std::size_t points = 2 * 2 * sizeof(double) + 3 * sizeof(double);
  flattening::requireImageMemory(size[0],
    size[1],
    points + 2 * flattening::bytesPerTuple(image->GetPointData()),
    "set a smaller ImageSize");
  return flattening::warpImage(image,
    flat,
    { rules.Warp,
      this->OutsidePoints == LEAVE_UNMOVED,
      this->NearestPixel,
      { size[0], size[1] },
      rules.Progress },
    vtkImageData::SafeDownCast(output));
}

void vtkPlanarWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutsidePoints: " << this->OutsidePoints << "\n";
  os << indent << "SubdivideLines: " << this->SubdivideLines << "\n";
  os << indent << "MaximumSegmentLength: " << this->MaximumSegmentLength << "\n";
  os << indent << "ImageOutput: " << this->ImageOutput << "\n";
  os << indent << "ImageSize: " << this->ImageSize[0] << " " << this->ImageSize[1] << "\n";
  os << indent << "NearestPixel: " << this->NearestPixel << "\n";
}
