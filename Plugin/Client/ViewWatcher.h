// SPDX-License-Identifier: GPL-3.0-or-later
/// Tells when what a view shows has changed.
#pragma once

#include <QObject>
#include <QPointer>

#include <functional>

class pqRenderView;

/// Calls a function for a render view after representations in it were added, shown, hidden or removed,
/// once ParaView is done with what caused it, and after its data were updated.
class ViewWatcher : public QObject
{
public:
  using Callback = std::function<void(pqRenderView*)>;

  ViewWatcher(QObject* parent, Callback callback);

private:
  void watch(pqRenderView* view);
  void callLater(const QPointer<pqRenderView>& view);

  Callback Changed;
};
