// SPDX-License-Identifier: GPL-3.0-or-later
// The properties of every filter. A property that is new in a filter is added here.
#include "Settings.h"

#include <vtkAreaWeights.h>
#include <vtkConformalDiskFilter.h>
#include <vtkContextResolution.h>
#include <vtkDistortionMetrics.h>
#include <vtkFlatMapImage.h>
#include <vtkFlatMapSlab.h>
#include <vtkFlatMapTransfer.h>
#include <vtkFlattenRegion.h>
#include <vtkMeshSaliency.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkPlanarWarp.h>
#include <vtkSurfaceToDiskFilter.h>
#include <vtkVolumeToSurface.h>

#include <stdexcept>

namespace fuzz
{
namespace
{

// A property whose setter takes one number.
template <typename Filter, typename Number>
Property number(const char* name, Kind kind, double low, double high, void (Filter::*set)(Number))
{
  return { name, kind, low, high, [set](vtkAlgorithm* filter, const std::vector<double>& values) {
            (static_cast<Filter*>(filter)->*set)(static_cast<Number>(values.at(0)));
          } };
}

template <typename Filter, typename Number>
Property flag(const char* name, void (Filter::*set)(Number))
{
  return number(name, Kind::Flag, 0.0, 1.0, set);
}

// A property whose setter takes three numbers.
template <typename Filter>
Property vector(const char* name, Kind kind, void (Filter::*set)(double, double, double))
{
  return { name, kind, 0.0, 1.0, [set](vtkAlgorithm* filter, const std::vector<double>& values) {
            (static_cast<Filter*>(filter)->*set)(values.at(0), values.at(1), values.at(2));
          } };
}

template <typename Filter, typename Set>
Property calling(const char* name, Kind kind, double low, double high, const Set& set)
{
  return { name, kind, low, high, [set](vtkAlgorithm* filter, const std::vector<double>& values) {
            set(static_cast<Filter*>(filter), values);
          } };
}

std::vector<Property> surfaceToDisk()
{
  using F = vtkSurfaceToDiskFilter;
  return { number("MergeTolerance", Kind::Length, 1e-9, 1e-1, &F::SetMergeTolerance),
    number("ComponentMode", Kind::Choice, 0, 2, &F::SetComponentMode),
    vector("ComponentPoint", Kind::Position, &F::SetComponentPoint),
    number("ComponentIndex", Kind::Count, 0, 5, &F::SetComponentIndex),
    number("BoundaryMode", Kind::Choice, 0, 2, &F::SetBoundaryMode),
    vector("BoundaryPoint", Kind::Position, &F::SetBoundaryPoint),
    number("FillLengthLimit", Kind::Length, 1e-2, 1e3, &F::SetFillLengthLimit),
    flag("FlattenFolds", &F::SetFlattenFolds),
    number("HandleMode", Kind::Choice, 0, 2, &F::SetHandleMode),
    number("CutMode", Kind::Choice, 0, 5, &F::SetCutMode),
    flag("UseHolePoint", &F::SetUseHolePoint),
    vector("HolePoint", Kind::Position, &F::SetHolePoint),
    number("HoleAreaFraction", Kind::Magnitude, 1e-6, 0.5, &F::SetHoleAreaFraction),
    calling<F>("SeamPoints",
      Kind::Position,
      0,
      1,
      [](F* filter, const std::vector<double>& x)
      {
        filter->SetUseSeamPoints(true);
        filter->AddSeamPoint(x.at(0), x.at(1), x.at(2));
      }),
    calling<F>("SecondSeamPoint",
      Kind::Position,
      0,
      1,
      [](F* filter, const std::vector<double>& x) { filter->AddSeamPoint(x.at(0), x.at(1), x.at(2)); }),
    calling<F>("SeamPathStart",
      Kind::Count,
      0,
      4,
      [](F* filter, const std::vector<double>& x)
      { filter->AddSeamPathStart(static_cast<int>(x.at(0))); }),
    number("ReliefGain", Kind::Magnitude, 1e-3, 1, &F::SetReliefGain),
    number("LongestRelief", Kind::Magnitude, 0.1, 20, &F::SetLongestRelief),
    flag("FreeOutline", &F::SetFreeOutline),
    number("CutLabel", Kind::Count, 0, 3, &F::SetCutLabel),
    vector("PlaneOrigin", Kind::Position, &F::SetPlaneOrigin),
    vector("PlaneNormal", Kind::Direction, &F::SetPlaneNormal),
    number("MinimumBoundaryVertices", Kind::Count, 3, 500, &F::SetMinimumBoundaryVertices),
    number("SmallestAngle", Kind::Fraction, 0, 15, &F::SetSmallestAngle),
    flag("Remesh", &F::SetRemesh),
    number("TargetEdgeLength", Kind::Length, 0.03, 1, &F::SetTargetEdgeLength),
    number("RelativeEdgeLength", Kind::Magnitude, 0.3, 3, &F::SetRelativeEdgeLength),
    flag("CountSelfIntersections", &F::SetCountSelfIntersections),
    flag("ScaledCurvature", &F::SetScaledCurvature) };
}

std::vector<Property> conformalDisk()
{
  using F = vtkConformalDiskFilter;
  return { number("Method", Kind::Choice, 0, 2, &F::SetMethod),
    number("Domain", Kind::Choice, 0, 1, &F::SetDomain),
    flag("UseCorners", &F::SetUseCorners),
    vector("LowerLeftCorner", Kind::Position, &F::SetLowerLeftCorner),
    vector("LowerRightCorner", Kind::Position, &F::SetLowerRightCorner),
    vector("UpperRightCorner", Kind::Position, &F::SetUpperRightCorner),
    vector("UpperLeftCorner", Kind::Position, &F::SetUpperLeftCorner),
    number("NormalizeTo", Kind::Choice, 0, 1, &F::SetNormalizeTo),
    flag("UseCenterPoint", &F::SetUseCenterPoint),
    vector("CenterPoint", Kind::Position, &F::SetCenterPoint),
    flag("UseBoundaryPoint", &F::SetUseBoundaryPoint),
    vector("BoundaryPoint", Kind::Position, &F::SetBoundaryPoint),
    number("Tolerance", Kind::Magnitude, 1e-14, 1e-10, &F::SetTolerance) };
}

std::vector<Property> areaPreserving()
{
  using F = vtkOMTAreaPreservingFilter;
  return { number("NormalizeTo", Kind::Choice, 0, 1, &F::SetNormalizeTo),
    number("Tolerance", Kind::Magnitude, 1e-12, 0.1, &F::SetTolerance),
    flag("UseAreaWeight", &F::SetUseAreaWeight),
    flag("FaceRefinement", &F::SetFaceRefinement),
    number("AngleWeight", Kind::Fraction, 0, 0.99, &F::SetAngleWeight),
    number("PointsPerSite", Kind::Count, 1, 1000, &F::SetPointsPerSite),
    flag("FixCorners", &F::SetFixCorners),
    flag("FreeOutline", &F::SetFreeOutline) };
}

std::vector<Property> distortionMetrics()
{
  using F = vtkDistortionMetrics;
  return { flag("UseTargetArea", &F::SetUseTargetArea),
    flag("UseRegionArray", &F::SetUseRegionArray),
    flag("MeasureLengths", &F::SetMeasureLengths),
    number("LengthRadius", Kind::Length, 1e-3, 2, &F::SetLengthRadius),
    number("LengthSamples", Kind::Count, 2, 40, &F::SetLengthSamples) };
}

std::vector<Property> areaWeights()
{
  using F = vtkAreaWeights;
  return { number("WeightsFrom", Kind::Choice, 0, 4, &F::SetWeightsFrom),
    number("Label", Kind::Choice, 0, 3, &F::SetLabel),
    number("Factor", Kind::Magnitude, 0.01, 100, &F::SetFactor),
    number("FactorMeaning", Kind::Choice, 0, 1, &F::SetFactorMeaning),
    number("EdgeWidth", Kind::Length, 1e-3, 1, &F::SetEdgeWidth),
    calling<F>("LabelFactor",
      Kind::Magnitude,
      0.1,
      10,
      [](F* filter, const std::vector<double>& x) { filter->AddLabelFactor(1.0, x.at(0)); }),
    calling<F>("CurveFactor",
      Kind::Magnitude,
      0.1,
      10,
      [](F* filter, const std::vector<double>& x)
      {
        filter->AddCurvePoint(0.0, 1.0);
        filter->AddCurvePoint(2.0, x.at(0));
      }),
    flag("InsideOut", &F::SetInsideOut) };
}

std::vector<Property> meshSaliency()
{
  using F = vtkMeshSaliency;
  return { number("Unit", Kind::Length, 1e-4, 0.1, &F::SetUnit),
    number("NumberOfScales", Kind::Count, 1, 20, &F::SetNumberOfScales),
    flag("AreaWeighted", &F::SetAreaWeighted),
    flag("PerScaleArrays", &F::SetPerScaleArrays),
    flag("FindRegions", &F::SetFindRegions),
    number("ThresholdType", Kind::Choice, 0, 1, &F::SetThresholdType),
    number("Percentile", Kind::Fraction, 0, 100, &F::SetPercentile),
    number("Threshold", Kind::Fraction, 0, 1, &F::SetThreshold),
    number("MinimumRegionArea", Kind::Area, 1e-4, 1, &F::SetMinimumRegionArea),
    number("MaximumRegionArea", Kind::Area, 1e-4, 1, &F::SetMaximumRegionArea) };
}

std::vector<Property> flattenRegion()
{
  using F = vtkFlattenRegion;
  return { number("RegionFrom", Kind::Choice, 0, 1, &F::SetRegionFrom),
    number("Label", Kind::Choice, 0, 3, &F::SetLabel),
    flag("AutomaticMargin", &F::SetAutomaticMargin),
    number("Margin", Kind::Length, 1e-3, 1, &F::SetMargin),
    number("LargestHoles", Kind::Fraction, 0, 2, &F::SetLargestHoles) };
}

std::vector<Property> flatMapSlab()
{
  using F = vtkFlatMapSlab;
  return { calling<F>("Depth",
             Kind::Length,
             1e-3,
             0.5,
             [](F* filter, const std::vector<double>& x)
             {
               filter->ClearDepths();
               filter->AddDepth(x.at(0));
               filter->AddDepth(-2.0 * x.at(0) - 0.125);
             }),
    flag("Outwards", &F::SetOutwards),
    flag("NearestVoxel", &F::SetNearestVoxel),
    number("StackSize", Kind::Count, 0, 64, &F::SetStackSize) };
}

std::vector<Property> planarWarp()
{
  using F = vtkPlanarWarp;
  return { number("OutsidePoints", Kind::Choice, 0, 1, &F::SetOutsidePoints),
    flag("SubdivideLines", &F::SetSubdivideLines),
    number("MaximumSegmentLength", Kind::Length, 1e-2, 1, &F::SetMaximumSegmentLength),
    number("ImageOutput", Kind::Choice, 0, 1, &F::SetImageOutput),
    calling<F>("ImageSize",
      Kind::Count,
      0,
      100,
      [](F* filter, const std::vector<double>& x)
      { filter->SetImageSize(static_cast<int>(x.at(0)), static_cast<int>(x.at(0))); }),
    flag("NearestPixel", &F::SetNearestPixel) };
}

std::vector<Property> volumeToSurface()
{
  using F = vtkVolumeToSurface;
  return { flag("AutomaticIsovalue", &F::SetAutomaticIsovalue),
    number("Isovalue", Kind::Fraction, -1100, 1100, &F::SetIsovalue),
    flag("AutomaticSmoothing", &F::SetAutomaticSmoothing),
    number("Smoothing", Kind::Length, 1e-3, 1, &F::SetSmoothing),
    number("Margin", Kind::Count, 0, 20, &F::SetMargin),
    flag("AutomaticAir", &F::SetAutomaticAir),
    number("Air", Kind::Fraction, -1100, 1100, &F::SetAir),
    number("ComponentMode", Kind::Choice, 0, 1, &F::SetComponentMode),
    flag("PatientSpace", &F::SetPatientSpace) };
}

const std::map<std::string, std::vector<Property>>& allProperties()
{
  static const std::map<std::string, std::vector<Property>> all = { { "SurfaceToDisk", surfaceToDisk() },
    { "ConformalDisk", conformalDisk() },
    { "OMTAreaPreserving", areaPreserving() },
    { "DistortionMetrics", distortionMetrics() },
    { "AreaWeights", areaWeights() },
    { "MeshSaliency", meshSaliency() },
    { "FlattenRegion", flattenRegion() },
    { "FlatMapSlab", flatMapSlab() },
    { "PlanarWarp", planarWarp() },
    { "VolumeToSurface", volumeToSurface() },
    { "ContextResolution",
      { number("ContextFaces", Kind::Count, 1, 1000, &vtkContextResolution::SetContextFaces) } },
    { "FlatMapImage",
      { number("Size", Kind::Count, 2, 128, &vtkFlatMapImage::SetSize),
        number("PixelLength", Kind::Length, 1e-2, 1, &vtkFlatMapImage::SetPixelLength),
        number("Margin", Kind::Count, 0, 20, &vtkFlatMapImage::SetMargin) } },
    { "FlatMapTransfer",
      { number("Tolerance", Kind::Length, 1e-6, 1, &vtkFlatMapTransfer::SetTolerance) } } };
  return all;
}

} // namespace

const std::vector<Property>& propertiesOf(const std::string& filter)
{
  const auto found = allProperties().find(filter);
  if (found == allProperties().end())
  {
    throw std::invalid_argument("there is no filter \"" + filter + "\"");
  }
  return found->second;
}

} // namespace fuzz
