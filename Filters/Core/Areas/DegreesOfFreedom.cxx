// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/DegreesOfFreedom.h"

#include <tbb/parallel_for.h>

#include <utility>

namespace flattening
{
namespace
{

// Vertices of one task of a thread. Results do not depend on it.
constexpr int VerticesPerTask = 4096;

} // namespace

DegreesOfFreedom::DegreesOfFreedom(int vertexCount,
  std::shared_ptr<const ConvexDomain> domain,
  std::vector<int> loop,
  const std::vector<int>& corners)
  : Domain(std::move(domain))
  , Loop(std::move(loop))
{
  std::vector<char> stays(vertexCount, 0);
  for (const int member : corners)
  {
    stays[this->Loop[member]] = 1;
  }
  this->number(stays);
}

DegreesOfFreedom::DegreesOfFreedom(std::shared_ptr<const ConvexDomain> domain,
  std::vector<int> members,
  const std::vector<char>& stays)
  : Domain(std::move(domain))
  , Loop(std::move(members))
{
  this->number(stays);
}

DegreesOfFreedom::DegreesOfFreedom(int vertexCount)
{
  this->number(std::vector<char>(vertexCount, 0));
}

void DegreesOfFreedom::number(const std::vector<char>& stays)
{
  const std::size_t vertices = stays.size();
  this->Member.assign(vertices, -1);
  for (std::size_t k = 0; k < this->Loop.size(); ++k)
  {
    this->Member[this->Loop[k]] = static_cast<int>(k);
  }
  this->First.assign(vertices + 1, 0);
  for (std::size_t v = 0; v < vertices; ++v)
  {
    const int own = stays[v] ? 0 : this->Member[v] >= 0 ? 1 : 2;
    this->First[v + 1] = this->First[v] + own;
  }
}

int DegreesOfFreedom::dofOfMember(int member) const
{
  const int v = this->Loop[member];
  return this->countOf(v) > 0 ? this->first(v) : -1;
}

Eigen::Matrix2d DegreesOfFreedom::directions(const DomainMap& map, int vertex) const
{
  if (this->countOf(vertex) == 2)
  {
    return Eigen::Matrix2d::Identity();
  }
  Eigen::Matrix2d result = Eigen::Matrix2d::Zero();
  if (this->countOf(vertex) == 1)
  {
    result.col(0) = this->Domain->tangentAt(map.BoundaryParameters[this->Member[vertex]]);
  }
  return result;
}

Points2 DegreesOfFreedom::motions(const DomainMap& map, const Eigen::VectorXd& step) const
{
  Points2 motions(map.Positions.rows(), 2);
  tbb::parallel_for(tbb::blocked_range<int>(0, static_cast<int>(motions.rows()), VerticesPerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int v = range.begin(); v < range.end(); ++v)
      {
        Eigen::Vector2d own = Eigen::Vector2d::Zero();
        own.head(this->countOf(v)) = step.segment(this->first(v), this->countOf(v));
        motions.row(v) = this->directions(map, v) * own;
      }
    });
  return motions;
}

DomainMap DegreesOfFreedom::moved(const DomainMap& map, const Eigen::VectorXd& step, double length) const
{
  DomainMap result = map;
  const int n = static_cast<int>(map.Positions.rows());
  tbb::parallel_for(tbb::blocked_range<int>(0, n, VerticesPerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int v = range.begin(); v < range.end(); ++v)
      {
        const int dof = this->first(v);
        if (this->countOf(v) == 2)
        {
          result.Positions(v, 0) += length * step[dof];
          result.Positions(v, 1) += length * step[dof + 1];
        }
        else if (this->countOf(v) == 1)
        {
          double& parameter = result.BoundaryParameters[this->Member[v]];
          parameter += length * step[dof];
          result.Positions.row(v) = this->Domain->at(parameter);
        }
      }
    });
  return result;
}

DomainMap DegreesOfFreedom::between(const DomainMap& from, const DomainMap& to, double share) const
{
  DomainMap result;
  result.Positions = (1.0 - share) * from.Positions + share * to.Positions;
  result.BoundaryParameters = (1.0 - share) * from.BoundaryParameters + share * to.BoundaryParameters;
  for (std::size_t k = 0; k < this->Loop.size(); ++k)
  {
    result.Positions.row(this->Loop[k]) = this->Domain->at(result.BoundaryParameters[k]);
  }
  return result;
}

} // namespace flattening
