// SPDX-License-Identifier: GPL-3.0-or-later
#include "CutDisplays.h"

#include "ViewWatcher.h"

#include <pqDataRepresentation.h>
#include <pqOutputPort.h>
#include <pqPipelineSource.h>
#include <pqRenderView.h>
#include <pqUndoStack.h>

#include <vtkDataObject.h>
#include <vtkNew.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMParaViewPipelineControllerWithRendering.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMViewProxy.h>

#include <string>

namespace
{

constexpr int CutsPort = 1;
// Pixels; thin lines are lost on a surface of a hundred thousand triangles.
constexpr double LineWidth = 4.0;
constexpr double Orange[3] = { 1.0, 0.55, 0.0 };

bool isDiskOfFilter(pqDataRepresentation* representation)
{
  pqOutputPort* port = representation ? representation->getOutputPortFromInput() : nullptr;
  return port && port->getPortNumber() == 0 &&
         std::string(port->getSource()->getProxy()->GetXMLName()) == "SurfaceToDisk";
}

void showCuts(pqPipelineSource* source, pqRenderView* view)
{
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  vtkSMProxy* lines = controller->Show(source->getSourceProxy(), CutsPort, view->getViewProxy());
  if (lines)
  {
    if (auto* display = vtkSMPVRepresentationProxy::SafeDownCast(lines))
    {
      display->SetScalarColoring(nullptr, vtkDataObject::POINT);
    }
    for (const char* colour : { "AmbientColor", "DiffuseColor" })
    {
      vtkSMPropertyHelper(lines, colour).Set(Orange, 3);
    }
    vtkSMPropertyHelper(lines, "LineWidth").Set(LineWidth);
    lines->UpdateVTKObjects();
  }
}

} // namespace

CutDisplays::CutDisplays(QObject* parent)
  : QObject(parent)
{
  new ViewWatcher(this, [this](pqRenderView* view) { this->update(view); });
}

void CutDisplays::update(pqRenderView* view)
{
  for (pqRepresentation* representation : view->getRepresentations())
  {
    auto* disk = qobject_cast<pqDataRepresentation*>(representation);
    if (isDiskOfFilter(disk))
    {
      this->follow(disk, view);
    }
  }
}

void CutDisplays::follow(pqDataRepresentation* disk, pqRenderView* view)
{
  const bool isNew = !this->Visible.contains(disk);
  const bool visible = disk->isVisible();
  if (this->Visible.value(disk, false) == visible)
  {
    return;
  }
  this->Visible[disk] = visible;
  if (isNew)
  {
    connect(disk, &QObject::destroyed, this, [this, disk] { this->Visible.remove(disk); });
  }
  SCOPED_UNDO_EXCLUDE();
  pqPipelineSource* source = disk->getOutputPortFromInput()->getSource();
  pqDataRepresentation* lines = source->getOutputPort(CutsPort)->getRepresentation(view);
  if (lines)
  {
    lines->setVisible(visible);
  }
  else if (visible)
  {
    showCuts(source, view);
  }
  view->render();
}
