// SPDX-License-Identifier: GPL-3.0-or-later
/// Boxes, found by where they are.
#pragma once

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <Eigen/Geometry>

#include <cstddef>
#include <utility>
#include <vector>

namespace flattening
{

/// Numbered boxes in an R-tree. Several threads may ask it at once.
class BoxTree
{
public:
  /// Numbers the boxes from 0 on.
  explicit BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes)
    : Tree(values(boxes))
  {
  }

  void insert(const Eigen::AlignedBox3d& box, int number) { this->Tree.insert(value(box, number)); }
  /// Removes a box that has been inserted with this number.
  void remove(const Eigen::AlignedBox3d& box, int number) { this->Tree.remove(value(box, number)); }

  /// Calls visit(number) for each box that overlaps or touches this one. Returns how many there are.
  template <typename Visit>
  std::size_t query(const Eigen::AlignedBox3d& box, const Visit& visit) const
  {
    return this->Tree.query(boost::geometry::index::intersects(value(box, 0).first),
      boost::make_function_output_iterator([&visit](const Value& found) { visit(found.second); }));
  }

  /// The numbers of all boxes, in an order in which neighbours are near to each other.
  std::vector<int> nearToEachOther() const
  {
    std::vector<int> numbers;
    numbers.reserve(this->Tree.size());
    for (const Value& value : this->Tree) // leaf by leaf
    {
      numbers.push_back(value.second);
    }
    return numbers;
  }

private:
  using Corner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Value = std::pair<boost::geometry::model::box<Corner>, int>;

  static Value value(const Eigen::AlignedBox3d& box, int number)
  {
    const Eigen::Vector3d& low = box.min();
    const Eigen::Vector3d& high = box.max();
    return { { { low.x(), low.y(), low.z() }, { high.x(), high.y(), high.z() } }, number };
  }

  static std::vector<Value> values(const std::vector<Eigen::AlignedBox3d>& boxes)
  {
    std::vector<Value> values;
    values.reserve(boxes.size());
    for (const Eigen::AlignedBox3d& box : boxes)
    {
      values.push_back(value(box, static_cast<int>(values.size())));
    }
    return values;
  }

  boost::geometry::index::rtree<Value, boost::geometry::index::linear<16>> Tree; // 16 is a convention
};

} // namespace flattening
