// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewWatcher.h"

#include <pqApplicationCore.h>
#include <pqRenderView.h>
#include <pqRepresentation.h>
#include <pqServerManagerModel.h>

#include <QTimer>

#include <utility>

ViewWatcher::ViewWatcher(QObject* parent, Callback callback)
  : QObject(parent)
  , Changed(std::move(callback))
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  for (pqRenderView* view : model->findItems<pqRenderView*>())
  {
    this->watch(view);
  }
  connect(model,
    &pqServerManagerModel::viewAdded,
    this,
    [this](pqView* view)
    {
      if (auto* rendered = qobject_cast<pqRenderView*>(view))
      {
        this->watch(rendered);
      }
    });
}

void ViewWatcher::watch(pqRenderView* view)
{
  const auto later = [this, watched = QPointer<pqRenderView>(view)] { this->callLater(watched); };
  connect(view, &pqView::representationAdded, this, later);
  connect(view, &pqView::representationRemoved, this, later);
  connect(view, &pqView::representationVisibilityChanged, this, later);
  connect(view, &pqView::updateDataEvent, this, later);
}

void ViewWatcher::callLater(const QPointer<pqRenderView>& view)
{
  QTimer::singleShot(0,
    this,
    [this, view]
    {
      if (view)
      {
        this->Changed(view);
      }
    });
}
