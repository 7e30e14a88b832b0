// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatteningCommands.h"

#include "MainWindow.h"

#include <pqFileDialog.h>
#include <pqPVApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqProxyGroupMenuManager.h>
#include <pqPythonManager.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>

#include <QAction>
#include <QIcon>
#include <QMenu>
#include <QTimer>
#include <QToolBar>

namespace
{

struct Command
{
  const char* Function;
  const char* Text;
  const char* Icon; ///< in the resources; null: the command is in the menu alone
  const char* Tip;
};

constexpr const char* Category = "Surface Flattening"; // in Menu.xml

constexpr Command Commands[] = {
  { "flatten_and_compare",
    "Flatten and Compare",
    ":/SurfaceFlattening/icons/FlattenAndCompare.svg",
    "Flatten the selected surface and show it, its maps and their distortion side by side" },
  { "edit_cuts",
    "Edit Cuts",
    nullptr,
    "Make the cuts of the selected Surface To Disk points that can be moved" },
  { "fill_region_factors",
    "Fill Region Factors",
    nullptr,
    "Give every label a row in the table of the selected Area Weights" },
  { "save_flat_map",
    "Save Flat Map...",
    nullptr,
    "Save the selected map as a file that every ParaView reads, and its tables beside it as CSV" },
};

// The argument of a command after its source; null: the user has changed their mind.
QString fileFor(const Command& command)
{
  if (QString(command.Function) != "save_flat_map")
  {
    return "";
  }
  const auto sources =
    pqApplicationCore::instance()->getServerManagerModel()->findItems<pqPipelineSource*>();
  const QString path = pqFileDialog::getSaveFileName(sources.empty() ? nullptr : sources[0]->getServer(),
    mainWindow(),
    "Save Flat Map",
    QString(),
    "VTK PolyData (*.vtp);;PLY (*.ply);;All files (*)");
  return path.isEmpty() ? QString() : path;
}

void run(const Command& command)
{
  const QString file = fileFor(command);
  if (file.isNull())
  {
    return;
  }
  pqScopedUndoSet undo(command.Text);
  pqPVApplicationCore::instance()->pythonManager()->executeCode(
    QByteArray("import surfaceflattening_commands\nsurfaceflattening_commands.run('") +
    command.Function + "', bytes.fromhex('" + file.toUtf8().toHex() + "').decode())\n");
}

} // namespace

FlatteningCommands::FlatteningCommands(QObject* parent)
  : QObject(parent)
{
  for (const Command& command : Commands)
  {
    auto* action = new QAction(command.Text, this);
    action->setObjectName(command.Function);
    action->setToolTip(command.Tip);
    action->setStatusTip(command.Tip);
    if (command.Icon)
    {
      action->setIcon(QIcon(command.Icon));
    }
    connect(action, &QAction::triggered, this, [&command] { run(command); });
    this->Actions.append(action);
  }
  // ParaView fills the menu and the toolbar anew when filters are added.
  for (auto* manager : mainWindow()->findChildren<pqProxyGroupMenuManager*>())
  {
    connect(manager,
      &pqProxyGroupMenuManager::menuPopulated,
      this,
      [this] { QTimer::singleShot(0, this, [this] { this->addToMenus(); }); });
  }
  QTimer::singleShot(0, this, [this] { this->addToMenus(); });
}

void FlatteningCommands::addToMenus()
{
  QWidget* window = mainWindow();
  for (QMenu* menu : window->findChildren<QMenu*>(Category))
  {
    if (!menu->actions().contains(this->Actions.front()))
    {
      QAction* first = menu->actions().value(0);
      menu->insertActions(first, this->Actions);
      menu->insertSeparator(first);
    }
  }
  for (QToolBar* bar : window->findChildren<QToolBar*>(Category))
  {
    if (!bar->actions().contains(this->Actions.front()))
    {
      bar->insertAction(bar->actions().value(0), this->Actions.front());
    }
  }
}
