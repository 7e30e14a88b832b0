// SPDX-License-Identifier: GPL-3.0-or-later
// Work that cannot be interrupted, and callers that do not wait for it.
#include "Base/InterruptibleCall.h"

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace
{

using namespace flattening;

const ProgressCallback GoOn = [](double, const char*) { return true; };

// Work that waits for Open lasts until the test sets Opened.
struct Gate
{
  std::promise<void> Opened;
  std::shared_future<void> Open{ Opened.get_future() };
};

TEST(InterruptibleCall, IsOverWhenTheWorkIs)
{
  for (const ProgressCallback& progress : { ProgressCallback(), GoOn })
  {
    int done = 0;
    callInterruptibly([&done]() { done = 1; }, progress, 0.5, "work");
    EXPECT_EQ(done, 1);
  }
}

TEST(InterruptibleCall, ReportsWhileItWorksFromTheCallingThread)
{
  Gate gate;
  std::vector<double> fractions;
  callInterruptibly([open = gate.Open]() { open.wait(); },
    [&, caller = std::this_thread::get_id()](double fraction, const char* stage)
    {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      EXPECT_STREQ(stage, "work");
      fractions.push_back(fraction);
      if (fractions.size() == 3)
      {
        gate.Opened.set_value();
      }
      return true;
    },
    0.25,
    "work");
  EXPECT_GE(fractions.size(), 3u);
  EXPECT_EQ(fractions, std::vector<double>(fractions.size(), 0.25));
}

// A caller that waited for the work would wait forever, because the work ends only after the abort.
TEST(InterruptibleCall, AnAbortDoesNotWaitForTheWorkAndTheNextCallDoes)
{
  Gate gate;
  const auto wasFirst = std::make_shared<bool>(false);
  int reports = 0;
  EXPECT_THROW(callInterruptibly(
                 [open = gate.Open, wasFirst]()
                 {
                   open.wait();
                   *wasFirst = true;
                 },
                 [&reports](double, const char*) { return ++reports < 2; },
                 0.0,
                 "work"),
    Cancelled);
  // A call that is aborted while it waits for the abandoned one never starts.
  reports = 0;
  bool hasStarted = false;
  EXPECT_THROW(callInterruptibly([&hasStarted]() { hasStarted = true; },
                 [&reports](double, const char*) { return ++reports < 3; },
                 0.0,
                 "work"),
    Cancelled);
  EXPECT_FALSE(hasStarted);
  gate.Opened.set_value();
  bool sawFirst = false;
  callInterruptibly([&sawFirst, wasFirst]() { sawFirst = *wasFirst; }, GoOn, 0.0, "work");
  EXPECT_TRUE(sawFirst);
}

TEST(InterruptibleCall, ThrowsWhatTheWorkThrows)
{
  for (const ProgressCallback& progress : { ProgressCallback(), GoOn })
  {
    EXPECT_THROW(callInterruptibly([]() { throw std::out_of_range("work"); }, progress, 0.0, "work"),
      std::out_of_range);
  }
}

} // namespace
