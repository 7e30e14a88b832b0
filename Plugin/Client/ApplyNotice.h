// SPDX-License-Identifier: GPL-3.0-or-later
/// Before long work: what is going to be done, and how long it will take.
#pragma once

#include <QObject>

class QAbstractButton;

/// When Apply is pressed for filters of the plugin, shows the waiting cursor and, in the status bar, the
/// number of faces, the expected time and what would shorten it, before the work begins.
class ApplyNotice : public QObject
{
public:
  explicit ApplyNotice(QObject* parent);

private:
  void attach();
  void show();
};
