// SPDX-License-Identifier: GPL-3.0-or-later
/// An isosurface of a volume as from a scanner: folded, closed, with all the slivers that contouring
/// makes.
#pragma once

#include <vtkContourFilter.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>

namespace flattening::testing
{

/// A ball of radius about 16 mm with folds of a few mm, from @p size^3 voxels over 48 mm. With @p
/// cut it is open where it leaves the volume, at x = 3 mm.
inline vtkSmartPointer<vtkPolyData> foldedBall(int size, bool cut)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, size);
  const double spacing = 48.0 / (size - 1);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(cut ? 3.0 : -24.0, -24.0, -24.0);
  vtkNew<vtkFloatArray> values;
  values->SetName("Intensity");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    const double folds = std::sin(0.45 * x[0] + 1.0) * std::sin(0.4 * x[1]) * std::sin(0.5 * x[2] + 2.0);
    values->InsertNextValue(static_cast<float>(100.0 * (16.0 + 3.0 * folds - r)));
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

} // namespace flattening::testing
