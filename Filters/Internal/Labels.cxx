// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/Labels.h"

#include "Core/Base/Errors.h"

#include <vtkDataArray.h>

#include <cmath>
#include <set>
#include <sstream>

namespace flattening
{
namespace
{

constexpr double LargestLabel = 9007199254740992.0; // 2^53: a double holds all whole numbers below it

std::string notALabel(const ChosenArray& chosen, const std::string& what, vtkIdType i, double value)
{
  std::ostringstream text;
  text << what << " " << nameOf(chosen.Array) << " has ";
  if (std::isnan(value))
  {
    text << "no number at " << (chosen.OnCells ? "cell " : "point ") << i
         << ": give every point or cell a label";
  }
  else
  {
    text << "the value " << value << " at " << (chosen.OnCells ? "cell " : "point ") << i
         << ", but labels are whole numbers: choose an array of labels; if this one was interpolated, "
            "take the nearest value instead";
  }
  return text.str();
}

} // namespace

std::vector<long long> labelsOf(const ChosenArray& chosen, const std::string& what)
{
  vtkDataArray* array = chosen.Array;
  std::vector<long long> labels(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (std::trunc(value) != value || !(std::abs(value) < LargestLabel))
    {
      throw InvalidInput(notALabel(chosen, what, i, value));
    }
    labels[i] = static_cast<long long>(value);
  }
  return labels;
}

std::string listed(const std::vector<long long>& labels)
{
  constexpr std::size_t shown = 20;
  const std::set<long long> all(labels.begin(), labels.end());
  std::ostringstream text;
  std::size_t count = 0;
  for (const long long label : all)
  {
    if (++count > shown)
    {
      text << ", ... (" << all.size() << " labels)";
      break;
    }
    text << (count > 1 ? ", " : "") << label;
  }
  return text.str();
}

} // namespace flattening
