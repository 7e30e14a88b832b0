// SPDX-License-Identifier: GPL-3.0-or-later
/// The order in which remeshing changes edges: by length, as far as that matters.
#pragma once

#include "Remeshing/MeshOnSurface.h"

#include <algorithm>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace flattening
{

/// Edges by their lengths. Edges of nearly the same length are in the same band and come in the order of
/// memory, which is faster than jumping all over the surface. A band is sorted when its turn comes,
/// which is faster than one heap of all edges.
/// @tparam Order  std::less<> for the shortest first, std::greater<> for the longest first
template <typename Order>
class EdgeQueue
{
public:
  struct Entry
  {
    double Length; ///< of the edge when it was added
    int Band;
    MeshOnSurface::Edge Edge;
  };

  /// @param bandWidth  a length: edges whose lengths differ by less may be in the same band
  explicit EdgeQueue(double bandWidth)
    : BandWidth(bandWidth)
  {
  }

  bool empty() const { return this->size() == 0; }
  std::size_t size() const { return this->Size; }

  /// Adds an edge. One that is there already comes once more. The edges that come back all have the
  /// first of their half-edges in front, so that what becomes of one does not depend on who added it.
  void push(MeshOnSurface::Edge edge, double length)
  {
    constexpr double LastBand = 1e6;
    const int band = static_cast<int>(std::min(length / this->BandWidth, LastBand));
    const Entry entry{ length, band, MeshOnSurface::Edge(edge.idx()) };
    ++this->Size;
    if (this->HasBegun && !Order()(this->Band, entry.Band))
    {
      this->Overdue.push(entry);
    }
    else
    {
      this->Later[entry.Band].push_back(entry);
    }
  }

  /// Removes the first edge of a queue that is not empty.
  Entry pop()
  {
    if (this->Overdue.empty() && this->Present.empty())
    {
      this->beginNextBand();
    }
    --this->Size;
    if (!this->Overdue.empty() &&
        (this->Present.empty() || !ComesAfter()(this->Overdue.top(), this->Present.back())))
    {
      const Entry first = this->Overdue.top();
      this->Overdue.pop();
      return first;
    }
    const Entry first = this->Present.back();
    this->Present.pop_back();
    return first;
  }

private:
  struct ComesAfter
  {
    bool operator()(const Entry& a, const Entry& b) const
    {
      return a.Band != b.Band ? Order()(b.Band, a.Band) : b.Edge < a.Edge;
    }
  };

  void beginNextBand()
  {
    const auto next = this->Later.begin();
    this->HasBegun = true;
    this->Band = next->first;
    this->Present = std::move(next->second);
    this->Later.erase(next);
    std::sort(this->Present.begin(), this->Present.end(), ComesAfter());
  }

  double BandWidth;
  std::size_t Size = 0;
  bool HasBegun = false;
  int Band = 0;                                   // the one whose turn it is
  std::vector<Entry> Present;                     // of this band, the last one first
  std::map<int, std::vector<Entry>, Order> Later; // of the bands after it, in any order
  std::priority_queue<Entry, std::vector<Entry>, ComesAfter> Overdue; // added when their turn had come
};

} // namespace flattening
