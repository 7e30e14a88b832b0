// SPDX-License-Identifier: GPL-3.0-or-later
/// What the plugin does in ParaView's window; ParaView makes one when it loads the plugin.
#pragma once

#include <QObject>

class FlatteningClient : public QObject
{
public:
  void startup();
  void shutdown() {}
};
