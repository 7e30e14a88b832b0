// SPDX-License-Identifier: GPL-3.0-or-later
/// Random numbers that a name and a seed determine.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace fuzz
{

class Random
{
public:
  Random(const std::string& name, std::uint64_t seed);

  double uniform(double low = 0.0, double high = 1.0);
  double logUniform(double low, double high);
  double normal();
  /// A whole number from low to high, both included.
  int integer(int low, int high);
  bool chance(double probability) { return this->uniform() < probability; }
  std::uint64_t bits() { return this->Engine(); }

  template <typename T>
  const T& pick(const std::vector<T>& choices)
  {
    return choices.at(this->integer(0, static_cast<int>(choices.size()) - 1));
  }

private:
  std::mt19937_64 Engine;
};

} // namespace fuzz
