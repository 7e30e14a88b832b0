// SPDX-License-Identifier: GPL-3.0-or-later
/// The degrees of freedom of a flat map.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Transport/ConvexDomain.h"

#include <memory>
#include <vector>

namespace flattening
{

/// A flat map to a convex domain, with the boundary vertices on its boundary.
struct DomainMap
{
  Points2 Positions;                  ///< n x 2
  Eigen::VectorXd BoundaryParameters; ///< of the boundary vertices, in the order of the loop
};

/// An interior vertex has two degrees of freedom (dofs), its coordinates; a boundary vertex has one, its
/// boundary parameter (ConvexDomain.h); a vertex that stays has none. Dofs are numbered by vertex.
class DegreesOfFreedom
{
public:
  /// For a whole map: @p loop holds the boundary vertices, counter-clockwise; those at the indices
  /// @p corners stay.
  DegreesOfFreedom(int vertexCount,
    std::shared_ptr<const ConvexDomain> domain,
    std::vector<int> loop,
    const std::vector<int>& corners);
  /// For a whole map whose boundary is free: all vertices are like those of the interior.
  explicit DegreesOfFreedom(int vertexCount);
  /// For a part of a map: @p members are its vertices on the boundary, in order; a vertex with 1 in
  /// @p stays (n) does not move.
  DegreesOfFreedom(std::shared_ptr<const ConvexDomain> domain,
    std::vector<int> members,
    const std::vector<char>& stays);

  int vertexCount() const { return static_cast<int>(this->Member.size()); }
  int count() const { return this->First.back(); } ///< of all vertices
  /// The first dof of a vertex; that of vertexCount() is count().
  int first(int vertex) const { return this->First[vertex]; }
  int countOf(int vertex) const { return this->First[vertex + 1] - this->First[vertex]; }

  const ConvexDomain& domain() const { return *this->Domain; }
  const std::shared_ptr<const ConvexDomain>& sharedDomain() const { return this->Domain; }
  const std::vector<int>& loop() const { return this->Loop; }
  /// The dof of the vertex at index @p member of the loop; -1 if it stays.
  int dofOfMember(int member) const;
  int memberOf(int vertex) const { return this->Member[vertex]; } ///< index in the loop, -1 inside

  /// The derivative of a vertex's position by its dofs: one column per dof, 0 where there is none.
  Eigen::Matrix2d directions(const DomainMap& map, int vertex) const;

  /// The motions of all vertices (n x 2) for @p step (count()), those of boundary vertices along their
  /// tangents.
  Points2 motions(const DomainMap& map, const Eigen::VectorXd& step) const;

  /// @p map moved by @p length times @p step (count()).
  DomainMap moved(const DomainMap& map, const Eigen::VectorXd& step, double length) const;

  /// The map with the share @p share of the way from one map to another, along the boundary where they
  /// are on it.
  DomainMap between(const DomainMap& from, const DomainMap& to, double share) const;

private:
  void number(const std::vector<char>& stays);

  std::shared_ptr<const ConvexDomain> Domain;
  std::vector<int> Loop;
  std::vector<int> Member; // per vertex: its index in the loop, or -1
  std::vector<int> First;  // per vertex: its first dof; the last entry is the number of dofs
};

} // namespace flattening
