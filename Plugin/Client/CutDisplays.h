// SPDX-License-Identifier: GPL-3.0-or-later
/// The cuts of Surface To Disk are drawn on its disk.
#pragma once

#include <QHash>
#include <QObject>
#include <QPair>

class pqDataRepresentation;
class pqRenderView;

/// Shows the second output of Surface To Disk, the seams, borders and outlines of caps, as thick lines
/// when the disk is shown for the first time in a view, and hides and shows it with the disk.
class CutDisplays : public QObject
{
public:
  explicit CutDisplays(QObject* parent);

private:
  void update(pqRenderView* view);
  void follow(pqDataRepresentation* disk, pqRenderView* view);

  QHash<pqDataRepresentation*, bool> Visible; ///< whether each disk was visible when it was seen last
};
