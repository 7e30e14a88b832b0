// SPDX-License-Identifier: GPL-3.0-or-later
#include "SeamPreviews.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkSMParaViewPipelineController.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxySelectionModel.h>
#include <vtkSMSession.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMViewProxy.h>

#include <string>
#include <vector>

namespace
{

// Milliseconds after the last change. A convention: below what one waits for, and rare enough for
// surfaces of a million triangles.
constexpr int Delay = 200;
constexpr double LineWidth = 3.0;
constexpr double Yellow[3] = { 1.0, 0.9, 0.2 };
constexpr const char* Watched[] = { "SeamPoints", "SeamPathStarts", "UseSeamPoints", "CutMode" };
constexpr int Seam = 1; // of CutMode
constexpr int Automatic = 5;

// The value of a property in the panel, whether it was applied or not.
int inPanel(vtkSMProxy* disk, const char* name)
{
  vtkSMPropertyHelper helper(disk, name);
  helper.SetUseUnchecked(true);
  return helper.GetAsInt();
}

template <typename Number>
void copyFromPanel(vtkSMProxy* disk, vtkSMProxy* preview, const char* name)
{
  vtkSMPropertyHelper helper(disk, name);
  helper.SetUseUnchecked(true);
  const std::vector<Number> values = helper.GetArray<Number>();
  vtkSMPropertyHelper(preview, name).Set(values.data(), static_cast<unsigned int>(values.size()));
}

bool picksPoints(vtkSMProxy* disk)
{
  const int cut = inPanel(disk, "CutMode");
  return inPanel(disk, "UseSeamPoints") != 0 && (cut == Seam || cut == Automatic);
}

vtkSMProxy* activeView(vtkSMProxy* proxy)
{
  vtkSMProxySelectionModel* active = proxy->GetSessionProxyManager()->GetSelectionModel("ActiveView");
  vtkSMProxy* view = active ? active->GetCurrentProxy() : nullptr;
  return view && std::string(view->GetXMLName()) == "RenderView" ? view : nullptr;
}

} // namespace

SeamPreviews::SeamPreviews(QObject* parent)
  : QObject(parent)
{
  this->Later.setSingleShot(true);
  this->Later.setInterval(Delay);
  connect(&this->Later, &QTimer::timeout, this, [this] { this->update(); });
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  connect(model, &pqServerManagerModel::sourceAdded, this, &SeamPreviews::watch);
  connect(model,
    &pqServerManagerModel::preSourceRemoved,
    this,
    [this](pqPipelineSource* source)
    {
      if (source == this->Edited)
      {
        this->remove();
      }
    });
}

SeamPreviews::~SeamPreviews() = default;

void SeamPreviews::watch(pqPipelineSource* source)
{
  vtkSMProxy* proxy = source->getProxy();
  if (std::string(proxy->GetXMLName()) != "SurfaceToDisk")
  {
    return;
  }
  for (const char* name : Watched)
  {
    proxy->GetProperty(name)->AddObserver(
      vtkCommand::UncheckedPropertyModifiedEvent, this, &SeamPreviews::changed);
  }
  // The preview is made later, because this signal comes while a view goes through its representations.
  connect(source,
    qOverload<pqPipelineSource*>(&pqPipelineSource::dataUpdated),
    this,
    [this] { this->Later.start(); });
}

void SeamPreviews::changed(vtkObject* property, unsigned long, void*)
{
  vtkSMProxy* disk = vtkSMProperty::SafeDownCast(property)->GetParent();
  auto* edited =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(disk);
  if (edited != this->Edited)
  {
    this->remove(); // the preview on the input of another filter
  }
  this->Edited = edited;
  this->Later.start();
}

void SeamPreviews::update()
{
  vtkSMProxy* disk = this->Edited ? this->Edited->getProxy() : nullptr;
  if (disk && disk->GetSession()->GetPendingProgress())
  {
    this->Later.start(); // a filter runs, and a view may be waiting for it
    return;
  }
  if (!disk || this->Edited->modifiedState() == pqProxy::UNMODIFIED || !picksPoints(disk))
  {
    this->remove();
    return;
  }
  SCOPED_UNDO_EXCLUDE();
  if (!this->Preview && !this->create(disk))
  {
    return;
  }
  copyFromPanel<double>(disk, this->Preview, "SeamPoints");
  copyFromPanel<int>(disk, this->Preview, "SeamPathStarts");
  this->Preview->UpdateVTKObjects();
  vtkSMViewProxy::SafeDownCast(this->View)->StillRender();
}

bool SeamPreviews::create(vtkSMProxy* disk)
{
  this->View = activeView(disk);
  vtkSMPropertyHelper input(disk, "Input");
  if (!this->View || input.GetNumberOfElements() == 0)
  {
    return false;
  }
  vtkSMSessionProxyManager* manager = disk->GetSessionProxyManager();
  vtkNew<vtkSMParaViewPipelineController> controller;
  const auto made = [&](const char* group, const char* name)
  {
    auto proxy = vtk::TakeSmartPointer(manager->NewProxy(group, name));
    controller->PreInitializeProxy(proxy);
    return proxy;
  };
  this->Preview = vtkSMSourceProxy::SafeDownCast(made("internal_filters", "SeamPreview"));
  vtkSMPropertyHelper(this->Preview, "Input").Set(input.GetAsProxy(), input.GetOutputPort());
  controller->PostInitializeProxy(this->Preview);
  this->Preview->UpdateVTKObjects();
  this->Display = made("representations", "GeometryRepresentation");
  vtkSMPropertyHelper(this->Display, "Input").Set(this->Preview);
  controller->PostInitializeProxy(this->Display);
  for (const char* colour : { "AmbientColor", "DiffuseColor" })
  {
    vtkSMPropertyHelper(this->Display, colour).Set(Yellow, 3);
  }
  vtkSMPropertyHelper(this->Display, "LineWidth").Set(LineWidth);
  vtkSMPropertyHelper(this->Display, "Pickable").Set(0);
  this->Display->UpdateVTKObjects();
  vtkSMPropertyHelper(this->View, "HiddenRepresentations").Add(this->Display);
  this->View->UpdateVTKObjects();
  return true;
}

void SeamPreviews::remove()
{
  if (this->Display)
  {
    SCOPED_UNDO_EXCLUDE();
    vtkSMPropertyHelper(this->View, "HiddenRepresentations").Remove(this->Display);
    this->View->UpdateVTKObjects();
    this->Display = nullptr;
    this->Preview = nullptr;
    this->View = nullptr;
  }
}
