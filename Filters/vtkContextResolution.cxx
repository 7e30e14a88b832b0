// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContextResolution.h"

#include "Core/Remeshing/RegionPreservingDecimation.h"
#include "Internal/ChosenArray.h"
#include "Internal/FilterExecution.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/RegionOutput.h"
#include "Internal/SelectedPoints.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkContextResolution);

namespace
{

// The number of faces with a corner in the region.
long long cellsAround(const flattening::TriangleMesh& mesh, const std::vector<char>& inRegion)
{
  long long count = 0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    count += inRegion[mesh.Faces(f, 0)] || inRegion[mesh.Faces(f, 1)] || inRegion[mesh.Faces(f, 2)];
  }
  return count;
}

} // namespace

void vtkContextResolution::Execute(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const flattening::TriangleMesh mesh = flattening::toTriangleMesh(input);
  flattening::requireOrdinarySize(mesh);
  const flattening::ChosenArray regions = flattening::chosenArray(this, input);
  if (!regions.Array)
  {
    throw flattening::InvalidInput("no array of regions is chosen: choose a point or cell array "
                                   "that is not 0 in the regions, such "
                                   "as SaliencyRegion of Mesh Saliency");
  }
  const std::vector<char> inRegion = flattening::pointsWhereNotZero(input, regions);
  const flattening::DerivedMesh coarse =
    flattening::decimateContext(mesh, inRegion, this->ContextFaces, flattening::progressOf(this));
  flattening::setRegion(output, input, coarse);
  const long long kept = cellsAround(mesh, inRegion);
  vtkFieldData* data = output->GetFieldData();
  flattening::setDatum(
    data, "RegionPoints", static_cast<long long>(std::count(inRegion.begin(), inRegion.end(), 1)));
  flattening::setDatum(data, "KeptCells", kept);
  flattening::setDatum(data, "ContextCells", coarse.Mesh.faceCount() - kept);
}

void vtkContextResolution::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ContextFaces: " << this->ContextFaces << "\n";
}
