// SPDX-License-Identifier: GPL-3.0-or-later
/// Random settings of the filters, as text that can be read, edited and applied again.
#pragma once

#include "Random.h"
#include "Soup.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace fuzz
{

/// Values by "Filter.Property", such as "SurfaceToDisk.HolePoint".
using Settings = std::map<std::string, std::vector<double>>;

/// How random values of a property are drawn.
enum class Kind
{
  Flag,      ///< 0 or 1
  Choice,    ///< a whole number from Low to High
  Count,     ///< the same, small numbers more often
  Fraction,  ///< a number from Low to High
  Magnitude, ///< a number from Low to High, small numbers more often
  Length,    ///< Low to High times the size of the surface, or 0
  Area,      ///< Low to High times the squared size of the surface, or 0
  Position,  ///< near the surface
  Direction
};

struct Property
{
  std::string Name;
  Kind Draw;
  double Low = 0.0;
  double High = 1.0;
  std::function<void(vtkAlgorithm*, const std::vector<double>&)> Set;
};

/// The properties of a filter, such as "SurfaceToDisk".
const std::vector<Property>& propertiesOf(const std::string& filter);

/// Sets the values of @p settings that are meant for @p filter.
void apply(const Settings& settings, const std::string& filter, vtkAlgorithm* algorithm);

/// The shape that lengths and positions refer to.
struct Extent
{
  double Size = 1.0;
  std::vector<Point> Points; ///< some points of the surface
};

/// Draws values for about @p share of the properties of a filter.
void draw(Random& random,
  const std::string& filter,
  double share,
  const Extent& extent,
  Settings& settings);

/// Replaces one or two values by hostile ones: not finite, negative, huge, tiny.
void makeHostile(Random& random, const std::string& filter, Settings& settings);

std::string toText(const Settings& settings);
Settings settingsFrom(const std::string& text);

} // namespace fuzz
