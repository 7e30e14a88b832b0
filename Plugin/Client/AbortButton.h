// SPDX-License-Identifier: GPL-3.0-or-later
/// ParaView's Abort button, from ParaView 6.1 on.
#pragma once

#include <QObject>
#include <QPointer>

#include <vector>

class pqPipelineSource;

/// Lets a press of Abort through to the button, and offers to apply the aborted filters again.
///
/// During work ParaView 6.1 ignores presses of the mouse except those on the button; but Qt hands a
/// press to the window first, where ParaView ignores it, so that only a double click aborts. And after
/// an abort ParaView 6.1 keeps the order to abort: the filter would do nothing from then on.
class AbortButton : public QObject
{
public:
  explicit AbortButton(QObject* parent);

private:
  void letPressesThrough();
  void rememberAborted();
  void offerApply();

  bool Working = false;
  std::vector<QPointer<pqPipelineSource>> Aborted;
};
