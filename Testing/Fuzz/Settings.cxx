// SPDX-License-Identifier: GPL-3.0-or-later
#include "Settings.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace fuzz
{
namespace
{

Point position(Random& random, const Extent& extent)
{
  Point point = extent.Points.empty() ? Point{ 0.0, 0.0, 0.0 } : random.pick(extent.Points);
  if (random.chance(0.3))
  {
    const double distance = extent.Size * random.logUniform(1e-6, 10.0);
    for (double& x : point)
    {
      x += distance * random.normal();
    }
  }
  return point;
}

std::vector<double> value(Random& random, const Property& property, const Extent& extent)
{
  const double low = property.Low;
  const double high = property.High;
  switch (property.Draw)
  {
    case Kind::Flag:
      return { random.chance(0.5) ? 1.0 : 0.0 };
    case Kind::Choice:
      return { static_cast<double>(random.integer(static_cast<int>(low), static_cast<int>(high))) };
    case Kind::Count:
      return { std::floor(random.logUniform(low + 1.0, high + 2.0)) - 1.0 };
    case Kind::Fraction:
      return { random.chance(0.1) ? low : random.chance(0.1) ? high : random.uniform(low, high) };
    case Kind::Magnitude:
      return { random.logUniform(low, high) };
    case Kind::Length:
      return { random.chance(0.3) ? 0.0 : extent.Size * random.logUniform(low, high) };
    case Kind::Area:
      return { random.chance(0.3) ? 0.0 : extent.Size * extent.Size * random.logUniform(low, high) };
    case Kind::Position: {
      const Point point = position(random, extent);
      return { point.begin(), point.end() };
    }
    default:
      return { random.normal(), random.normal(), random.normal() };
  }
}

bool isWhole(Kind kind)
{
  return kind == Kind::Flag || kind == Kind::Choice || kind == Kind::Count;
}

} // namespace

void apply(const Settings& settings, const std::string& filter, vtkAlgorithm* algorithm)
{
  for (const Property& property : propertiesOf(filter))
  {
    const auto found = settings.find(filter + "." + property.Name);
    if (found != settings.end())
    {
      property.Set(algorithm, found->second);
    }
  }
}

void draw(Random& random,
  const std::string& filter,
  double share,
  const Extent& extent,
  Settings& settings)
{
  for (const Property& property : propertiesOf(filter))
  {
    if (random.chance(share))
    {
      settings[filter + "." + property.Name] = value(random, property, extent);
    }
  }
}

void makeHostile(Random& random, const std::string& filter, Settings& settings)
{
  using Limits = std::numeric_limits<double>;
  static const std::vector<double> numbers = { Limits::quiet_NaN(),
    Limits::infinity(),
    -Limits::infinity(),
    Limits::max(),
    -Limits::max(),
    Limits::min(),
    Limits::denorm_min(),
    1e-300,
    1e-100,
    1e-20,
    1e20,
    1e100,
    -1.0,
    0.0 };
  static const std::vector<double> wholes = { 2147483647.0, -2147483648.0, -1.0, 0.0, 1.0, 1e9 };
  const std::vector<Property>& properties = propertiesOf(filter);
  for (int n = random.integer(1, 2); n > 0; --n)
  {
    const Property& property = random.pick(properties);
    const bool isVector = property.Draw == Kind::Position || property.Draw == Kind::Direction;
    std::vector<double>& values = settings[filter + "." + property.Name];
    values.resize(isVector ? 3 : 1);
    values[isVector ? random.integer(0, 2) : 0] =
      property.Draw == Kind::Flag ? 1.0 : random.pick(isWhole(property.Draw) ? wholes : numbers);
  }
}

std::string toText(const Settings& settings)
{
  std::string text;
  for (const auto& [name, values] : settings)
  {
    text += name;
    for (const double x : values)
    {
      char buffer[64];
      std::snprintf(buffer, sizeof(buffer), " %.17g", x);
      text += buffer;
    }
    text += '\n';
  }
  return text;
}

Settings settingsFrom(const std::string& text)
{
  Settings settings;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string name;
    words >> name;
    for (std::string word; words >> word;)
    {
      settings[name].push_back(std::strtod(word.c_str(), nullptr));
    }
  }
  return settings;
}

} // namespace fuzz
