// SPDX-License-Identifier: GPL-3.0-or-later
#include "RegionViews.h"

#include "ViewWatcher.h"

#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqObjectBuilder.h>
#include <pqOutputPort.h>
#include <pqPipelineFilter.h>
#include <pqRenderView.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>

#include <vtkNew.h>
#include <vtkSMParaViewPipelineControllerWithRendering.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxySelectionModel.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMViewLayoutProxy.h>
#include <vtkSMViewProxy.h>

#include <string>

namespace
{

constexpr int RegionFromSelection = 1;
constexpr int WeightsFromSelection = 3;

std::string kindOf(pqPipelineSource* source)
{
  return source->getProxy()->GetXMLName();
}

// A view beside @p view, in the same layout.
pqView* viewBeside(pqRenderView* view)
{
  vtkSMViewLayoutProxy* layout = vtkSMViewLayoutProxy::FindLayout(view->getViewProxy());
  pqView* beside = pqApplicationCore::instance()->getObjectBuilder()->createView(
    pqRenderView::renderViewType(), view->getServer());
  if (layout)
  {
    const int cell = layout->SplitHorizontal(layout->GetViewLocation(view->getViewProxy()), 0.5);
    layout->AssignView(cell + 1, beside->getViewProxy());
  }
  return beside;
}

} // namespace

RegionViews::RegionViews(QObject* parent)
  : QObject(parent)
{
  connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::sourceAdded,
    this,
    &RegionViews::beginWithSelection);
  new ViewWatcher(this, [this](pqRenderView* view) { this->update(view); });
}

void RegionViews::beginWithSelection(pqPipelineSource* source)
{
  const std::string kind = kindOf(source);
  if (kind != "FlattenRegion" && kind != "AreaWeights")
  {
    return;
  }
  vtkSMProxy* proxy = source->getProxy();
  vtkSMPropertyHelper input(proxy, "Input");
  auto* data =
    vtkSMSourceProxy::SafeDownCast(input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr);
  vtkSMSourceProxy* selection = data ? data->GetSelectionInput(input.GetOutputPort()) : nullptr;
  const bool isRegion = kind == "FlattenRegion";
  vtkSMProperty* from = proxy->GetProperty(isRegion ? "RegionFrom" : "WeightsFrom");
  if (selection && from->IsValueDefault() &&
      vtkSMPropertyHelper(proxy, "Selection").GetNumberOfElements() == 0)
  {
    vtkSMPropertyHelper(from).Set(isRegion ? RegionFromSelection : WeightsFromSelection);
    vtkSMPropertyHelper(proxy, "Selection")
      .Set(selection, data->GetSelectionInputPort(input.GetOutputPort()));
  }
}

void RegionViews::update(pqRenderView* view)
{
  for (pqRepresentation* representation : view->getRepresentations())
  {
    auto* shown = qobject_cast<pqDataRepresentation*>(representation);
    pqOutputPort* port = shown && shown->isVisible() ? shown->getOutputPortFromInput() : nullptr;
    auto* filter = port ? qobject_cast<pqPipelineFilter*>(port->getSource()) : nullptr;
    if (!filter || kindOf(filter) != "FlattenRegion" || this->Placed.contains(filter))
    {
      continue;
    }
    this->Placed.insert(filter);
    connect(filter, &QObject::destroyed, this, [this, filter] { this->Placed.remove(filter); });
    pqOutputPort* input = filter->getInputs().value(0);
    pqDataRepresentation* map = input ? input->getRepresentation(view) : nullptr;
    if (map)
    {
      SCOPED_UNDO_EXCLUDE();
      vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
      pqView* beside = viewBeside(view);
      for (int k = 0; k < filter->getNumberOfOutputPorts(); ++k)
      {
        pqDataRepresentation* part = filter->getOutputPort(k)->getRepresentation(view);
        if (part && part->isVisible())
        {
          controller->Show(filter->getSourceProxy(), k, beside->getViewProxy());
          controller->Hide(filter->getSourceProxy(), k, view->getViewProxy());
        }
      }
      map->setVisible(true);
      beside->resetDisplay();
      view->render();
      vtkSMProxySelectionModel* active =
        beside->getProxy()->GetSessionProxyManager()->GetSelectionModel("ActiveView");
      active->SetCurrentProxy(beside->getProxy(), vtkSMProxySelectionModel::CLEAR_AND_SELECT);
    }
    return;
  }
}
