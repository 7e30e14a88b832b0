// SPDX-License-Identifier: GPL-3.0-or-later
/// ParaView's window.
#pragma once

#include <QApplication>
#include <QMainWindow>

/// The main window; null if there is none yet.
inline QMainWindow* mainWindow()
{
  for (QWidget* widget : QApplication::topLevelWidgets())
  {
    if (auto* window = qobject_cast<QMainWindow*>(widget))
    {
      return window;
    }
  }
  return nullptr;
}
