// SPDX-License-Identifier: GPL-3.0-or-later
/// The cut that CutMode::Automatic makes.
#pragma once

#include "Disk/ReliefPlacement.h"
#include "Disk/SurfaceToDiskOptions.h"

namespace flattening
{

/// The facts about a surface on which the choice depends, besides the options.
struct CutSituation
{
  bool IsClosed = true;            ///< whether the surface has no boundary
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

/// Chooses the cut whose place is given, if one is. Otherwise a closed surface gets a relief, or no cut
/// but that of its handles. An open surface gets a relief if its strain asks for it (automaticRelief),
/// unless it was cut before, its boundary was chosen by a point, its handles are cut, or the region of
/// interest is everywhere: then it keeps its boundary.
CutChoice automaticCut(const SurfaceToDiskOptions& options, const CutSituation& situation);

/// The bounds of the relief that Automatic cuts, within those that are asked for.
/// @param freeOutline  whether the flat map will have a free outline; if not, the relief suits a disk
ReliefOptions automaticRelief(const ReliefOptions& asked, bool freeOutline);

} // namespace flattening
