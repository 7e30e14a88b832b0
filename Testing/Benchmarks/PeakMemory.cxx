// SPDX-License-Identifier: GPL-3.0-or-later
#include "PeakMemory.h"

#include <fstream>
#include <string>

namespace flattening::benchmarks
{

void resetPeakMemory()
{
  std::ofstream("/proc/self/clear_refs") << "5";
}

double peakMemory()
{
  std::ifstream status("/proc/self/status");
  for (std::string name; status >> name;)
  {
    double kibibytes = 0.0;
    if (name == "VmHWM:" && status >> kibibytes)
    {
      return 1024e-9 * kibibytes;
    }
  }
  return 0.0;
}

} // namespace flattening::benchmarks
