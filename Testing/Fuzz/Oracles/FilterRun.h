// SPDX-License-Identifier: GPL-3.0-or-later
/// Runs a filter and checks what every filter promises: no exception, one plain error for each failure,
/// an empty output exactly after an error or from an empty input, and arrays of the right lengths.
#pragma once

#include "../Findings.h"

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;

namespace fuzz
{

struct Outcome
{
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  bool HasResult = false; ///< whether output port 0 has points or cells
};

/// Updates the filter and checks its outcome. Its inputs are up to date.
Outcome runFilter(vtkAlgorithm* filter, Findings& findings);

/// Whether the data object has no points, cells or vertices.
bool hasNothing(vtkDataObject* data);

/// Makes runFilter() call a function with the name of the filter's class before each run.
void announceRuns(std::function<void(const std::string&)> announce);

/// Makes runFilter() print the time, errors and warnings of each filter.
void printRuns();

/// Keeps errors of other objects than filters from the terminal, and counts them as failures.
void catchStrayErrors();

} // namespace fuzz
