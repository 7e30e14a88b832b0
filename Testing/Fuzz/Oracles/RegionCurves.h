// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether the curves of Flatten Region are right: the outline of the region, which is smoothed before
/// it is measured, the greatest diameter and the extent across it.
#pragma once

#include "../Findings.h"
#include "RegionOriginals.h"

class vtkFlattenRegion;

namespace fuzz
{

/// Whether the curves lie on the region, have the lengths that the filter reports, and are as long or as
/// short as they must be.
/// @param filter its table of measures has four rows
void checkCurves(const Region& region, vtkFlattenRegion* filter, Findings& findings);

} // namespace fuzz
