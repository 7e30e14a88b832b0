// SPDX-License-Identifier: GPL-3.0-or-later
/// Boost's disjoint sets with their storage. Boost's own class with storage keeps pointers, for which
/// its functions find no get() if its header of compressed graphs came first, as CGAL 6 brings it.
#pragma once

#include <boost/iterator/counting_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <numeric>
#include <vector>

namespace flattening
{

/// The numbers 0 to n - 1 in sets, each alone at first.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t n)
    : Ranks(n, 0)
    , Parents(n)
    , Sets(Map(this->Ranks.begin()), Map(this->Parents.begin()))
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }
  DisjointSets(DisjointSets&&) = default; // the maps point into the vectors, whose memory moves along
  DisjointSets(const DisjointSets&) = delete;

  /// Joins the sets of two numbers.
  void join(int x, int y) { this->Sets.union_set(x, y); }

  /// The number that stands for the set of x.
  int find(int x) { return this->Sets.find_set(x); }

  /// Makes the smallest number of each set the one that stands for it.
  void normalise()
  {
    const boost::counting_iterator<int> first(0);
    const boost::counting_iterator<int> last(static_cast<int>(this->Parents.size()));
    this->Sets.compress_sets(first, last);
    this->Sets.normalize_sets(first, last);
  }

private:
  using Numbers = std::vector<int>;
  using Map =
    boost::iterator_property_map<Numbers::iterator, boost::typed_identity_property_map<int>, int, int&>;

  Numbers Ranks;
  Numbers Parents;
  boost::disjoint_sets<Map, Map, boost::find_with_path_halving> Sets;
};

} // namespace flattening
