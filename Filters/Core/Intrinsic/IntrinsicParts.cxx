// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of an IntrinsicTriangulation: copies of some faces, and the rest without a star.
#include "Intrinsic/IntrinsicTriangulation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace flattening
{

IntrinsicTriangulation::Part IntrinsicTriangulation::part(const std::vector<int>& faces) const
{
  Part part{ IntrinsicTriangulation(), {}, faces, {} };
  IntrinsicTriangulation& copy = part.Triangulation;
  std::vector<int> localFace(this->faceCount(), -1);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    localFace[faces[i]] = static_cast<int>(i);
  }
  std::vector<int> localVertex(this->VertexCount, -1);
  for (const int f : faces)
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
    {
      int& vertex = localVertex[this->Origins[h]];
      if (vertex < 0)
      {
        vertex = static_cast<int>(part.Vertices.size());
        part.Vertices.push_back(this->Origins[h]);
      }
      copy.Origins.push_back(vertex);
      copy.LogLengths.push_back(this->LogLengths[h]);
    }
  }
  copy.VertexCount = static_cast<int>(part.Vertices.size());
  copy.Twins.resize(copy.Origins.size());
  for (int k = 0; k < copy.halfedgeCount(); ++k)
  {
    const int twin = this->Twins[3 * faces[face(k)] + k % 3];
    if (twin >= 0 && localFace[face(twin)] >= 0)
    {
      copy.Twins[k] = 3 * localFace[face(twin)] + twin % 3;
    }
    else
    {
      const int b =
        copy.addBoundaryEdge({ copy.Origins[k], -1, -1, k, copy.LogLengths[k], OnMirror, true });
      copy.Twins[k] = -1 - b;
      part.Outside.push_back(twin);
    }
  }
  return part;
}

void IntrinsicTriangulation::replace(const Part& part)
{
  const IntrinsicTriangulation& copy = part.Triangulation;
  const auto whole = [&part](int k) { return 3 * part.Faces[face(k)] + k % 3; };
  for (int k = 0; k < copy.halfedgeCount(); ++k)
  {
    const int h = whole(k);
    const int twin = copy.Twins[k];
    this->Origins[h] = part.Vertices[copy.Origins[k]];
    this->LogLengths[h] = copy.LogLengths[k];
    this->glue(h, twin >= 0 ? whole(twin) : part.Outside[-1 - twin]);
  }
  this->Outgoing.clear();
}

IntrinsicTriangulation::Star IntrinsicTriangulation::removeStar(int vertex)
{
  const std::vector<int> around = this->outgoing(vertex);
  const int out = -1 - this->Twins[around.front()];
  const int in = -1 - this->Twins[previous(around.back())];
  Star star;
  for (const int h : around)
  {
    star.Spokes.push_back({ this->tip(h), this->LogLengths[h] });
  }
  star.Spokes.push_back({ this->Boundary[in].Origin, this->Boundary[in].LogLength });
  star.FirstBoundaryEdge = this->Boundary[out].Next;

  int before = this->Boundary[in].Previous;
  for (auto h = around.rbegin(); h != around.rend(); ++h)
  {
    const int opposite = next(*h);
    const int added = this->addBoundaryEdge(
      { this->tip(opposite), before, -1, -1, this->LogLengths[opposite], OnMirror, true });
    this->glue(-1 - added, this->Twins[opposite]);
    this->Boundary[before].Next = added;
    this->removeFace(face(*h));
    before = added;
  }
  this->Boundary[before].Next = star.FirstBoundaryEdge;
  this->Boundary[star.FirstBoundaryEdge].Previous = before;
  this->Boundary[out].Origin = this->Boundary[in].Origin = -1;
  this->closeGaps();
  return star;
}

std::optional<IntrinsicTriangulation::Neighbour> IntrinsicTriangulation::reachInfinity(const Factors& u,
  const std::vector<char>& excluded)
{
  for (int b = 0; b < static_cast<int>(this->Boundary.size()); ++b)
  {
    const int h = this->Boundary[b].Inner;
    if (this->Boundary[b].Origin < 0 || !this->Boundary[b].AtInfinity || h < 0)
    {
      continue;
    }
    const int apex = this->origin(previous(h));
    const long double base = this->scaledLogLength(h, u);
    const double sides = std::exp(static_cast<double>(this->scaledLogLength(next(h), u) - base)) +
                         std::exp(static_cast<double>(this->scaledLogLength(previous(h), u) - base));
    if (sides <= 1.0 && !excluded[apex])
    {
      this->openBoundaryEdge(b, OnMirror);
      this->closeGaps();
      // Ptolemy's relation with the distances from infinity, of which those of the edge's ends are 1.
      return Neighbour{ apex, u[apex] - 2.0L * std::log(static_cast<long double>(sides)) };
    }
  }
  return {};
}

} // namespace flattening
