// SPDX-License-Identifier: GPL-3.0-or-later
/// The cut that CutMode::Automatic makes.
#pragma once

#include "Disk/ReliefPlacement.h"
#include "Disk/SurfaceToDiskOptions.h"

namespace flattening
{

/// What the choice depends on besides the options.
struct CutSituation
{
  bool IsClosed = true;            ///< whether the surface has no boundary
  bool HasHolePoint = false;       ///< whether the centre of a hole was given
  bool CutsHandles = false;        ///< whether handles are to be cut open
  bool RegionIsEverywhere = false; ///< whether the region of interest is the whole surface
};

struct CutChoice
{
  CutMode Cut;        ///< Hole for an open surface: it is left as it is
  const char* Reason; ///< the rest of a sentence
};

/// The reason for which an open surface is not cut.
extern const char* const KeptBoundary;

/// Chooses a cut whose place is given; else a relief, but for a surface with a boundary that was cut or
/// chosen, or that has to be cut along its handles. An open surface gets a relief only if its strain
/// asks for it (automaticRelief).
CutChoice automaticCut(const SurfaceToDiskOptions& options, const CutSituation& situation);

/// The bounds of the relief that Automatic cuts: one that suits a disk, too.
ReliefOptions automaticRelief(const ReliefOptions& asked);

} // namespace flattening
