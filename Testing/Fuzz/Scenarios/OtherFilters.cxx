// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Oracles/FilterRun.h"
#include "../Oracles/ImageOracle.h"
#include "../Oracles/RegionOracle.h"
#include "../Oracles/SlabOracle.h"
#include "../Oracles/TransferOracle.h"
#include "../Oracles/WarpOracle.h"
#include "../Oracles/WeightsOracle.h"
#include "Scenarios.h"

#include <vtkAreaWeights.h>
#include <vtkContextResolution.h>
#include <vtkDistortionMetrics.h>
#include <vtkDoubleArray.h>
#include <vtkFlatMapImage.h>
#include <vtkFlatMapSlab.h>
#include <vtkFlatMapTransfer.h>
#include <vtkFlattenRegion.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMeshSaliency.h>
#include <vtkNew.h>
#include <vtkPlanarWarp.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSphere.h>
#include <vtkVolumeToSurface.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fuzz
{
namespace
{

constexpr const char* LabelArray = "FuzzLabels";

// The surface, its disk or its conformal map, or its map that keeps areas; with labels.
vtkSmartPointer<vtkPolyData> stageOf(const Case& one, Random& random, Findings& findings)
{
  const int stage = random.integer(0, 4);
  vtkSmartPointer<vtkPolyData> data = one.Surface;
  const Chain chain = newChain(one, stage == 4);
  chain.front()->SetInputDataObject(one.Surface);
  const std::size_t filters = stage == 0 ? 0 : stage == 1 ? 1 : stage < 4 ? 2 : 3;
  for (std::size_t f = 0; f < filters; ++f)
  {
    runFilter(chain[f], findings);
    data = vtkPolyData::SafeDownCast(chain[f]->GetOutputDataObject(0));
  }
  const auto labelled = vtkSmartPointer<vtkPolyData>::New();
  labelled->ShallowCopy(data);
  const int seed = random.integer(0, 1000);
  double bounds[6];
  data->GetBounds(bounds);
  vtkNew<vtkIntArray> labels;
  labels->SetName(LabelArray);
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    const double x = (data->GetPoint(p)[seed % 3] - bounds[2 * (seed % 3)]) /
                     (bounds[2 * (seed % 3) + 1] - bounds[2 * (seed % 3)]);
    labels->InsertNextValue(x < 0.5 ? 1 : x < 0.7 ? 2 : 0);
  }
  labelled->GetPointData()->AddArray(labels);
  return labelled;
}

vtkSmartPointer<vtkSelection> randomSelection(Random& random, vtkPolyData* data)
{
  const bool ofPoints = random.chance(0.5);
  const auto count = static_cast<int>(ofPoints ? data->GetNumberOfPoints() : data->GetNumberOfCells());
  vtkNew<vtkIdTypeArray> ids;
  for (int n = random.integer(0, 20); n > 0; --n)
  {
    ids->InsertNextValue(
      random.integer(random.chance(0.05) ? -3 : 0, count + (random.chance(0.05) ? 5 : 0)));
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetFieldType(ofPoints ? vtkSelectionNode::POINT : vtkSelectionNode::CELL);
  node->SetSelectionList(ids);
  auto selection = vtkSmartPointer<vtkSelection>::New();
  selection->AddNode(node);
  return selection;
}

// A volume around the points of the surface.
vtkSmartPointer<vtkImageData> volumeAround(Random& random, vtkPolyData* data)
{
  double bounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  vtkDataArray* places = data->GetPointData()->GetArray("SurfacePoints");
  for (int k = 0; places && places->GetNumberOfComponents() == 3 && k < 3; ++k)
  {
    places->GetRange(bounds + 2 * k, k);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int dimensions[3] = { random.integer(1, 12), random.integer(2, 12), random.integer(2, 12) };
  image->SetDimensions(dimensions);
  image->SetOrigin(bounds[0], bounds[2], bounds[4]);
  image->SetSpacing((bounds[1] - bounds[0]) / dimensions[0],
    (bounds[3] - bounds[2]) / dimensions[1],
    (bounds[5] - bounds[4]) / dimensions[2]);
  image->AllocateScalars(VTK_SHORT, random.integer(1, 2));
  auto* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < scalars->GetNumberOfComponents(); ++k)
    {
      scalars->SetComponent(i, k, random.integer(-1000, 1000));
    }
  }
  scalars->SetName("Values");
  return image;
}

// A picture of one slice over the undeformed mesh of a flat map, or over a part of it.
vtkSmartPointer<vtkImageData> pictureOn(Random& random, vtkPolyData* data)
{
  const auto image = volumeAround(random, data);
  int size[3];
  image->GetDimensions(size);
  image->SetDimensions(std::max(size[0], 2), size[1], 1);
  const double share = random.chance(0.5) ? 1.0 : random.uniform(0.3, 2.0);
  const double* spacing = image->GetSpacing();
  image->SetSpacing(share * spacing[0], share * spacing[1], 1.0);
  const int components = image->GetNumberOfScalarComponents();
  image->AllocateScalars(VTK_SHORT, components);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->SetName("Values");
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      scalars->SetComponent(i, k, random.integer(-1000, 1000));
    }
  }
  return image;
}

template <typename Filter>
vtkSmartPointer<vtkAlgorithm> newFilter(vtkPolyData* input)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputDataObject(0, input);
  return filter;
}

vtkSmartPointer<vtkAlgorithm> newFilter(const std::string& name,
  vtkPolyData* input,
  const Case& one,
  Random& random)
{
  if (name == "AreaWeights" || name == "FlattenRegion")
  {
    auto filter =
      name == "AreaWeights" ? newFilter<vtkAreaWeights>(input) : newFilter<vtkFlattenRegion>(input);
    filter->SetInputDataObject(1, randomSelection(random, input));
    if (auto* weights = vtkAreaWeights::SafeDownCast(filter))
    {
      vtkNew<vtkSphere> sphere;
      sphere->SetCenter(input->GetNumberOfPoints() > 0 ? input->GetPoint(0) : sphere->GetCenter());
      sphere->SetRadius(input->GetLength() * random.logUniform(1e-3, 1.0));
      weights->SetImplicitFunction(sphere);
    }
    return filter;
  }
  if (name == "FlatMapTransfer")
  {
    auto filter = newFilter<vtkFlatMapTransfer>(input);
    filter->SetInputDataObject(1, one.Surface);
    return filter;
  }
  if (name == "FlatMapSlab")
  {
    auto filter = newFilter<vtkFlatMapSlab>(input);
    filter->SetInputDataObject(1, volumeAround(random, input));
    return filter;
  }
  if (name == "PlanarWarp")
  {
    auto filter = newFilter<vtkPlanarWarp>(input);
    const bool warpsImage = random.chance(0.3);
    const vtkSmartPointer<vtkDataObject> carried =
      warpsImage ? vtkSmartPointer<vtkDataObject>(pictureOn(random, input))
                 : vtkSmartPointer<vtkDataObject>(one.Surface);
    filter->SetInputDataObject(1, carried);
    return filter;
  }
  if (name == "VolumeToSurface")
  {
    auto filter = vtkSmartPointer<vtkVolumeToSurface>::New();
    filter->SetInputData(volumeAround(random, input));
    return filter;
  }
  return name == "MeshSaliency"        ? newFilter<vtkMeshSaliency>(input)
         : name == "ContextResolution" ? newFilter<vtkContextResolution>(input)
         : name == "FlatMapImage"      ? newFilter<vtkFlatMapImage>(input)
                                       : newFilter<vtkDistortionMetrics>(input);
}

// Judges the output of a filter. Those of Mesh Saliency, Volume To Surface and Distortion Metrics have
// no oracle here.
void checkResult(vtkAlgorithm* filter, vtkPolyData* input, Findings& findings)
{
  vtkDataArray* labels = input->GetPointData()->GetArray(LabelArray);
  vtkDataObject* second =
    filter->GetNumberOfInputPorts() > 1 ? filter->GetInputDataObject(1, 0) : nullptr;
  if (auto* region = vtkFlattenRegion::SafeDownCast(filter))
  {
    checkRegion(region, input, labels, findings);
  }
  else if (auto* image = vtkFlatMapImage::SafeDownCast(filter))
  {
    checkImage(image, findings);
  }
  else if (auto* slab = vtkFlatMapSlab::SafeDownCast(filter))
  {
    checkSlab(slab, findings);
  }
  else if (auto* weights = vtkAreaWeights::SafeDownCast(filter))
  {
    checkWeights(weights, input, labels, findings);
  }
  else if (auto* context = vtkContextResolution::SafeDownCast(filter))
  {
    checkContext(context, input, labels, findings);
  }
  else if (auto* warp = vtkPlanarWarp::SafeDownCast(filter))
  {
    checkWarp(warp, input, second, findings);
  }
  else if (auto* transfer = vtkFlatMapTransfer::SafeDownCast(filter))
  {
    checkTransfer(transfer->GetOutput(), input, vtkPolyData::SafeDownCast(second), findings);
  }
}

} // namespace

const std::vector<std::string>& otherFilters()
{
  static const std::vector<std::string> names = { "AreaWeights",
    "ContextResolution",
    "DistortionMetrics",
    "FlatMapImage",
    "FlatMapSlab",
    "FlatMapTransfer",
    "FlattenRegion",
    "MeshSaliency",
    "PlanarWarp",
    "VolumeToSurface" };
  return names;
}

void runOtherFilter(const Case& one, Findings& findings)
{
  Random random = scenarioRandom(one);
  const vtkSmartPointer<vtkPolyData> input = stageOf(one, random, findings);
  for (int n = 0; n < 3; ++n)
  {
    const std::string name = random.pick(otherFilters());
    const auto filter = newFilter(name, input, one, random);
    if (random.chance(0.9))
    {
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, LabelArray);
    }
    apply(one.Values, name, filter);
    if (runFilter(filter, findings).HasResult)
    {
      checkResult(filter, input, findings);
    }
  }
}

} // namespace fuzz
