// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether Flat Map Image shows the flat map: its grid, its mask, and the values of pixels.
#pragma once

#include "../Findings.h"

class vtkFlatMapImage;

namespace fuzz
{

/// @param filter has made an image that is not empty.
void checkImage(vtkFlatMapImage* filter, Findings& findings);

} // namespace fuzz
