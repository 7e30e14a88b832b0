// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatteningClient.h"

#include "AbortButton.h"
#include "ApplyNotice.h"
#include "CutDisplays.h"
#include "FlatMapCameras.h"
#include "FlatteningCommands.h"
#include "MainWindow.h"
#include "PadProposals.h"
#include "PercentBars.h"
#include "RegionViews.h"
#include "SeamPreviews.h"

#include <QTimer>

#include <vtkPVRepresentedArrayListSettings.h>
#include <vtkSMProxyManager.h>

#include <set>
#include <string>

namespace
{

// The arrays of reports, some eighty: each has one value for the whole surface, so that "Colour by" does
// not offer them. Whole names, as the setting hides arrays of other data, too; in parts, as VTK
// takes no more than 32 parentheses in one expression.
constexpr const char* ReportNames[] = {
  "^(AirValue|Bijective|Boundary(Anisotropy|Iterations|Length|Vertices)|ChosenCut)$",
  "^(ClassSeparation|ClosedCracks|Components|DegenerateFaces)$",
  "^(Dropped(Area|Cells|ComponentArea|Components|DegenerateFaces|DuplicateFaces|Faces))$",
  "^(FacesWithin2Percent|Filled(Area|Holes)|FlatArea|FlippedFaces|FoldAreaChange|Genus)$",
  "^(Handle(AreaAdded|AreaRemoved|Displacement|LoopLengths)|Hole(Centre|Radius))$",
  "^(IsosurfaceComponents|Isovalue|Left(Folded|OutArea)|LengthScale)$",
  "^(Max(CellArea|Curvature)Error|Mean(Above|Below)|MergedPoints|NewtonIterations)$",
  "^(NotFiniteVoxels|ReasonOfCut|Refinement(Repairs|Rounds)|Relief(Branches|Length|Strain))$",
  "^(RemeshEdgeLength|Removed(Area|Fins|Handles|RegionPoints|Spikes)|ReorientedFaces)$",
  "^(RingDistanceError|RootMeanSquareStretch|SD(Log)?AreaRatio|SeamLength|SeamRegionPoints)$",
  "^(SelfIntersections(Before)?|ShareBelow|SmallestAngle|SmoothingLength|SplitPoints)$",
  "^(SurfaceArea|UnusedPoints|(Mean|StandardError|P95)(Local|WithinMap|Global)LengthError)$",
  "^((Mean|AreaWeightedMean|P95|P99|Max)(AreaError|AreaDistortion|AngleDistortion|AngleError))$",
  "^((Mean|AreaWeightedMean|P95|P99|Max)(BeltramiMagnitude|StretchL2|SymmetricDirichlet))$"
};

void hideReports()
{
  vtkPVRepresentedArrayListSettings* settings = vtkPVRepresentedArrayListSettings::GetInstance();
  std::set<std::string> known;
  for (int i = 0; i < settings->GetNumberOfFilterExpressions(); ++i)
  {
    known.insert(settings->GetFilterExpression(i));
  }
  for (const char* names : ReportNames)
  {
    if (known.count(names) == 0)
    {
      const int count = settings->GetNumberOfFilterExpressions();
      settings->SetNumberOfFilterExpressions(count + 1);
      settings->SetFilterExpression(count, names);
    }
  }
}

} // namespace

void FlatteningClient::startup()
{
  // ParaView 6.1 loads the plugins that it finds by itself before it has made its window.
  if (!mainWindow())
  {
    QTimer::singleShot(0, this, [this] { this->startup(); });
    return;
  }
  hideReports();
  new CutDisplays(this); // first, so that cameras see what is left of the cuts
  new FlatMapCameras(this);
  new FlatteningCommands(this);
  new PadProposals(this);
  new PercentBars(this);
  new RegionViews(this);
  new SeamPreviews(this);
  new AbortButton(this);
  new ApplyNotice(this);
}
