// SPDX-License-Identifier: GPL-3.0-or-later
/// Random numbers that are the same on every platform; the distributions of <random> are not.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <random>

namespace flattening::samples
{

class RandomNumbers
{
public:
  explicit RandomNumbers(std::uint64_t seed)
    : Engine(seed)
  {
  }

  /// A number in [low, high).
  double real(double low, double high)
  {
    return low + (high - low) * 0x1p-53 * static_cast<double>(this->Engine() >> 11);
  }

  /// A whole number in [low, high].
  int integer(int low, int high)
  {
    return low + static_cast<int>(this->Engine() % static_cast<std::uint64_t>(high - low + 1));
  }

  bool chance(double probability) { return this->real(0.0, 1.0) < probability; }

  /// A point in the cube [low, high)^3.
  Eigen::RowVector3d point(double low, double high)
  {
    const double x = this->real(low, high);
    const double y = this->real(low, high);
    return { x, y, this->real(low, high) };
  }

private:
  std::mt19937_64 Engine;
};

} // namespace flattening::samples
