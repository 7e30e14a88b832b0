// SPDX-License-Identifier: GPL-3.0-or-later
/// What is done with a surface. Each function runs filters on the surface of a case and checks the
/// outcome.
#pragma once

#include "../Case.h"
#include "../Oracles/FilterRun.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

namespace fuzz
{

/// Surface To Disk and Conformal Disk.
void runDisk(const Case& one, Findings& findings);
/// Surface To Disk, Conformal Disk, OMT Area Preserving, Distortion Metrics.
void runPipeline(const Case& one, Findings& findings);
/// One of the other filters, on the surface, its disk or one of its maps.
void runOtherFilter(const Case& one, Findings& findings);
const std::vector<std::string>& otherFilters();
/// The pipeline with what a user draws: seams, labels to cut off, regions of interest, weights,
/// polygons.
void runDrawnInputs(const Case& one, Findings& findings);
/// Execute, modify, abort at a random moment, another input, execute again: the results are those of new
/// filters.
void runLifecycle(const Case& one, Findings& findings);
/// Two pipelines in two threads: the results are those of one after the other.
void runThreads(const Case& one, Findings& findings);
/// A flat map with a free outline: it is one-to-one or says that it is not, and has the same bits with
/// 1, 2 and 4 threads.
void runFreeOutline(const Case& one, Findings& findings);
/// Blocks, some of them empty: the results are those of the blocks alone.
void runComposite(const Case& one, Findings& findings);
/// A source whose surface depends on the time.
void runTimeSteps(const Case& one, Findings& findings);

/// Filters one after the other, the first with no input yet.
using Chain = std::vector<vtkSmartPointer<vtkAlgorithm>>;

/// Surface To Disk and Conformal Disk with the settings of a case and, if @p isLong, the two filters
/// after them.
Chain newChain(const Case& one, bool isLong);

/// Runs Surface To Disk and Conformal Disk of a chain and checks the disk and the map.
/// @return whether there is a map to go on with
bool runToConformalMap(const Chain& chain, vtkPolyData* surface, Findings& findings);

/// Runs OMT Area Preserving of a long chain and checks the map.
/// @param polygon what the map is to fill; null for the domain of the conformal map
Outcome runAreaPreserving(const Chain& chain, Findings& findings, vtkPolyData* polygon = nullptr);

/// A new polygon, strip, vertex and line for each of the input, and a copy of all arrays.
vtkSmartPointer<vtkDataObject> copyOf(vtkDataObject* data);

/// Numbers for the choices of a scenario.
Random scenarioRandom(const Case& one);

} // namespace fuzz
