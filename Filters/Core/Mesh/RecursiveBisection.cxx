// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/RecursiveBisection.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{

class Halving
{
public:
  Halving(const Points2& points, int largest, double angle)
    : Largest(largest)
    , Order(points.rows())
  {
    Eigen::Matrix2d axes;
    axes << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    this->Turned = points * axes;
    std::iota(this->Order.begin(), this->Order.end(), 0);
    if (points.rows() > 0)
    {
      this->halve(0, static_cast<int>(points.rows()));
      this->collect(0, static_cast<int>(points.rows()));
    }
  }

  std::vector<std::vector<int>> Parts;

private:
  void halve(int begin, int end)
  {
    if (end - begin <= this->Largest)
    {
      std::sort(this->Order.begin() + begin, this->Order.begin() + end);
      return;
    }
    Eigen::Array2d least = this->Turned.row(this->Order[begin]);
    Eigen::Array2d greatest = least;
    for (int i = begin; i < end; ++i)
    {
      least = least.min(this->Turned.row(this->Order[i]).transpose().array());
      greatest = greatest.max(this->Turned.row(this->Order[i]).transpose().array());
    }
    const Eigen::Array2d extent = greatest - least;
    const int axis = extent[1] > extent[0] ? 1 : 0;
    const int middle = middleOf(begin, end);
    std::nth_element(this->Order.begin() + begin,
      this->Order.begin() + middle,
      this->Order.begin() + end,
      [&](int a, int b)
      {
        const double first = this->Turned(a, axis);
        const double second = this->Turned(b, axis);
        return first != second ? first < second : a < b;
      });
    tbb::parallel_invoke([&] { this->halve(begin, middle); }, [&] { this->halve(middle, end); });
  }

  void collect(int begin, int end)
  {
    if (end - begin <= this->Largest)
    {
      this->Parts.emplace_back(this->Order.begin() + begin, this->Order.begin() + end);
      return;
    }
    this->collect(begin, middleOf(begin, end));
    this->collect(middleOf(begin, end), end);
  }

  static int middleOf(int begin, int end) { return begin + (end - begin) / 2; }

  int Largest;
  std::vector<int> Order;
  Points2 Turned;
};

} // namespace

std::vector<std::vector<int>> recursiveBisection(const Points2& points, int largest, double angle)
{
  return Halving(points, std::max(1, largest), angle).Parts;
}

} // namespace flattening
