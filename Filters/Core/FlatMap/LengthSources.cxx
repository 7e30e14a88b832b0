// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/LengthSources.h"

#include <cmath>
#include <random>

namespace flattening
{

std::vector<int> drawnByArea(const Eigen::VectorXd& areas, int count)
{
  std::mt19937_64 generator(1);
  std::vector<int> drawn;
  const double share = areas.sum() / count;
  double before = 0.0; // area of the vertices before v
  int v = 0;
  for (int i = 0; i < count; ++i)
  {
    const double fraction = std::ldexp(static_cast<double>(generator() >> 11), -53);
    const double place = share * (i + fraction);
    while (v + 1 < areas.size() && before + areas[v] <= place)
    {
      before += areas[v++];
    }
    drawn.push_back(v);
  }
  return drawn;
}

SourceProgress::SourceProgress(const ProgressCallback& progress, const char* stage, std::size_t sources)
  : Progress(progress)
  , Stage(stage)
  , Sources(sources)
{
}

void SourceProgress::check()
{
  if (this->Cancelled)
  {
    throw flattening::Cancelled();
  }
  if (std::this_thread::get_id() != this->Caller)
  {
    return;
  }
  try
  {
    report(
      this->Progress, static_cast<double>(this->Done) / static_cast<double>(this->Sources), this->Stage);
  }
  catch (...)
  {
    this->Cancelled = true;
    throw;
  }
}

} // namespace flattening
