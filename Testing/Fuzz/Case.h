// SPDX-License-Identifier: GPL-3.0-or-later
/// A case of a campaign: a surface, a scenario that uses it, and settings. It follows from the class of
/// the surface and a seed, or is read from a file.
#pragma once

#include "Findings.h"
#include "Settings.h"

#include <vtkSmartPointer.h>

#include <cstdint>
#include <string>

class vtkPolyData;

namespace fuzz
{

struct Case
{
  std::string SurfaceClass;
  std::uint64_t Seed = 0;
  std::string Scenario;
  Settings Values;
  vtkSmartPointer<vtkPolyData> Surface;
};

/// Draws a case; without a name of a scenario, that is drawn, too.
Case makeCase(const std::string& surfaceClass,
  std::uint64_t seed,
  const std::string& scenario = std::string());

/// Runs the scenario of the case.
Findings runCase(const Case& one);

/// Writes the surface as .vtp file, with the rest of the case in its field data.
void saveCase(const Case& one, const std::string& path);
Case loadCase(const std::string& path);

} // namespace fuzz
