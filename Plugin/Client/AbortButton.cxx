// SPDX-License-Identifier: GPL-3.0-or-later
#include "AbortButton.h"

#include "MainWindow.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqProgressManager.h>
#include <pqServerManagerModel.h>

#include <vtkAlgorithm.h>
#include <vtkSMProxy.h>

#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <QWindow>

namespace
{

// Between two looks for the window, or for the end of the work. A convention.
constexpr int PauseMilliseconds = 50;

vtkAlgorithm* algorithmOf(pqPipelineSource* source)
{
  return vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject());
}

} // namespace

AbortButton::AbortButton(QObject* parent)
  : QObject(parent)
{
  auto* button = mainWindow()->findChild<QToolButton*>("AbortButton");
  if (!button)
  {
    return;
  }
  this->letPressesThrough();
  pqProgressManager* progress = pqApplicationCore::instance()->getProgressManager();
  connect(progress,
    &pqProgressManager::enableProgress,
    this,
    [this](bool working) { this->Working = working; });
  connect(button, &QToolButton::pressed, this, &AbortButton::rememberAborted);
}

void AbortButton::letPressesThrough()
{
  if (QWindow* window = mainWindow()->windowHandle())
  {
    pqApplicationCore::instance()->getProgressManager()->addNonBlockableObject(window);
  }
  else // it is not shown yet
  {
    QTimer::singleShot(PauseMilliseconds, this, &AbortButton::letPressesThrough);
  }
}

void AbortButton::rememberAborted()
{
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  for (pqPipelineSource* source : model->findItems<pqPipelineSource*>())
  {
    vtkAlgorithm* algorithm = algorithmOf(source);
    if (algorithm && algorithm->GetAbortExecute())
    {
      this->Aborted.emplace_back(source);
    }
  }
  this->offerApply();
}

void AbortButton::offerApply()
{
  if (this->Working)
  {
    QTimer::singleShot(PauseMilliseconds, this, &AbortButton::offerApply);
    return;
  }
  for (const QPointer<pqPipelineSource>& source : this->Aborted)
  {
    if (source)
    {
      algorithmOf(source)->SetAbortExecute(0);
      source->getProxy()->MarkModified(source->getProxy());
      source->setModifiedState(pqProxy::MODIFIED);
      mainWindow()->statusBar()->showMessage(
        QString("%1 was aborted. Apply runs it again.").arg(source->getSMName()));
    }
  }
  this->Aborted.clear();
}
