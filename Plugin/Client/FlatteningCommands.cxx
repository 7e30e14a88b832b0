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

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPythonInterpreter.h>
#include <vtkSMProxyManager.h>
#include <vtkSMUndoElement.h>

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
  { "switch_colours",
    "Anatomy or Distortion",
    ":/SurfaceFlattening/icons/SwitchColours.svg",
    "Colour the maps of the layout by their area distortion in place of their anatomy, or back" },
  { "edit_cuts",
    "Edit Cuts",
    nullptr,
    "Make the cuts of the selected Surface To Disk points that can be moved" },
  { "fill_region_factors",
    "Fill Region Factors",
    nullptr,
    "Give every label a row in the table of the selected Area Weights" },
  { "scan_slices",
    "Show Scan Slices",
    nullptr,
    "Show three slices of the selected scan, or of that of the selected surface, where the patient is" },
  { "patient_axes",
    "Show Patient Axes",
    nullptr,
    "Show the letters of the patient's sides around the selected scan or surface" },
  { "flatten_cortex",
    "Flatten Cortex",
    nullptr,
    "Flatten the selected cortex: map, table of its regions, and a patch for FreeSurfer" },
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

// paraview.simple first, for it lets Python find the modules of plugins.
void runPython(const QByteArray& code)
{
  pqPVApplicationCore::instance()->pythonManager()->initializeInterpreter();
  vtkPythonInterpreter::RunSimpleString("from paraview import simple as _simple\n" + code + "\n");
}

constexpr const char* FlattenAndCompare =
  "import surfaceflattening_commands\nsurfaceflattening_commands.run('flatten_and_compare')";

/// Takes back a Flatten and Compare as a whole. ParaView's own record of all its proxies, views and
/// properties cannot be undone at once: ParaView 5.11 crashes.
class ComparisonElement : public vtkSMUndoElement
{
public:
  static ComparisonElement* New();
  vtkTypeMacro(ComparisonElement, vtkSMUndoElement);

  int Undo() override
  {
    later("import surfaceflattening_layout\nsurfaceflattening_layout.take_back()");
    return 1;
  }

  int Redo() override
  {
    later(FlattenAndCompare);
    return 1;
  }

private:
  // When ParaView is done with its undo.
  static void later(const char* code)
  {
    QTimer::singleShot(0,
      [code]
      {
        SCOPED_UNDO_EXCLUDE();
        runPython(code);
      });
  }
};
vtkStandardNewMacro(ComparisonElement);

void flattenAndCompare()
{
  {
    SCOPED_UNDO_EXCLUDE();
    runPython(FlattenAndCompare);
  }
  vtkNew<ComparisonElement> element;
  element->SetSession(vtkSMProxyManager::GetProxyManager()->GetActiveSession());
  pqScopedUndoSet undo("Flatten and Compare");
  ADD_UNDO_ELEM(element);
}

void run(const Command& command)
{
  if (QString(command.Function) == "flatten_and_compare")
  {
    flattenAndCompare();
    return;
  }
  const QString file = fileFor(command);
  if (file.isNull())
  {
    return;
  }
  pqScopedUndoSet undo(command.Text);
  runPython("import surfaceflattening_commands\nsurfaceflattening_commands.run('" +
            QByteArray(command.Function) + "', bytes.fromhex('" + file.toUtf8().toHex() + "').decode())");
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
    QAction* first = bar->actions().value(0);
    if (!bar->actions().contains(this->Actions.front()))
    {
      for (QAction* action : this->Actions)
      {
        if (!action->icon().isNull())
        {
          bar->insertAction(first, action);
        }
      }
    }
  }
}
