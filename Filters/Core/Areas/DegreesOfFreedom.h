// SPDX-License-Identifier: GPL-3.0-or-later
/// Which coordinates of a flat map may change.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Transport/ConvexDomain.h"

#include <memory>
#include <vector>

namespace flattening
{

/// A flat map whose boundary vertices lie on the boundary of a convex domain.
struct FlatState
{
  Points2 Positions;
  Eigen::VectorXd Places; ///< of the boundary vertices, in the order of the loop (ConvexDomain.h)
};

/// The unknowns are both coordinates of an interior vertex, the place on the boundary of a boundary
/// vertex, and nothing of a vertex that stays.
class DegreesOfFreedom
{
public:
  /// @p loop counter-clockwise; its members @p corners stay.
  DegreesOfFreedom(int vertexCount,
    std::shared_ptr<const ConvexDomain> domain,
    std::vector<int> loop,
    const std::vector<int>& corners);
  /// Of a part of a map: @p members are those of its vertices that lie on the boundary, in order, and
  /// @p stays says of each of its vertices (1) that it does not move.
  DegreesOfFreedom(std::shared_ptr<const ConvexDomain> domain,
    std::vector<int> members,
    const std::vector<char>& stays);

  int vertexCount() const { return static_cast<int>(this->Member.size()); }
  int count() const { return this->First.back(); }
  int first(int vertex) const { return this->First[vertex]; }
  int countOf(int vertex) const { return this->First[vertex + 1] - this->First[vertex]; }

  const ConvexDomain& domain() const { return *this->Domain; }
  const std::shared_ptr<const ConvexDomain>& sharedDomain() const { return this->Domain; }
  const std::vector<int>& loop() const { return this->Loop; }
  /// The unknown of a member of the loop; -1 if it stays.
  int unknownOfMember(int member) const;
  int memberOf(int vertex) const { return this->Member[vertex]; } ///< -1 inside

  /// By the unknowns of a vertex, which move it: column k for unknown k, 0 where there is none.
  Eigen::Matrix2d directions(const FlatState& state, int vertex) const;

  /// @p state after @p length times @p step (count()).
  FlatState moved(const FlatState& state, const Eigen::VectorXd& step, double length) const;

private:
  void number(const std::vector<char>& stays);

  std::shared_ptr<const ConvexDomain> Domain;
  std::vector<int> Loop;
  std::vector<int> Member; // per vertex: its index in the loop, or -1
  std::vector<int> First;
};

} // namespace flattening
