// SPDX-License-Identifier: GPL-3.0-or-later
#include "PercentBars.h"

#include "ViewWatcher.h"

#include <pqRenderView.h>
#include <pqRepresentation.h>
#include <pqUndoStack.h>

#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <string>

namespace
{

constexpr const char* Array = "AreaDistortion"; // as ParaView titles the bar
constexpr const char* Title = "AreaDistortion (surface to map, in percent)";

} // namespace

PercentBars::PercentBars(QObject* parent)
  : QObject(parent)
{
  new ViewWatcher(this, [this](pqRenderView* view) { this->update(view); });
}

void PercentBars::update(pqRenderView* view)
{
  for (pqRepresentation* representation : view->getRepresentations())
  {
    vtkSMProxy* proxy = representation->getProxy();
    if (std::string(proxy->GetXMLName()) == "ScalarBarWidgetRepresentation" &&
        std::string(vtkSMPropertyHelper(proxy, "Title").GetAsString()) == Array)
    {
      SCOPED_UNDO_EXCLUDE();
      vtkSMPropertyHelper(proxy, "Title").Set(Title);
      vtkSMPropertyHelper(proxy, "DrawTickLabels").Set(0);
      vtkSMPropertyHelper(proxy, "AddRangeLabels").Set(0);
      proxy->UpdateVTKObjects();
      view->render();
    }
  }
}
