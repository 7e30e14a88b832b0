// SPDX-License-Identifier: GPL-3.0-or-later
#include "Findings.h"

namespace fuzz
{

void Findings::fail(const std::string& kind, const std::string& detail)
{
  for (const Failure& failure : this->Failures)
  {
    if (failure.Kind == kind) // one per kind tells enough
    {
      return;
    }
  }
  this->Failures.push_back({ kind, detail });
}

void Findings::require(bool holds, const std::string& kind, const std::string& detail)
{
  if (!holds)
  {
    this->fail(kind, detail);
  }
}

} // namespace fuzz
