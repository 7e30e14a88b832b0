// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/RowMatrix.h"

#include <tbb/enumerable_thread_specific.h>

#include <numeric>

namespace flattening
{

void RowSum::add(int column, double value)
{
  int& place = this->Place[column];
  if (place < 0)
  {
    place = static_cast<int>(this->Entries.size());
    this->Entries.emplace_back(column, 0.0);
  }
  this->Entries[place].second += value;
}

void RowSum::moveTo(std::vector<std::pair<int, float>>& entries)
{
  std::sort(this->Entries.begin(),
    this->Entries.end(),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [column, sum] : this->Entries)
  {
    entries.emplace_back(column, static_cast<float>(sum));
    this->Place[column] = -1;
  }
  this->Entries.clear();
}

RowMatrix matrixOfRows(int rows, int columns, const std::function<void(int, RowSum&)>& sumRow)
{
  RowMatrix result;
  result.Columns = columns;
  result.Begin.assign(rows + 1, 0);
  std::vector<std::vector<std::pair<int, float>>> parts(rows / RowsPerPart + 1);
  tbb::enumerable_thread_specific<RowSum> sums(columns);
  forRows(rows,
    [&](int begin, int end)
    {
      RowSum& sum = sums.local();
      auto& entries = parts[begin / RowsPerPart];
      for (int i = begin; i < end; ++i)
      {
        const std::size_t first = entries.size();
        sumRow(i, sum);
        sum.moveTo(entries);
        result.Begin[i + 1] = static_cast<int>(entries.size() - first);
      }
    });
  std::partial_sum(result.Begin.begin(), result.Begin.end(), result.Begin.begin());
  result.Column.resize(result.Begin.back());
  result.Value.resize(result.Begin.back());
  forRows(rows,
    [&](int begin, int)
    {
      int at = result.Begin[begin];
      for (const auto& [column, value] : parts[begin / RowsPerPart])
      {
        result.Column[at] = column;
        result.Value[at++] = value;
      }
    });
  return result;
}

RowMatrix product(const RowMatrix& a, const RowMatrix& b)
{
  return matrixOfRows(a.rows(),
    b.Columns,
    [&](int i, RowSum& sum)
    {
      for (int e = a.Begin[i]; e < a.Begin[i + 1]; ++e)
      {
        const int k = a.Column[e];
        for (int f = b.Begin[k]; f < b.Begin[k + 1]; ++f)
        {
          sum.add(b.Column[f], static_cast<double>(a.Value[e]) * b.Value[f]);
        }
      }
    });
}

RowMatrix transposed(const RowMatrix& a)
{
  RowMatrix result;
  result.Columns = a.rows();
  std::vector<int> next(a.Columns + 1, 0);
  for (const int j : a.Column)
  {
    ++next[j + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  result.Begin = next;
  result.Column.resize(a.Column.size());
  result.Value.resize(a.Column.size());
  for (int i = 0; i < a.rows(); ++i)
  {
    for (int e = a.Begin[i]; e < a.Begin[i + 1]; ++e)
    {
      const int at = next[a.Column[e]]++;
      result.Column[at] = i;
      result.Value[at] = a.Value[e];
    }
  }
  return result;
}

} // namespace flattening
