// SPDX-License-Identifier: GPL-3.0-or-later
/// Before long work: what is going to be done, and how long it will take.
#pragma once

#include <QObject>

class pqOutputPort;

/// When Apply is pressed for filters of the plugin, shows the waiting cursor and, in the status bar, the
/// number of faces or voxels, the expected time and what would shorten it, before the work begins.
class ApplyNotice : public QObject
{
public:
  explicit ApplyNotice(QObject* parent);

  /// Says what Flatten and Compare is going to do with a surface or a scan.
  static void announceComparison(pqOutputPort* source);

private:
  void attach();
  void show();
  static bool announce(const QString& notice);
};
