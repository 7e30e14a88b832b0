// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/OutlineUntangling.h"

#include "Mesh/FaceOrientation.h"
#include "Mesh/OutlineGaps.h"

namespace flattening
{
namespace
{

TargetTriangle triangleOf(const Eigen::RowVector3i& face, const Points2& positions)
{
  const auto first = positions.row(face[0]);
  return { positions.row(face[1]) - first, positions.row(face[2]) - first };
}

// The vertices of faces that are flipped and of edges that cross.
std::vector<char> faults(const Points2& positions,
  const FaceMatrix& faces,
  const std::vector<FlatEdge>& outline)
{
  std::vector<char> flags(positions.rows(), 0);
  const std::vector<signed char> orientations = faceOrientations(positions, faces);
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    for (const int corner : faces.row(f))
    {
      flags[corner] = flags[corner] || orientations[f] <= 0;
    }
  }
  const std::vector<char> crossing = crossingEdges(positions, outline);
  for (std::size_t k = 0; k < crossing.size(); ++k)
  {
    for (const int v : outline[k])
    {
      flags[v] = flags[v] || crossing[k];
    }
  }
  return flags;
}

// The vertices of the outline that are not near faults.
std::vector<char> fixedVertices(const Points2& positions,
  const FaceMatrix& faces,
  const VertexFaces& facesOf,
  const std::vector<FlatEdge>& outline)
{
  std::vector<char> fixed(positions.rows(), 0);
  for (const FlatEdge& edge : outline)
  {
    fixed[edge[0]] = 1;
  }
  const std::vector<char> isFault = faults(positions, faces, outline);
  for (int v = 0; v < static_cast<int>(isFault.size()); ++v)
  {
    if (!isFault[v])
    {
      continue;
    }
    for (const int face : facesOf[v])
    {
      for (const int corner : faces.row(face))
      {
        fixed[corner] = 0;
      }
    }
  }
  return fixed;
}

// The faces, and the gaps of the outline that vertices bound which are not fixed.
FaceMatrix withGaps(const FaceMatrix& faces,
  const Points2& positions,
  const std::vector<FlatEdge>& outline,
  const std::vector<char>& fixed)
{
  const FaceMatrix gaps = outlineGaps(positions, outline);
  FaceMatrix all(faces.rows() + gaps.rows(), 3);
  all.topRows(faces.rows()) = faces;
  Eigen::Index count = faces.rows();
  for (Eigen::Index gap = 0; gap < gaps.rows(); ++gap)
  {
    if (!fixed[gaps(gap, 0)] || !fixed[gaps(gap, 1)] || !fixed[gaps(gap, 2)])
    {
      all.row(count++) = gaps.row(gap);
    }
  }
  all.conservativeResize(count, 3);
  return all;
}

} // namespace

void untangleWithOutline(const FaceMatrix& faces,
  const VertexFaces& facesOf,
  const std::vector<FlatEdge>& outline,
  const Points2& before,
  const TargetTriangles& targets,
  Points2& positions,
  const UntanglingOptions& options,
  const ProgressCallback& progress)
{
  const std::vector<char> fixed = fixedVertices(positions, faces, facesOf, outline);
  const FaceMatrix all = withGaps(faces, before, outline, fixed);
  untangleMap(
    all,
    fixed,
    [&](int f) { return f < faces.rows() ? targets(f) : triangleOf(all.row(f), before); },
    positions,
    options,
    progress);
}

bool makeOneToOne(const FaceMatrix& faces,
  const std::vector<int>& loop,
  const TargetTriangles& targets,
  Points2& positions,
  const UntanglingOptions& options,
  const ProgressCallback& progress)
{
  if (!isSimpleOutline(positions, loop))
  {
    return false;
  }
  std::vector<char> onOutline(positions.rows(), 0);
  for (const int v : loop)
  {
    onOutline[v] = 1;
  }
  const UntanglingReport report =
    untangleMap(faces, onOutline, targets, positions, options, subrange(progress, 0.0, 0.5));
  if (report.FlippedFaces == 0)
  {
    return true;
  }
  const Points2 before = positions;
  untangleWithOutline(faces,
    VertexFaces(faces, static_cast<int>(positions.rows())),
    outlineEdges(loop),
    before,
    targets,
    positions,
    options,
    subrange(progress, 0.5, 1.0));
  return countFlippedFaces(positions, faces) == 0 && isSimpleOutline(positions, loop);
}

} // namespace flattening
