// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/RefinementPatches.h"

#include "Areas/RefinementDescent.h"
#include "Base/EigenVersions.h"
#include "Mesh/PlaneVectors.h"
#include "Mesh/RecursiveBisection.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>

namespace flattening
{
namespace
{

// The angle between the dividing lines of one pass and the next, in radians. A convention: an irrational
// share of a turn, so that lines never return.
constexpr double Turn = 1.0;
// A patch with at most this share of faces that are not right is skipped: 4 faces of 4000.
constexpr double EnoughPatchShare = 0.001;
// A round that lowers the energy of a patch by a smaller share is its last one in the pass.
constexpr double LeastPatchGain = 0.1;

} // namespace

class RefinementPatches::Patch
{
public:
  // @p partOf holds the part of each vertex.
  Patch(const RefinementPatches& whole,
    const Pass& pass,
    const std::vector<int>& part,
    const std::vector<int>& partOf)
    : Whole(whole)
    , ThePass(pass)
  {
    for (const int v : part)
    {
      if (whole.moves(v, partOf))
      {
        this->Vertices.push_back(v);
        const VertexFaces::Range around = whole.FacesOf[v];
        this->Rows.insert(this->Rows.end(), around.begin(), around.end());
      }
    }
    this->Free = this->Vertices.size();
    std::sort(this->Rows.begin(), this->Rows.end());
    this->Rows.erase(std::unique(this->Rows.begin(), this->Rows.end()), this->Rows.end());
  }

  // Returns whether the patch needed it.
  bool refine(const DomainMap& before, DomainMap& after)
  {
    if (this->Free == 0 || (this->ThePass.Moving.empty() && this->offShare(before) <= EnoughPatchShare))
    {
      return false;
    }
    std::vector<int>& localOf = this->Whole.LocalOf.local();
    localOf.resize(before.Positions.rows(), -1);
    this->addBorder(localOf);
    const std::vector<int> members = this->boundaryMembers();
    std::vector<int> localMembers;
    for (const int member : members)
    {
      localMembers.push_back(localOf[this->Whole.Dofs.loop()[member]]);
    }
    const RefinementTerms terms = this->terms(members, localOf);
    for (const int v : this->Vertices)
    {
      localOf[v] = -1;
    }
    DomainMap map{ before.Positions(this->Vertices, flattening::all),
      before.BoundaryParameters(members) };
    this->descend(map, terms, localMembers);
    for (std::size_t i = 0; i < this->Free; ++i)
    {
      after.Positions.row(this->Vertices[i]) = map.Positions.row(i);
    }
    for (std::size_t k = 0; k < members.size(); ++k)
    {
      if (localMembers[k] < static_cast<int>(this->Free))
      {
        after.BoundaryParameters[members[k]] = map.BoundaryParameters[k];
      }
    }
    return true;
  }

private:
  void descend(DomainMap& map, const RefinementTerms& terms, const std::vector<int>& localMembers) const
  {
    std::vector<char> stays(this->Vertices.size(), 0);
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      stays[i] = i >= this->Free || this->Whole.Dofs.countOf(this->Vertices[i]) == 0;
    }
    const DegreesOfFreedom dofs(this->Whole.Dofs.sharedDomain(), localMembers, stays);
    const VertexFaces facesOf(terms.Faces, static_cast<int>(this->Vertices.size()));
    RefinementEnergy energy(terms, facesOf, dofs);
    energy.setTargets(this->ThePass.Targets(this->Rows),
      this->ThePass.AreaWeights(this->Rows),
      this->ThePass.Counts(this->Rows));
    energy.setEpsilon(this->ThePass.Epsilon);
    RefinementDescent descent(energy, dofs, terms, SparseCholesky::Kernel::Entries);
    descent.keepOrientation(this->ThePass.KeepsOrientation);
    for (int round = 0; round < this->ThePass.MostRounds; ++round)
    {
      const double gain = descent.round(map);
      const Eigen::Index off = ((energy.areaRatios(map).array() - 1.0).abs() > AreaTolerance).count();
      if (off == 0 || gain < LeastPatchGain)
      {
        break;
      }
    }
  }

  double offShare(const DomainMap& map) const
  {
    int off = 0;
    for (const int f : this->Rows)
    {
      const Eigen::Vector2d a = map.Positions.row(this->Whole.Terms.Faces(f, 0));
      const Eigen::Vector2d b = map.Positions.row(this->Whole.Terms.Faces(f, 1));
      const Eigen::Vector2d c = map.Positions.row(this->Whole.Terms.Faces(f, 2));
      const double area = 0.5 * cross(b - a, c - a);
      off += std::abs(area / this->ThePass.Targets[f] - 1.0) > AreaTolerance ? 1 : 0;
    }
    return static_cast<double>(off) / static_cast<double>(this->Rows.size());
  }

  // Adds the vertices that stay after those that move, each in ascending order. Sets the number of each
  // vertex in the patch; all others have -1.
  void addBorder(std::vector<int>& localOf)
  {
    for (std::size_t i = 0; i < this->Free; ++i)
    {
      localOf[this->Vertices[i]] = static_cast<int>(i);
    }
    for (const int f : this->Rows)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int v = this->Whole.Terms.Faces(f, k);
        if (localOf[v] < 0)
        {
          localOf[v] = static_cast<int>(this->Free); // for now
          this->Vertices.push_back(v);
        }
      }
    }
    std::sort(this->Vertices.begin() + static_cast<std::ptrdiff_t>(this->Free), this->Vertices.end());
    for (std::size_t i = this->Free; i < this->Vertices.size(); ++i)
    {
      localOf[this->Vertices[i]] = static_cast<int>(i);
    }
  }

  std::vector<int> boundaryMembers() const
  {
    std::vector<int> members;
    for (const int v : this->Vertices)
    {
      if (this->Whole.Dofs.memberOf(v) >= 0)
      {
        members.push_back(this->Whole.Dofs.memberOf(v));
      }
    }
    std::sort(members.begin(), members.end());
    return members;
  }

  RefinementTerms terms(const std::vector<int>& members, const std::vector<int>& localOf) const
  {
    const RefinementTerms& all = this->Whole.Terms;
    RefinementTerms part;
    part.Faces =
      all.Faces(this->Rows, flattening::all).unaryExpr([&localOf](int v) { return localOf[v]; });
    part.Cotangents = all.Cotangents(this->Rows, flattening::all);
    part.ShapeLimits = all.ShapeLimits(this->Rows);
    part.ShapeWeights = this->ThePass.ShapeFactor * all.ShapeWeights(this->Rows);
    const auto indexOf = [&](int member)
    {
      const auto found = std::lower_bound(members.begin(), members.end(), member);
      return found != members.end() && *found == member ? static_cast<int>(found - members.begin()) : -1;
    };
    for (const int member : members)
    {
      BoundaryInterval interval = all.Intervals[member];
      interval.First = indexOf(interval.First);
      interval.Second = indexOf(interval.Second);
      if (interval.Second >= 0)
      {
        part.Intervals.push_back(interval);
      }
    }
    this->addOutline(part, localOf);
    return part;
  }

  // The edges of a free boundary that move.
  void addOutline(RefinementTerms& part, const std::vector<int>& localOf) const
  {
    const auto isFree = [&](int vertex)
    { return localOf[vertex] >= 0 && localOf[vertex] < static_cast<int>(this->Free); };
    for (const auto& [a, b] : this->Whole.Terms.Outline)
    {
      if (isFree(a) || isFree(b))
      {
        part.Outline.push_back({ localOf[a], localOf[b] });
      }
    }
  }

  const RefinementPatches& Whole;
  const Pass& ThePass;
  std::vector<int> Vertices;
  std::size_t Free = 0;
  std::vector<int> Rows;
};

RefinementPatches::RefinementPatches(const RefinementTerms& terms,
  const VertexFaces& facesOf,
  const DegreesOfFreedom& dofs,
  const Points2& chart)
  : Terms(terms)
  , FacesOf(facesOf)
  , Dofs(dofs)
  , Chart(chart)
{
}

bool RefinementPatches::moves(int vertex, const std::vector<int>& partOf) const
{
  for (const int f : this->FacesOf[vertex])
  {
    for (int k = 0; k < 3; ++k)
    {
      if (partOf[this->Terms.Faces(f, k)] < partOf[vertex])
      {
        return false;
      }
    }
  }
  return true;
}

// The vertices that may move. Those of different parts share a face only along the lines by which a
// group is divided.
std::vector<std::vector<int>> RefinementPatches::parts(const Pass& pass) const
{
  const int n = static_cast<int>(this->Chart.rows());
  if (pass.Moving.empty())
  {
    return recursiveBisection(this->Chart, LargestPatch, Turn * pass.Number);
  }
  std::vector<std::vector<int>> result;
  std::vector<char> isFound(n, 0);
  for (int first = 0; first < n; ++first)
  {
    if (!pass.Moving[first] || isFound[first])
    {
      continue;
    }
    std::vector<int> group = this->connectedGroup(first, pass.Moving, isFound);
    if (static_cast<int>(group.size()) <= LargestPatch)
    {
      result.push_back(std::move(group));
      continue;
    }
    const Points2 points = this->Chart(group, flattening::all);
    for (std::vector<int>& part : recursiveBisection(points, LargestPatch, Turn * pass.Number))
    {
      for (int& v : part)
      {
        v = group[v];
      }
      result.push_back(std::move(part));
    }
  }
  return result;
}

// The vertices that may move and are connected with @p first by such vertices, in ascending order. Marks
// them in @p isFound.
std::vector<int> RefinementPatches::connectedGroup(int first,
  const std::vector<char>& moving,
  std::vector<char>& isFound) const
{
  std::vector<int> group{ first };
  isFound[first] = 1;
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    for (const int f : this->FacesOf[group[i]])
    {
      for (int k = 0; k < 3; ++k)
      {
        const int v = this->Terms.Faces(f, k);
        if (moving[v] && !isFound[v])
        {
          isFound[v] = 1;
          group.push_back(v);
        }
      }
    }
  }
  std::sort(group.begin(), group.end());
  return group;
}

int RefinementPatches::run(const Pass& pass, DomainMap& map, const ProgressCallback& progress)
{
  const std::vector<std::vector<int>> parts = this->parts(pass);
  constexpr int inNoPart = std::numeric_limits<int>::max(); // beside such vertices others may move
  std::vector<int> partOf(map.Positions.rows(), inNoPart);
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (const int v : parts[p])
    {
      partOf[v] = static_cast<int>(p);
    }
  }
  // Patches may run at the same time: no patch reads a vertex that another one moves.
  std::atomic<int> worked = 0;
  std::atomic<int> done = 0;
  const std::thread::id caller = std::this_thread::get_id();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts.size(), 1),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t p = range.begin(); p < range.end(); ++p)
      {
        if (std::this_thread::get_id() == caller)
        {
          report(progress, static_cast<double>(done) / parts.size(), "Face refinement");
        }
        worked += Patch(*this, pass, parts[p], partOf).refine(map, map) ? 1 : 0;
        ++done;
      }
    });
  return worked;
}

} // namespace flattening
