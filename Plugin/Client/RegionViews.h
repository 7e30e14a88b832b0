// SPDX-License-Identifier: GPL-3.0-or-later
/// Flatten Region and Area Weights begin with what is selected.
#pragma once

#include <QObject>
#include <QSet>

class pqPipelineSource;
class pqRenderView;

/// Sets the selection of a new Flatten Region or Area Weights to what is selected in its input, and
/// shows the first result of a Flatten Region of a flat map in a view of its own beside the map.
class RegionViews : public QObject
{
public:
  explicit RegionViews(QObject* parent);

private:
  void beginWithSelection(pqPipelineSource* source);
  void update(pqRenderView* view);

  QSet<pqPipelineSource*> Placed; ///< those whose result has been shown
};
