// SPDX-License-Identifier: GPL-3.0-or-later
/// An interruptible call that still runs after its abort.
#pragma once

#include "Base/InterruptibleCall.h"

#include <future>
#include <utility>

namespace flattening::samples
{

/// A call that runs on after its abort until end() or the destructor lets it end. Until then the next
/// interruptible call waits for it and reports meanwhile, so that a test can count on reports.
class AbandonedCall
{
public:
  AbandonedCall()
  {
    bool isFirst = true;
    try
    {
      callInterruptibly([ended = this->Ended.get_future().share()]() { ended.wait(); },
        [&isFirst](double, const char*) { return std::exchange(isFirst, false); },
        0.0,
        "abandoned");
    }
    catch (const Cancelled&)
    {
    }
  }
  ~AbandonedCall() { this->end(); }
  AbandonedCall(const AbandonedCall&) = delete;
  AbandonedCall& operator=(const AbandonedCall&) = delete;

  void end()
  {
    if (!std::exchange(this->IsOver, true))
    {
      this->Ended.set_value();
    }
  }
  bool isOver() const { return this->IsOver; }

private:
  std::promise<void> Ended;
  bool IsOver = false;
};

} // namespace flattening::samples
