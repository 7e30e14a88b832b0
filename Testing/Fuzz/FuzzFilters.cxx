// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the filters on random surfaces and checks what they promise; Usage below says how.
#include "Campaign/Campaign.h"

#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>

namespace
{

constexpr const char* Usage =
  "FuzzFilters [--class NAME|all] [--scenario NAME] [--first SEED] [--count N] [--minutes M]\n"
  "            [--time-limit SECONDS] [--memory MEGABYTES] [--out FOLDER] [--shrink SECONDS]\n"
  "FuzzFilters --replay FILE\n"
  "Runs N cases: the seeds SEED, SEED + 1, ... of each class in turn. A class and a seed determine a "
  "case.\n"
  "  --scenario    what is done with all surfaces, such as free-outline; drawn for each if not given\n"
  "  --minutes     ends after so many minutes, whatever N is\n"
  "  --time-limit  greatest processor time of a run of a filter, 60 by default; more is a hang\n"
  "  --memory      greatest memory of a case, 4096 by default\n"
  "  --out         folder of summary.csv and the cases that failed, fuzz-output by default\n"
  "  --shrink      time to make a failed case smaller, 60 by default\n"
  "  --replay      runs a saved case and prints what the filters say\n"
  "The exit status is 0 if no case failed, else 1.\n";

struct Arguments
{
  fuzz::CampaignOptions Options;
  std::string Replay;
};

Arguments parse(int argc, char* argv[])
{
  Arguments arguments;
  fuzz::CampaignOptions& options = arguments.Options;
  const std::map<std::string, std::function<void(const std::string&)>> setters = {
    { "--class", [&](const std::string& value) { options.SurfaceClass = value; } },
    { "--scenario", [&](const std::string& value) { options.Scenario = value; } },
    { "--first", [&](const std::string& value) { options.First = std::stoull(value); } },
    { "--count", [&](const std::string& value) { options.Count = std::stoi(value); } },
    { "--minutes", [&](const std::string& value) { options.Minutes = std::stod(value); } },
    { "--time-limit", [&](const std::string& value) { options.Limit.Seconds = std::stod(value); } },
    { "--memory", [&](const std::string& value) { options.Limit.MemoryMegabytes = std::stol(value); } },
    { "--out", [&](const std::string& value) { options.Out = value; } },
    { "--shrink", [&](const std::string& value) { options.ShrinkingSeconds = std::stod(value); } },
    { "--replay", [&](const std::string& value) { arguments.Replay = value; } }
  };
  for (int a = 1; a < argc; a += 2)
  {
    const auto setter = setters.find(argv[a]);
    if (setter == setters.end() || a + 1 == argc)
    {
      throw std::invalid_argument(std::string("unknown option or no value: ") + argv[a]);
    }
    setter->second(argv[a + 1]);
  }
  return arguments;
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    const Arguments arguments = parse(argc, argv);
    const int failed = arguments.Replay.empty()
                         ? fuzz::Campaign(arguments.Options).run()
                         : fuzz::replay(arguments.Replay, arguments.Options.Limit);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << "FuzzFilters: " << error.what() << "\n" << Usage;
    return 2;
  }
}
