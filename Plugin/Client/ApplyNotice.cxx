// SPDX-License-Identifier: GPL-3.0-or-later
#include "ApplyNotice.h"

#include "MainWindow.h"

#include <pqApplicationCore.h>
#include <pqOutputPort.h>
#include <pqPipelineFilter.h>
#include <pqServerManagerModel.h>

#include <vtkPVDataInformation.h>
#include <vtkSMProxy.h>
#include <vtkType.h>

#include <QPushButton>
#include <QStatusBar>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace
{

// Seconds for each face of the input, or for each voxel of a scan, about: those of a processor on brains
// of 131 thousand to 2.1 million faces (Utilities/measurements/free_outline.py and the tables of
// docs/benchmarks.md), and on scans of seven million voxels. Surfaces with long protrusions take longer.
constexpr double SecondsPerVoxel = 3.0e-7;
struct Cost
{
  const char* Filter;
  double SecondsPerCell;
};
constexpr Cost Costs[] = { { "SurfaceToDisk", 2.5e-5 },
  { "ConformalDisk", 1.0e-5 },
  { "OMTAreaPreserving", 3.0e-5 },
  { "DistortionMetrics", 2.0e-6 },
  { "VolumeToSurface", SecondsPerVoxel } };

// Seconds for each face of all filters of Flatten and Compare, the metrics twice, and of its views.
constexpr double SecondsOfComparison = 8.0e-5;

// The faces of the surface of a scan are about this many times its voxels to the power of 2/3: 7.2 for a
// brain and 7.6 for a head.
constexpr double FacesOfScan = 7.5;

// If the work is expected to take at least so many seconds, the notice says what would shorten it. A
// convention.
constexpr double LongWork = 30.0;

QString duration(double seconds)
{
  return seconds < 60.0 ? QString("%1 s").arg(std::max(1.0, std::round(seconds)))
                        : QString("%1 min").arg(std::round(seconds / 6.0) / 10.0);
}

bool isScan(vtkPVDataInformation* data)
{
  return data->GetDataSetType() == VTK_IMAGE_DATA || data->GetDataSetType() == VTK_UNIFORM_GRID;
}

QString sentence(const QString& name, vtkPVDataInformation* data, double seconds)
{
  const bool scan = isScan(data);
  const auto count = static_cast<qlonglong>(scan ? data->GetNumberOfPoints() : data->GetNumberOfCells());
  QString notice = QString("%1: %L2 %3, about %4")
                     .arg(name)
                     .arg(count)
                     .arg(scan ? "voxels" : "triangles", duration(seconds));
  if (seconds > LongWork)
  {
    notice += scan ? "; Extract Subset with a Sample Rate of 2 makes it shorter"
                   : "; Remesh of Surface To Disk with a greater edge length makes it shorter";
  }
  return notice;
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
      const vtkTypeInt64 count = isScan(data) ? data->GetNumberOfPoints() : data->GetNumberOfCells();
      return sentence(filter->getSMName(), data, static_cast<double>(count) * cost.SecondsPerCell);
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
  if (announce(notice))
  {
    QApplication::setOverrideCursor(Qt::WaitCursor);
    // Runs when the work is done, as the event loop waits for it.
    QTimer::singleShot(0, this, [] { QApplication::restoreOverrideCursor(); });
  }
}

void ApplyNotice::announceComparison(pqOutputPort* source)
{
  vtkPVDataInformation* data = source ? source->getDataInformation() : nullptr;
  if (!data || data->GetNumberOfCells() == 0)
  {
    return;
  }
  double seconds = static_cast<double>(data->GetNumberOfCells()) * SecondsOfComparison;
  if (isScan(data))
  {
    const auto voxels = static_cast<double>(data->GetNumberOfPoints());
    seconds = voxels * SecondsPerVoxel + FacesOfScan * std::pow(voxels, 2.0 / 3.0) * SecondsOfComparison;
  }
  announce(sentence("Flatten and Compare", data, seconds));
}

bool ApplyNotice::announce(const QString& notice)
{
  QMainWindow* window = mainWindow();
  if (notice.isEmpty() || !window)
  {
    return false;
  }
  window->statusBar()->showMessage(notice);
  window->statusBar()->setToolTip(notice); // stays there when the progress has taken the bar
  window->statusBar()->repaint();
  return true;
}
