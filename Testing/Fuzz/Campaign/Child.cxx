// SPDX-License-Identifier: GPL-3.0-or-later
#include "Child.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __SANITIZE_ADDRESS__
// The exit status of a child in which a sanitizer found a fault.
extern "C" const char* __asan_default_options()
{
  // An allocation that is too large fails, as without the sanitizer, and the filter says so.
  return "exitcode=99:detect_leaks=1:detect_odr_violation=0:allocator_may_return_null=1";
}
extern "C" const char* __ubsan_default_options()
{
  return "exitcode=99:print_stacktrace=1";
}
#endif

namespace fuzz
{
namespace
{

constexpr int SanitizerExit = 99;

void writeAll(int file, const std::string& text)
{
  std::size_t done = 0;
  while (done < text.size())
  {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written <= 0)
    {
      _exit(98); // the parent is gone
    }
    done += static_cast<std::size_t>(written);
  }
}

[[noreturn]] void beChild(const std::function<void(const Tell&)>& work,
  const Limits& limits,
  int pipeEnd)
{
  if (!limits.LogFile.empty())
  {
    const int log = open(limits.LogFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
  }
  const rlimit noCore = { 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
  if (!isSanitized()) // sanitizers reserve terabytes of addresses
  {
    const auto bytes = static_cast<rlim_t>(limits.MemoryMegabytes) << 20;
    const rlimit memory = { bytes, bytes };
    setrlimit(RLIMIT_AS, &memory);
  }
  try
  {
    work(
      [pipeEnd](std::string line)
      {
        std::replace(line.begin(), line.end(), '\n', ' ');
        writeAll(pipeEnd, line + "\n");
      });
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "uncaught exception: %s\n", error.what());
    _exit(97);
  }
  _exit(0); // without destructors of static objects, which belong to the parent
}

long residentMegabytes(pid_t child)
{
  char path[64];
  std::snprintf(path, sizeof(path), "/proc/%d/statm", static_cast<int>(child));
  long total = 0;
  long resident = 0;
  if (std::FILE* file = std::fopen(path, "r"))
  {
    if (std::fscanf(file, "%ld %ld", &total, &resident) != 2)
    {
      resident = 0;
    }
    std::fclose(file);
  }
  return resident * (sysconf(_SC_PAGESIZE) / 1024) / 1024;
}

// Processor time of a running child in seconds.
double processorSeconds(pid_t child)
{
  clockid_t clock;
  timespec time = { 0, 0 };
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &time) != 0)
  {
    return 0.0;
  }
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Passes on complete lines and keeps the rest.
void passLines(std::string& buffer, const std::function<void(const std::string&)>& hear)
{
  for (std::size_t end = buffer.find('\n'); end != std::string::npos; end = buffer.find('\n'))
  {
    hear(buffer.substr(0, end));
    buffer.erase(0, end + 1);
  }
}

// Whether all threads of a running child wait for something. A child that waits for a processor, which
// is ready to run, does not, nor does one that was stopped or waits for a disk.
bool sleeps(pid_t child)
{
  std::error_code error;
  const std::filesystem::path tasks = "/proc/" + std::to_string(child) + "/task";
  int threads = 0;
  for (const auto& task : std::filesystem::directory_iterator(tasks, error))
  {
    std::ifstream file(task.path() / "stat");
    std::string text;
    std::getline(file, text); // nothing, if the thread has ended meanwhile
    const std::size_t name = text.rfind(')'); // the state follows the name in brackets
    if (name == std::string::npos || text.compare(name, 3, ") S") != 0)
    {
      return false;
    }
    ++threads;
  }
  return threads > 0;
}

// Listens until the child closes its pipe. Kills it and returns why if it exceeds a limit.
std::string listen(pid_t child,
  int pipeEnd,
  const Limits& limits,
  const std::function<void(const std::string&)>& hear)
{
  constexpr int interval = 500; // milliseconds between two looks at the child
  double processorBefore = 0.0;
  double slept = 0.0;
  std::string buffer;
  for (;;)
  {
    pollfd wait = { pipeEnd, POLLIN, 0 };
    if (poll(&wait, 1, interval) > 0)
    {
      char bytes[4096];
      const ssize_t count = read(pipeEnd, bytes, sizeof(bytes));
      if (count <= 0)
      {
        return {};
      }
      buffer.append(bytes, static_cast<std::size_t>(count));
      passLines(buffer, hear);
      processorBefore = processorSeconds(child);
      slept = 0.0;
      continue;
    }
    slept += sleeps(child) ? 1e-3 * interval : 0.0;
    const bool hangs = processorSeconds(child) - processorBefore + slept > limits.Seconds;
    if (hangs || residentMegabytes(child) > limits.MemoryMegabytes)
    {
      kill(child, SIGKILL);
      return hangs ? "hang" : "out-of-memory";
    }
  }
}

std::string endOf(int status)
{
  if (WIFSIGNALED(status))
  {
    const char* name = sigabbrev_np(WTERMSIG(status));
    return std::string("crash-SIG") + (name ? name : "?");
  }
  const int code = WEXITSTATUS(status);
  return code == 0 ? "" : code == SanitizerExit ? "sanitizer" : "exit-" + std::to_string(code);
}

} // namespace

std::string runChild(const std::function<void(const Tell&)>& work,
  const Limits& limits,
  const std::function<void(const std::string&)>& hear)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  }
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0)
  {
    throw std::runtime_error(std::string("no child process: ") + std::strerror(errno));
  }
  if (child == 0)
  {
    close(ends[0]);
    beChild(work, limits, ends[1]);
  }
  close(ends[1]);
  const std::string reason = listen(child, ends[0], limits, hear);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return reason.empty() ? endOf(status) : reason;
}

bool isSanitized()
{
#ifdef __SANITIZE_ADDRESS__
  return true;
#else
  return false;
#endif
}

} // namespace fuzz
