// SPDX-License-Identifier: GPL-3.0-or-later
/// The commands of the plugin, in its menu and its toolbar.
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QToolBar;

/// Puts the commands, which are functions of the module surfaceflattening_commands, before the filters
/// in the menu Filters > Surface Flattening and in the toolbar of this name. A command is undone in one
/// step.
class FlatteningCommands : public QObject
{
public:
  explicit FlatteningCommands(QObject* parent);

private:
  void addToMenus();
  void addToBar(QToolBar* bar);

  QList<QAction*> Actions;
};
