// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/InterruptibleCall.h"

#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace flattening
{
namespace
{

// A convention: users take a tenth of a second for at once, and ten reports a second cost nothing.
constexpr std::chrono::milliseconds ReportInterval(100);

// The call, if any, that an abort has left behind.
class AbandonedCall
{
public:
  ~AbandonedCall() { this->join(); }

  void take(std::thread thread, std::future<void> end)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->join(); // a filter that was aborted at the same time may have left one behind, too
    this->Thread = std::move(thread);
    this->End = std::move(end);
  }

  bool isOver()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->End.valid() && this->End.wait_for(ReportInterval) == std::future_status::timeout)
    {
      return false;
    }
    this->join();
    return true;
  }

private:
  void join()
  {
    if (this->Thread.joinable())
    {
      this->Thread.join();
      this->End = {};
    }
  }

  std::mutex Mutex;
  std::thread Thread;
  std::future<void> End;
};

AbandonedCall& abandonedCall()
{
  static AbandonedCall call;
  return call;
}

} // namespace

void callInterruptibly(std::function<void()> work,
  const ProgressCallback& progress,
  double fraction,
  const char* stage)
{
  if (!progress)
  {
    work();
    return;
  }
  report(progress, fraction, stage);
  while (!abandonedCall().isOver())
  {
    report(progress, fraction, stage);
  }
  std::packaged_task<void()> task(std::move(work));
  std::future<void> end = task.get_future();
  std::thread thread(std::move(task));
  try
  {
    while (end.wait_for(ReportInterval) == std::future_status::timeout)
    {
      report(progress, fraction, stage);
    }
  }
  catch (...)
  {
    abandonedCall().take(std::move(thread), std::move(end));
    throw;
  }
  thread.join();
  end.get();
}

} // namespace flattening
