// SPDX-License-Identifier: GPL-3.0-or-later
/// Flat maps are seen from above.
#pragma once

#include <QHash>
#include <QObject>

#include <vector>

class pqRenderView;

/// Turns the camera of a view towards a flat map and sets 2D interaction when the first flat map is
/// shown in it. When no flat map is shown any more, the camera is where it was before.
class FlatMapCameras : public QObject
{
public:
  explicit FlatMapCameras(QObject* parent);

private:
  /// The values of the properties that hold a camera, in their order; none of a view that was in 2D.
  struct Camera
  {
    std::vector<int> Modes;
    std::vector<std::vector<double>> Places;
  };

  void update(pqRenderView* view);

  QHash<pqRenderView*, Camera> Before; ///< of views that show a flat map
};
