// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the plugin's modules with ParaView, and lets Python find them from its start. The readers of
// scans and of cortex files are written in Python, and ParaView makes their proxies, in its window and
// in pvserver, before anything has imported paraview.servermanager, which is what lets Python find the
// modules of plugins otherwise.
#include "PythonTexts.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkPVPythonModule.h>
#include <vtkPythonInterpreter.h>

namespace
{

constexpr const char* Finder = R"(
import importlib.abc
import importlib.machinery
import sys

class SurfaceFlatteningFinder(importlib.abc.MetaPathFinder, importlib.abc.InspectLoader):
    def find_spec(self, name, path, target=None):
        if not name.startswith("surfaceflattening_") or not self._module(name):
            return None
        return importlib.machinery.ModuleSpec(name, self)

    def get_source(self, name):
        return self._module(name).GetSource()

    def _module(self, name):
        from paraview.modules.vtkRemotingCore import vtkPVPythonModule
        return vtkPVPythonModule.GetModule(name)

if not any(type(finder).__name__ == "SurfaceFlatteningFinder" for finder in sys.meta_path):
    sys.meta_path.append(SurfaceFlatteningFinder())
del SurfaceFlatteningFinder
)";

void addFinder(vtkObject*, unsigned long, void*, void*)
{
  vtkPythonInterpreter::RunSimpleString(Finder);
}

void registerModules()
{
  for (const auto& module : PythonTexts)
  {
    vtkNew<vtkPVPythonModule> registered;
    registered->SetFullName(module.Name);
    registered->SetSource(reinterpret_cast<const char*>(module.Text));
    vtkPVPythonModule::RegisterModule(registered);
  }
}

// Interpreters are told when Python starts. This one lives as long as the program, as Python does.
bool listenToPython()
{
  registerModules();
  static vtkPythonInterpreter* interpreter = vtkPythonInterpreter::New();
  vtkNew<vtkCallbackCommand> listener;
  listener->SetCallback(addFinder);
  interpreter->AddObserver(vtkCommand::EnterEvent, listener);
  if (vtkPythonInterpreter::IsInitialized())
  {
    addFinder(nullptr, 0, nullptr, nullptr);
  }
  return true;
}

[[maybe_unused]] const bool Listening = listenToPython();

} // namespace
