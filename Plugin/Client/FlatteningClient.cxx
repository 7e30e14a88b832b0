// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatteningClient.h"

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

#include <string>

namespace
{

// The arrays of reports, some eighty: each has one value for the whole surface, so that "Colour by" does
// not offer them.
constexpr const char* ReportNames =
  "^(Dropped.*|MergedPoints|UnusedPoints|ClosedCracks|SplitPoints|Components|ReorientedFaces|Removed.*|"
  "LeftFolded|Fold.*|Filled(Holes|Area)|Genus|Handle.*|Remesh.*|Hole.*|SeamLength|ChosenCut|ReasonOf.*|"
  "Relief.*|SeamRegionPoints|Boundary.*|SurfaceArea|FlatArea|SmallestAngle|SelfIntersections.*|Flipped"
  "Faces|DegenerateFaces|FacesWithin.*|RootMeanSquareStretch|Mean.*(Error|Distortion|Magnitude|"
  "StretchL2|"
  "Dirichlet)|AreaWeightedMean.*|P9[59].*|Max.*|SD.*|StandardError.*|RingDistanceError|LengthScale|"
  "AirValue|Isovalue|IsosurfaceComponents|LeftOutArea|MeanAbove|MeanBelow|NotFiniteVoxels|"
  "ClassSeparation|"
  "ShareBelow|SmoothingLength|"
  "Bijective|Method.*|.*Seconds|.*Iterations|Untangle.*|Newton.*|Refine.*)$";

void hideReports()
{
  vtkPVRepresentedArrayListSettings* settings = vtkPVRepresentedArrayListSettings::GetInstance();
  const int count = settings->GetNumberOfFilterExpressions();
  for (int i = 0; i < count; ++i)
  {
    if (std::string(settings->GetFilterExpression(i)) == ReportNames)
    {
      return;
    }
  }
  settings->SetNumberOfFilterExpressions(count + 1);
  settings->SetFilterExpression(count, ReportNames);
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
  new ApplyNotice(this);
}
