// SPDX-License-Identifier: GPL-3.0-or-later
/// What image filters learn about the image of a filter before it runs.
#pragma once

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkImageShiftScale.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>

namespace flattening::testing
{

/// Expects that an image filter after @p output, which has not run yet, has its extent, origin and
/// spacing, which VTK's image filters take from the information of the pipeline, not from the image.
/// @param array a point array of the image
inline void expectGridPassedOn(vtkAlgorithmOutput* output, const char* array)
{
  vtkNew<vtkImageShiftScale> after;
  after->SetInputConnection(output);
  after->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
  after->Update();
  auto* image =
    vtkImageData::SafeDownCast(output->GetProducer()->GetOutputDataObject(output->GetIndex()));
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_GT(image->GetDimensions()[axis], 0);
    EXPECT_EQ(after->GetOutput()->GetDimensions()[axis], image->GetDimensions()[axis]);
    EXPECT_EQ(after->GetOutput()->GetSpacing()[axis], image->GetSpacing()[axis]);
    EXPECT_EQ(after->GetOutput()->GetOrigin()[axis], image->GetOrigin()[axis]);
  }
  EXPECT_NE(image->GetSpacing()[0], 1.0);
}

/// Expects that an image filter after @p output, which has not run yet, gets the active scalars of its
/// image, of whose type VTK's image filters make theirs.
inline void expectScalarsPassedOn(vtkAlgorithmOutput* output)
{
  vtkNew<vtkImageShrink3D> same; // by factors of 1
  same->SetInputConnection(output);
  same->Update();
  auto* image =
    vtkImageData::SafeDownCast(output->GetProducer()->GetOutputDataObject(output->GetIndex()));
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkDataArray* passed = same->GetOutput()->GetPointData()->GetScalars();
  ASSERT_NE(scalars, nullptr);
  ASSERT_NE(passed, nullptr);
  EXPECT_EQ(passed->GetDataType(), scalars->GetDataType());
  ASSERT_EQ(passed->GetNumberOfComponents(), scalars->GetNumberOfComponents());
  ASSERT_EQ(passed->GetNumberOfTuples(), scalars->GetNumberOfTuples());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < scalars->GetNumberOfComponents(); ++k)
    {
      const double value = scalars->GetComponent(i, k);
      ASSERT_TRUE(passed->GetComponent(i, k) == value ||
                  (std::isnan(value) && std::isnan(passed->GetComponent(i, k))))
        << i << ": " << passed->GetComponent(i, k) << " for " << value;
    }
  }
}

} // namespace flattening::testing
