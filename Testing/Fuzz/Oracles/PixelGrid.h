// SPDX-License-Identifier: GPL-3.0-or-later
/// Images over a flat map: where their pixels must lie, and which of them are checked.
#pragma once

#include "../Findings.h"
#include "FlatPlaces.h"

#include <vtkType.h>

#include <functional>
#include <vector>

class vtkImageData;
class vtkInformation;

namespace fuzz
{

/// How far apart a position of the map may be from the one that was meant: the rounding of the centre
/// of a pixel and of the search for it.
long double placeRounding(const Square& square);

/// How far outside of the map a pixel may be taken for one in the map, as one on its boundary may be.
long double boundaryRounding(const Square& square);

/// The centre of a pixel of the first layer, in the plane of the map.
Point centreOf(vtkImageData* image, vtkIdType pixel);

/// Whether the image has square pixels that fill the square around the map, and whether the grid that
/// was announced is that of the image.
void checkPixelGrid(vtkInformation* announced,
  vtkImageData* image,
  const Square& square,
  Findings& findings);

/// About a hundred pixels of the first layer: half of them where @p stateOf changes from one pixel to
/// the next, if it does.
std::vector<vtkIdType> somePixels(vtkImageData* image, const std::function<int(vtkIdType)>& stateOf);

} // namespace fuzz
