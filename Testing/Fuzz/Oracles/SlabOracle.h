// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether Flat Map Slab shows the values of the volume below the surface, on the map and on the stack
/// of images. Volumes that say where they lie in the patient are not judged.
#pragma once

#include "../Findings.h"

class vtkFlatMapSlab;

namespace fuzz
{

/// @param filter has made a slab that is not empty.
void checkSlab(vtkFlatMapSlab* filter, Findings& findings);

} // namespace fuzz
