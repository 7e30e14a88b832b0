// SPDX-License-Identifier: GPL-3.0-or-later
#include "ApplyNotice.h"

#include "MainWindow.h"

#include <pqApplicationCore.h>
#include <pqOutputPort.h>
#include <pqPipelineFilter.h>
#include <pqServerManagerModel.h>

#include <vtkPVDataInformation.h>
#include <vtkSMProxy.h>

#include <QPushButton>
#include <QStatusBar>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace
{

// Seconds for each face of the input, about: those of a processor on brains of 131 thousand to 2.1
// million faces (Utilities/measurements/free_outline.py and the tables of docs/benchmarks.md). Surfaces
// with long protrusions take longer.
struct Cost
{
  const char* Filter;
  double SecondsPerFace;
};
constexpr Cost Costs[] = { { "SurfaceToDisk", 2.5e-5 },
  { "ConformalDisk", 1.0e-5 },
  { "OMTAreaPreserving", 3.0e-5 },
  { "DistortionMetrics", 2.0e-6 } };

QString duration(double seconds)
{
  return seconds < 60.0 ? QString("%1 s").arg(std::max(1.0, std::round(seconds)))
                        : QString("%1 min").arg(std::round(seconds / 6.0) / 10.0);
}

// A sentence about a filter that Apply will run; empty if it is not known.
QString noticeOf(pqPipelineFilter* filter)
{
  pqOutputPort* input = filter->getInputs().value(0);
  vtkPVDataInformation* data = input ? input->getDataInformation() : nullptr;
  for (const Cost& cost : Costs)
  {
    if (data && QString(filter->getProxy()->GetXMLName()) == cost.Filter)
    {
      const auto faces = static_cast<double>(data->GetNumberOfCells());
      const double seconds = faces * cost.SecondsPerFace;
      QString notice = QString("%1: %L2 triangles, about %3")
                         .arg(filter->getSMName())
                         .arg(static_cast<qlonglong>(faces))
                         .arg(duration(seconds));
      if (seconds > 30.0)
      {
        notice += "; Remesh of Surface To Disk with a greater edge length makes it shorter";
      }
      return notice;
    }
  }
  return {};
}

} // namespace

ApplyNotice::ApplyNotice(QObject* parent)
  : QObject(parent)
{
  QTimer::singleShot(0, this, [this] { this->attach(); });
}

void ApplyNotice::attach()
{
  QWidget* window = mainWindow();
  auto* apply = window ? window->findChild<QPushButton*>("Accept") : nullptr;
  if (apply)
  {
    connect(apply, &QAbstractButton::pressed, this, &ApplyNotice::show);
  }
}

void ApplyNotice::show()
{
  QString notice;
  for (auto* filter :
    pqApplicationCore::instance()->getServerManagerModel()->findItems<pqPipelineFilter*>())
  {
    if (filter->modifiedState() != pqProxy::UNMODIFIED && notice.isEmpty())
    {
      notice = noticeOf(filter);
    }
  }
  QMainWindow* window = mainWindow();
  if (!notice.isEmpty() && window)
  {
    window->statusBar()->showMessage(notice);
    window->statusBar()->repaint();
    QApplication::setOverrideCursor(Qt::WaitCursor);
    // Runs when the work is done, as the event loop waits for it.
    QTimer::singleShot(0, this, [] { QApplication::restoreOverrideCursor(); });
  }
}
