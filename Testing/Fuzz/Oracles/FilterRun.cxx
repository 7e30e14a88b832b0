// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilterRun.h"

#include "Messages.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <cstdio>
#include <ctime>
#include <mutex>
#include <utility>

namespace fuzz
{
namespace
{

bool IsVerbose = false;
std::function<void(const std::string&)> Announce;
std::mutex StrayMutex;
std::vector<std::string> StrayErrors;

class QuietWindow : public vtkOutputWindow
{
public:
  static QuietWindow* New();
  vtkTypeMacro(QuietWindow, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    const std::lock_guard<std::mutex> lock(StrayMutex);
    StrayErrors.emplace_back(text);
  }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(QuietWindow);

// Listens to a filter as long as it lives.
class Watch
{
public:
  explicit Watch(vtkAlgorithm* filter)
    : Filter(filter)
  {
    this->Tags[0] = filter->AddObserver(vtkCommand::ErrorEvent, this, &Watch::recordError);
    this->Tags[1] = filter->AddObserver(vtkCommand::WarningEvent, this, &Watch::recordWarning);
    // The executive repeats the failure of its filter.
    this->Tags[2] = filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &Watch::ignore);
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch()
  {
    this->Filter->RemoveObserver(this->Tags[0]);
    this->Filter->RemoveObserver(this->Tags[1]);
    this->Filter->GetExecutive()->RemoveObserver(this->Tags[2]);
  }

  Outcome Result;

private:
  void recordError(vtkObject*, unsigned long, void* text)
  {
    this->Result.Errors.push_back(messageOf(static_cast<const char*>(text)));
  }
  void recordWarning(vtkObject*, unsigned long, void* text)
  {
    this->Result.Warnings.push_back(messageOf(static_cast<const char*>(text)));
  }
  void ignore(vtkObject*, unsigned long, void*) {}

  vtkAlgorithm* Filter;
  unsigned long Tags[3];
};

bool hasInputs(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    const bool optional =
      filter->GetInputPortInformation(port)->Get(vtkAlgorithm::INPUT_IS_OPTIONAL()) != 0;
    const bool connected = filter->GetNumberOfInputConnections(port) > 0;
    if (!optional && (!connected || hasNothing(filter->GetInputDataObject(port, 0))))
    {
      return false;
    }
  }
  return true;
}

void checkMessages(const std::string& name,
  const std::vector<std::string>& messages,
  std::size_t greatestLength,
  Findings& findings)
{
  for (const std::string& message : messages)
  {
    const std::string fault = faultOf(message, greatestLength);
    findings.require(fault.empty(), "message", name + ": the message \"" + message + "\" " + fault);
    findings.require(
      message.find("out of memory") == std::string::npos, "out-of-memory", name + ": " + message);
    findings.require(
      name != "vtkSurfaceToDiskFilter" || message.find("run Surface To Disk") == std::string::npos,
      "message",
      name + " names itself as the remedy: " + message);
  }
}

void checkArrays(const std::string& name, vtkDataObject* output, Findings& findings)
{
  for (int kind : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* data = output->GetAttributes(kind);
    for (int a = 0; data && a < data->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = data->GetAbstractArray(a);
      findings.require(array->GetNumberOfTuples() == output->GetNumberOfElements(kind),
        "array-length",
        name + ": the array " + (array->GetName() ? array->GetName() : "without a name") + " has " +
          std::to_string(array->GetNumberOfTuples()) + " tuples");
    }
  }
}

void checkStrayErrors(const std::string& name, Findings& findings)
{
  const std::lock_guard<std::mutex> lock(StrayMutex);
  if (!StrayErrors.empty())
  {
    findings.fail("stray-error", name + ": " + StrayErrors.front());
    StrayErrors.clear();
  }
}

void print(vtkAlgorithm* filter, const Outcome& outcome, double seconds)
{
  vtkDataObject* output = filter->GetOutputDataObject(0);
  std::printf("%s: %.3f s, %lld points, %lld cells\n",
    filter->GetClassName(),
    seconds,
    static_cast<long long>(output->GetNumberOfElements(vtkDataObject::POINT)),
    static_cast<long long>(output->GetNumberOfElements(vtkDataObject::CELL)));
  for (const std::string& message : outcome.Errors)
  {
    std::printf("  error: %s\n", message.c_str());
  }
  for (const std::string& message : outcome.Warnings)
  {
    std::printf("  warning: %s\n", message.c_str());
  }
  std::fflush(stdout);
}

} // namespace

bool hasNothing(vtkDataObject* data)
{
  if (!data)
  {
    return true;
  }
  for (int kind :
    { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::VERTEX, vtkDataObject::ROW })
  {
    if (data->GetNumberOfElements(kind) > 0)
    {
      return false;
    }
  }
  return true;
}

void announceRuns(std::function<void(const std::string&)> announce)
{
  Announce = std::move(announce);
}

void printRuns()
{
  IsVerbose = true;
}

Outcome runFilter(vtkAlgorithm* filter, Findings& findings)
{
  if (Announce)
  {
    Announce(filter->GetClassName());
  }
  const std::clock_t start = std::clock();
  const std::string name = filter->GetClassName();
  Watch watch(filter);
  Outcome& outcome = watch.Result;
  try
  {
    filter->Update();
  }
  catch (const std::exception& error)
  {
    findings.fail("exception", name + ": " + error.what());
    return outcome;
  }
  if (IsVerbose)
  {
    print(filter, outcome, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  checkStrayErrors(name, findings);
  outcome.HasResult = !hasNothing(filter->GetOutputDataObject(0));
  findings.Errors += static_cast<int>(outcome.Errors.size());
  const std::string first = outcome.Errors.empty() ? "" : outcome.Errors.front();
  findings.require(outcome.Errors.size() < 2, "several-errors", name + ": " + first);
  if (!hasInputs(filter))
  {
    findings.require(outcome.Errors.empty(), "error-on-empty", name + ": " + first);
    findings.require(!outcome.HasResult, "result-of-empty", name);
  }
  else
  {
    findings.require(outcome.HasResult || !outcome.Errors.empty(), "silent-failure", name);
    findings.require(
      !outcome.HasResult || outcome.Errors.empty(), "error-with-result", name + ": " + first);
  }
  checkMessages(name, outcome.Errors, 300, findings);
  checkMessages(name, outcome.Warnings, 500, findings);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    checkArrays(name, filter->GetOutputDataObject(port), findings);
  }
  return outcome;
}

void catchStrayErrors()
{
  const auto window = vtkSmartPointer<QuietWindow>::New();
  vtkOutputWindow::SetInstance(window);
}

} // namespace fuzz
