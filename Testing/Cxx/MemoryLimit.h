// SPDX-License-Identifier: GPL-3.0-or-later
/// A limit on the memory of the process, for tests of what happens without enough.
#pragma once

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FLATTENING_CAN_LIMIT_MEMORY

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace flattening::testing
{

/// The address space of the process, limited to what it has and so many bytes more.
class MemoryLimit
{
public:
  explicit MemoryLimit(rlim_t more)
  {
    getrlimit(RLIMIT_AS, &this->Before);
    long pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlimit limit{ static_cast<rlim_t>(pages * sysconf(_SC_PAGESIZE)) + more,
      this->Before.rlim_max };
    setrlimit(RLIMIT_AS, &limit);
  }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &this->Before); }

private:
  rlimit Before{};
};

} // namespace flattening::testing

#endif
