// SPDX-License-Identifier: GPL-3.0-or-later
/// What image filters learn about the image of a filter before it runs.
#pragma once

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkImageShiftScale.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

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

} // namespace flattening::testing
