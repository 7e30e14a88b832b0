// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMapCameras.h"

#include "ViewWatcher.h"

#include <pqDataRepresentation.h>
#include <pqRenderView.h>
#include <pqUndoStack.h>

#include <vtkPVArrayInformation.h>
#include <vtkPVDataInformation.h>
#include <vtkPVDataSetAttributesInformation.h>
#include <vtkPVRenderView.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <utility>

namespace
{

constexpr const char* CameraModes[] = { "InteractionMode", "CameraParallelProjection" };
constexpr const char* CameraPlaces[] = { "CameraPosition",
  "CameraFocalPoint",
  "CameraViewUp",
  "CameraParallelScale",
  "CenterOfRotation" };

// Whether it shows a surface that was flattened to a plane of constant z.
bool showsFlatMap(pqRepresentation* representation)
{
  auto* shown = qobject_cast<pqDataRepresentation*>(representation);
  vtkPVDataInformation* data = shown && shown->isVisible() ? shown->getInputDataInformation() : nullptr;
  if (!data || data->GetNumberOfCells() == 0 ||
      !data->GetPointDataInformation()->GetArrayInformation("SurfacePoints"))
  {
    return false;
  }
  const double* bounds = data->GetBounds();
  return bounds[4] == bounds[5];
}

bool showsFlatMap(pqRenderView* view)
{
  for (pqRepresentation* representation : view->getRepresentations())
  {
    if (showsFlatMap(representation))
    {
      return true;
    }
  }
  return false;
}

} // namespace

FlatMapCameras::FlatMapCameras(QObject* parent)
  : QObject(parent)
{
  new ViewWatcher(this, [this](pqRenderView* view) { this->update(view); });
}

void FlatMapCameras::update(pqRenderView* view)
{
  const bool flat = showsFlatMap(view);
  if (flat == this->Before.contains(view))
  {
    return;
  }
  SCOPED_UNDO_EXCLUDE();
  vtkSMProxy* proxy = view->getProxy();
  const bool is2D =
    vtkSMPropertyHelper(proxy, "InteractionMode").GetAsInt() == vtkPVRenderView::INTERACTION_MODE_2D;
  if (flat)
  {
    Camera camera;
    if (!is2D)
    {
      for (const char* name : CameraModes)
      {
        camera.Modes.push_back(vtkSMPropertyHelper(proxy, name).GetAsInt());
      }
      for (const char* name : CameraPlaces)
      {
        camera.Places.push_back(vtkSMPropertyHelper(proxy, name).GetArray<double>());
      }
      vtkSMPropertyHelper(proxy, "InteractionMode").Set(vtkPVRenderView::INTERACTION_MODE_2D);
      proxy->UpdateVTKObjects();
      view->resetViewDirection(0.0, 0.0, -1.0, 0.0, 1.0, 0.0);
    }
    this->Before.insert(view, camera);
    connect(view, &QObject::destroyed, this, [this, view] { this->Before.remove(view); });
    return;
  }
  const Camera camera = this->Before.take(view);
  if (is2D && !camera.Modes.empty())
  {
    for (std::size_t i = 0; i < camera.Modes.size(); ++i)
    {
      vtkSMPropertyHelper(proxy, CameraModes[i]).Set(camera.Modes[i]);
    }
    for (std::size_t i = 0; i < camera.Places.size(); ++i)
    {
      vtkSMPropertyHelper(proxy, CameraPlaces[i])
        .Set(camera.Places[i].data(), static_cast<unsigned int>(camera.Places[i].size()));
    }
    proxy->UpdateVTKObjects();
    view->render();
  }
}
