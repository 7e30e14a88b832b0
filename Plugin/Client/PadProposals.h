// SPDX-License-Identifier: GPL-3.0-or-later
/// Image Pad begins with a real margin.
#pragma once

#include <QObject>

class pqPipelineSource;

/// Sets the extent of a new Image Pad to that of its input with a margin on every side, and its constant
/// to the least value of the input, which is air in a scan.
class PadProposals : public QObject
{
public:
  explicit PadProposals(QObject* parent);

private:
  void propose(pqPipelineSource* source);
};
