// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatteningCommands.h"

#include "ApplyNotice.h"
#include "MainWindow.h"

#include <pqFileDialog.h>
#include <pqOutputPort.h>
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
#include <vtkSMProxySelectionModel.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMUndoElement.h>

#include <QAction>
#include <QApplication>
#include <QIcon>
#include <QMenu>
#include <QStyle>
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
    "Flatten the selected surface or scan and show it, its maps and their distortion side by side" },
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
  { "show_seams",
    "Show Seams",
    nullptr,
    "Show the seams of the selected surface or flat map, in the same colours on both banks" },
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

// The file goes to Python in hexadecimal digits, as it may have any characters.
QByteArray codeFor(const QByteArray& command, const QString& file = QString())
{
  return "import surfaceflattening_commands\nsurfaceflattening_commands.run('" + command +
         "', bytes.fromhex('" + file.toUtf8().toHex() + "').decode())";
}

// Not as steps that ParaView's Undo takes back one by one.
void runUnrecorded(const QByteArray& code)
{
  SCOPED_UNDO_EXCLUDE();
  runPython(code);
}

/// Takes back a Flatten and Compare as a whole, and does it again. ParaView's own record of all its
/// proxies, views and properties cannot be undone at once: ParaView 5.11 crashes.
class ComparisonElement : public vtkSMUndoElement
{
public:
  static ComparisonElement* New();
  vtkTypeMacro(ComparisonElement, vtkSMUndoElement);

  int Undo() override
  {
    if (!this->IsTakenBack)
    {
      later(
        []
        {
          runUnrecorded(codeFor("take_back"));
          later([] { record(true); });
        });
    }
    this->IsTakenBack = true;
    return 1;
  }

  int Redo() override
  {
    this->IsTakenBack = false;
    later([] { runUnrecorded(codeFor("do_again")); });
    return 1;
  }

  /// Puts a Flatten and Compare that was just done on ParaView's list of steps. ParaView forgets this
  /// list when it closes a view, as taking a step back does, so that a step @p takenBack is put there
  /// anew.
  static void record(bool takenBack)
  {
    vtkNew<ComparisonElement> element;
    element->SetSession(vtkSMProxyManager::GetProxyManager()->GetActiveSession());
    element->IsTakenBack = takenBack;
    {
      pqScopedUndoSet undo("Flatten and Compare");
      ADD_UNDO_ELEM(element);
    }
    pqUndoStack* steps = pqApplicationCore::instance()->getUndoStack();
    if (takenBack && steps)
    {
      steps->undo(); // does nothing but to make it a step that can be done again
    }
  }

private:
  // When ParaView is done with its undo.
  template <typename Action>
  static void later(Action action)
  {
    QTimer::singleShot(0, action);
  }

  bool IsTakenBack = false;
};
vtkStandardNewMacro(ComparisonElement);

// The output that is selected in the pipeline browser; null if none or several are selected.
pqOutputPort* activePort()
{
  vtkSMProxySelectionModel* active =
    vtkSMProxyManager::GetProxyManager()->GetActiveSessionProxyManager()->GetSelectionModel(
      "ActiveSources");
  vtkSMProxy* current = active ? active->GetCurrentProxy() : nullptr;
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  if (auto* port = model->findItem<pqOutputPort*>(current))
  {
    return port;
  }
  auto* source = model->findItem<pqPipelineSource*>(current);
  return source ? source->getOutputPort(0) : nullptr;
}

int sourceCount()
{
  return pqApplicationCore::instance()->getServerManagerModel()->findItems<pqPipelineSource*>().size();
}

void flattenAndCompare()
{
  const int before = sourceCount();
  ApplyNotice::announceComparison(activePort());
  QApplication::setOverrideCursor(Qt::WaitCursor);
  runUnrecorded(codeFor("flatten_and_compare"));
  QApplication::restoreOverrideCursor();
  if (sourceCount() > before) // after an error nothing is left to be taken back
  {
    ComparisonElement::record(false);
  }
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
  runPython(codeFor(command.Function, file));
}

} // namespace

namespace
{

// The measures of a selection follow it as long as there are views.
void stopMeasures()
{
  if (vtkPythonInterpreter::IsInitialized())
  {
    vtkPythonInterpreter::RunSimpleString("import sys\n"
                                          "_selection = sys.modules.get('surfaceflattening_selection')\n"
                                          "_selection and _selection.stop()\n");
  }
}

// ParaView calls the toolbar as the category is called; later versions put the group of proxies before
// it, "filters.Surface Flattening".
bool isOurs(const QToolBar& bar)
{
  return bar.objectName().section('.', -1) == Category;
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
  connect(QCoreApplication::instance(), &QCoreApplication::aboutToQuit, this, &stopMeasures);
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
  for (QToolBar* bar : window->findChildren<QToolBar*>())
  {
    if (isOurs(*bar) && !bar->actions().contains(this->Actions.front()))
    {
      this->addToBar(bar);
    }
  }
}

void FlatteningCommands::addToBar(QToolBar* bar)
{
  QAction* next = bar->actions().value(0);
  for (QAction* action : this->Actions)
  {
    if (!action->icon().isNull())
    {
      bar->insertAction(next, action);
      bar->widgetForAction(action)->setObjectName(action->objectName());
    }
  }
  // Qt shrinks a toolbar that is too wide for the window to its least width and hides the buttons that
  // have no room. The least width set here has room for the handle, the extension button, and the first
  // button with its margins.
  QWidget* first = bar->widgetForAction(this->Actions.front());
  QStyle* style = bar->style();
  bar->setMinimumWidth(style->pixelMetric(QStyle::PM_ToolBarHandleExtent) +
                       style->pixelMetric(QStyle::PM_ToolBarExtensionExtent) +
                       2 * first->sizeHint().width());
}
