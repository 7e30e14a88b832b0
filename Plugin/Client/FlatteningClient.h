// SPDX-License-Identifier: GPL-3.0-or-later
/// The plugin's part in ParaView's window. ParaView makes one object of it when it loads the plugin.
#pragma once

#include <QObject>

class FlatteningClient : public QObject
{
public:
  void startup();
  void shutdown() {}
};
