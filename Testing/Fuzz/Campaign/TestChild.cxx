// SPDX-License-Identifier: GPL-3.0-or-later
#include "Child.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

void work(double seconds)
{
  const std::clock_t end = std::clock() + static_cast<std::clock_t>(seconds * CLOCKS_PER_SEC);
  while (std::clock() < end)
  {
  }
}

// Sleeps on even if a signal interrupts it.
void sleepFor(time_t seconds)
{
  timespec left = { seconds, 0 };
  while (nanosleep(&left, &left) != 0 && errno == EINTR)
  {
  }
}

std::string endOf(const std::function<void()>& task)
{
  fuzz::Limits limits;
  limits.Seconds = 1.0;
  return fuzz::runChild([&](const fuzz::Tell&) { task(); }, limits, [](const std::string&) {});
}

TEST(Child, ThatWorksTooLongHangs)
{
  EXPECT_EQ(endOf([] { work(0.5); }), "");
  EXPECT_EQ(endOf([] { work(20.0); }), "hang");
}

TEST(Child, ThatSleepsTooLongHangs)
{
  EXPECT_EQ(endOf([] { sleepFor(60); }), "hang");
}

// As a child that other programs keep from the processor.
TEST(Child, ThatGetsNoProcessorDoesNotHang)
{
  const auto stopAndWork = []
  {
    const pid_t child = getpid();
    const pid_t helper = fork();
    if (helper == 0)
    {
      sleepFor(7);
      kill(child, SIGCONT);
      _exit(0);
    }
    raise(SIGSTOP);
    waitpid(helper, nullptr, 0);
  };
  EXPECT_EQ(endOf(stopAndWork), "");
}

TEST(Child, SaysHowItEnded)
{
  EXPECT_EQ(endOf([] { raise(SIGABRT); }), "crash-SIGABRT");
  EXPECT_EQ(endOf([] { _exit(3); }), "exit-3");
  EXPECT_EQ(endOf([] { throw std::runtime_error("no"); }), "exit-97");
}

} // namespace
