// SPDX-License-Identifier: GPL-3.0-or-later
#include "Random.h"

#include <cmath>

namespace fuzz
{
namespace
{

// The hash FNV-1a, which is the same on every machine, unlike std::hash.
std::uint64_t hashOf(const std::string& name, std::uint64_t seed)
{
  std::uint64_t hash = 14695981039346656037ULL ^ (seed * 0x9e3779b97f4a7c15ULL);
  for (const char letter : name)
  {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
  }
  return hash;
}

} // namespace

Random::Random(const std::string& name, std::uint64_t seed)
  : Engine(hashOf(name, seed))
{
}

// The distributions of the standard library differ between implementations, so they are not used here.
double Random::uniform(double low, double high)
{
  return low + (high - low) * (static_cast<double>(this->Engine() >> 11) * 0x1p-53);
}

double Random::logUniform(double low, double high)
{
  return std::exp(this->uniform(std::log(low), std::log(high)));
}

double Random::normal()
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - this->uniform()));
  return radius * std::cos(6.283185307179586 * this->uniform());
}

int Random::integer(int low, int high)
{
  const auto range = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
  return static_cast<int>(low + static_cast<std::int64_t>(this->Engine() % range));
}

} // namespace fuzz
