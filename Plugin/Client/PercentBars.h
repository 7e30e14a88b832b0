// SPDX-License-Identifier: GPL-3.0-or-later
/// The scalar bar of AreaDistortion is in percent.
#pragma once

#include <QObject>

class pqRenderView;

/// Titles the scalar bar of AreaDistortion in percent and leaves its logarithms away: the annotations of
/// its colour map are percent.
class PercentBars : public QObject
{
public:
  explicit PercentBars(QObject* parent);

private:
  void update(pqRenderView* view);
};
