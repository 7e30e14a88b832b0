// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/VolumeSampling.h"

#include "Core/Base/Errors.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace flattening
{
namespace
{

// The numbers of voxels and of samples between two reports of progress, at which an abort is
// noticed.
constexpr vtkIdType Batch = 1 << 20;
constexpr Eigen::Index SampleBatch = 1 << 18;

// How far outside of the volume a point may lie, in voxels along each axis. The value is above rounding
// and far below what a user sees.
constexpr double OutsideTolerance = 1e-6;

// Whether an array has values that single precision need not hold.
bool needsDouble(vtkDataArray* array)
{
  return array->GetDataType() != VTK_FLOAT && array->GetDataTypeSize() > 2;
}

vtkSmartPointer<vtkDataArray> inFloatingPoint(vtkDataArray* array,
  int type,
  const ProgressCallback& progress)
{
  const auto values = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  const vtkIdType count = array->GetNumberOfTuples();
  values->SetNumberOfComponents(array->GetNumberOfComponents());
  values->SetNumberOfTuples(count);
  for (vtkIdType begin = 0; begin < count; begin += Batch)
  {
    report(progress, static_cast<double>(begin) / static_cast<double>(count), "Reading the volume");
    values->InsertTuples(begin, std::min(Batch, count - begin), begin, array);
  }
  return values;
}

// Throws InvalidInput unless voxels have a size along each axis. A single slice needs none: it gets one,
// so that VTK can tell which voxel a place is in.
void requireVoxels(vtkImageData* volume)
{
  const int* size = volume->GetDimensions();
  double lengths[3];
  volume->GetSpacing(lengths);
  for (int k = 0; k < 3; ++k)
  {
    const bool isLength = lengths[k] != 0.0 && std::isfinite(lengths[k]);
    if (!isLength && size[k] > 1)
    {
      throw InvalidInput("a voxel has the size " + formatted(lengths[k]) + " along axis " +
                         std::to_string(k + 1) +
                         ": set the Spacing of the volume to what it was scanned with");
    }
    lengths[k] = isLength ? lengths[k] : 1.0;
  }
  volume->SetSpacing(lengths);
}

// The id of the voxel whose centre is nearest to a point in the volume.
vtkIdType nearestVoxel(vtkImageData* volume, const Eigen::RowVector3d& point)
{
  double index[3];
  volume->TransformPhysicalPointToContinuousIndex(point.data(), index);
  int voxel[3];
  for (int k = 0; k < 3; ++k)
  {
    // VTK takes points just outside for points of the volume.
    const int* ends = volume->GetExtent() + 2 * k;
    voxel[k] = std::clamp(static_cast<int>(std::lround(index[k])), ends[0], ends[1]);
  }
  return volume->ComputePointId(voxel);
}

// Whether a point lies between the first and the last voxels' centres, up to OutsideTolerance and the
// rounding of its coordinates. VTK's probe takes points for inside that are a thousandth of a voxel's
// diagonal outside, which is many voxels where these are thin.
bool isBetweenVoxels(vtkImageData* volume, const Eigen::RowVector3d& point)
{
  double index[3];
  volume->TransformPhysicalPointToContinuousIndex(point.data(), index);
  const Eigen::RowVector3d origin(volume->GetOrigin());
  const Eigen::RowVector3d coordinates = point.cwiseAbs() + origin.cwiseAbs();
  for (int k = 0; k < 3; ++k)
  {
    const int* ends = volume->GetExtent() + 2 * k;
    double coordinate = 0.0; // along the axis, at most
    for (int j = 0; j < 3; ++j)
    {
      coordinate += std::abs(volume->GetDirectionMatrix()->GetElement(j, k)) * coordinates[j];
    }
    const double slack = OutsideTolerance + 4.0 * std::numeric_limits<double>::epsilon() * coordinate /
                                              std::abs(volume->GetSpacing()[k]);
    if (!(index[k] >= ends[0] - slack && index[k] <= ends[1] + slack))
    {
      return false;
    }
  }
  return true;
}

vtkSmartPointer<vtkPolyData> pointsOnly(const Points3& points)
{
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  positions->SetNumberOfPoints(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    // A coordinate that is not finite would make VTK look into a cell that does not exist.
    const Eigen::RowVector3d point = points.row(i).allFinite()
                                       ? Eigen::RowVector3d(points.row(i))
                                       : Eigen::RowVector3d::Constant(std::numeric_limits<float>::max());
    positions->SetPoint(i, point.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(positions);
  return data;
}

} // namespace

std::vector<vtkDataArray*> sampledArrays(vtkImageData* volume)
{
  std::vector<vtkDataArray*> arrays;
  for (int a = 0; a < volume->GetPointData()->GetNumberOfArrays(); ++a)
  {
    if (vtkDataArray* array = volume->GetPointData()->GetArray(a); array && array->GetName())
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

int sampledType(vtkDataArray* array, bool nearest)
{
  return nearest && needsDouble(array) ? VTK_DOUBLE : VTK_FLOAT;
}

VolumeSampling::VolumeSampling(vtkImageData* volume,
  bool nearest,
  const Eigen::Affine3d& toVolume,
  const ProgressCallback& progress)
  : Volume(vtkSmartPointer<vtkImageData>::New())
  , Nearest(nearest)
  , ToVolume(toVolume)
{
  this->Volume->CopyStructure(volume);
  requireVoxels(this->Volume);
  // VTK 9.3 copies the marks of hidden voxels with the structure: they would be taken for the first
  // array, and leave hidden voxels without values that older versions of VTK give them.
  this->Volume->GetPointData()->Initialize();
  this->Volume->GetCellData()->Initialize();
  const std::vector<vtkDataArray*> arrays = sampledArrays(volume);
  for (vtkDataArray* array : arrays)
  {
    const double done = this->Names.size();
    const double count = arrays.size();
    const vtkSmartPointer<vtkDataArray> values = inFloatingPoint(
      array, sampledType(array, nearest), subrange(progress, done / count, (done + 1.0) / count));
    values->SetName(std::to_string(this->Names.size()).c_str());
    this->Volume->GetPointData()->AddArray(values);
    this->Names.emplace_back(array->GetName());
  }
  if (arrays.empty())
  {
    throw InvalidInput(
      "the volume has no numbers at its points: choose another, or turn its cell arrays "
      "into point arrays (Cell Data To Point Data)");
  }
}

VolumeSampling::~VolumeSampling() = default;

std::vector<VolumeSamples> VolumeSampling::at(const Points3& points,
  const ProgressCallback& progress) const
{
  std::vector<VolumeSamples> samples(this->Names.size());
  for (std::size_t a = 0; a < this->Names.size(); ++a)
  {
    vtkDataArray* voxels = this->Volume->GetPointData()->GetArray(static_cast<int>(a));
    samples[a].Values = vtk::TakeSmartPointer(voxels->NewInstance());
    samples[a].Values->SetName(this->Names[a].c_str());
    samples[a].Values->SetNumberOfComponents(voxels->GetNumberOfComponents());
    samples[a].Values->SetNumberOfTuples(points.rows());
    samples[a].Inside.resize(points.rows());
  }
  for (Eigen::Index begin = 0; begin < points.rows(); begin += SampleBatch)
  {
    report(
      progress, static_cast<double>(begin) / static_cast<double>(points.rows()), "Sampling the volume");
    const Eigen::Index count = std::min(SampleBatch, points.rows() - begin);
    const Points3 moved =
      (points.middleRows(begin, count) * this->ToVolume.linear().transpose()).rowwise() +
      this->ToVolume.translation().transpose();
    this->sample(moved, begin, samples);
  }
  return samples;
}

// The volume that VTK interpolates: without arrays if the values of single voxels are taken.
vtkSmartPointer<vtkImageData> VolumeSampling::probed() const
{
  if (!this->Nearest)
  {
    return this->Volume;
  }
  auto bare = vtkSmartPointer<vtkImageData>::New();
  bare->CopyStructure(this->Volume);
  return bare;
}

// Writes the samples of the points to the tuples from @p first on.
void VolumeSampling::sample(const Points3& points,
  vtkIdType first,
  std::vector<VolumeSamples>& samples) const
{
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(pointsOnly(points));
  probe->SetSourceData(this->probed());
  probe->Update();
  vtkPointData* found = probe->GetOutput()->GetPointData();
  vtkDataArray* valid = found->GetArray(probe->GetValidPointMaskArrayName());
  for (std::size_t a = 0; a < samples.size(); ++a)
  {
    const std::string name = std::to_string(a);
    vtkDataArray* voxels = this->Volume->GetPointData()->GetArray(name.c_str());
    vtkDataArray* values = samples[a].Values;
    const std::vector<double> none(
      values->GetNumberOfComponents(), std::numeric_limits<double>::quiet_NaN());
    if (!this->Nearest)
    {
      values->InsertTuples(first, points.rows(), 0, found->GetArray(name.c_str()));
    }
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      const bool isInside = valid->GetTuple1(i) != 0.0 && isBetweenVoxels(this->Volume, points.row(i));
      samples[a].Inside[first + i] = isInside;
      if (!isInside)
      {
        values->SetTuple(first + i, none.data());
      }
      else if (this->Nearest)
      {
        values->SetTuple(first + i, nearestVoxel(this->Volume, points.row(i)), voxels);
      }
    }
  }
}

} // namespace flattening
