// SPDX-License-Identifier: GPL-3.0-or-later
/// Sparse matrices in single precision, multiplied in parallel with the same bits for any number of
/// threads. Eigen multiplies sparse matrices in one thread only.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace flattening
{

/// A sparse matrix by rows.
struct RowMatrix
{
  int rows() const { return static_cast<int>(this->Begin.size()) - 1; }

  int Columns = 0;
  std::vector<int> Begin{ 0 }; ///< of each row in the two arrays below, and their size
  std::vector<int> Column;     ///< ascending in each row
  std::vector<float> Value;
};

/// Number of rows that are computed together: any that takes long against the start of a task.
constexpr int RowsPerPart = 4096;

/// Calls function(begin, end) in parallel for parts of the rows, which are the same for any number of
/// threads.
template <class F>
void forRows(int count, const F& function)
{
  tbb::parallel_for(0,
    (count + RowsPerPart - 1) / RowsPerPart,
    [&](int part) { function(part * RowsPerPart, std::min(count, (part + 1) * RowsPerPart)); });
}

RowMatrix product(const RowMatrix& a, const RowMatrix& b);

RowMatrix transposed(const RowMatrix& a);

/// A row that is summed up, entry by entry.
class RowSum
{
public:
  explicit RowSum(int columns)
    : Place(columns, -1)
  {
  }
  void add(int column, double value);
  /// Appends the entries to @p entries, by columns, and begins a new row.
  void moveTo(std::vector<std::pair<int, float>>& entries);

private:
  std::vector<int> Place; // of every column in the entries; -1 without one
  std::vector<std::pair<int, double>> Entries;
};

/// The matrix whose row i is what sumRow(i, sum) adds to an empty sum.
RowMatrix matrixOfRows(int rows, int columns, const std::function<void(int, RowSum&)>& sumRow);

} // namespace flattening
