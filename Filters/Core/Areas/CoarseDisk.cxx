// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/CoarseDisk.h"

#include "Areas/RefinementTerms.h"
#include "Mesh/OutlineTriangulation.h"
#include "Mesh/PlaneVectors.h"
#include "Mesh/SpreadVertices.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{

// A surface of area A has room for about A / (VertexArea d^2) vertices that are at least d from each
// other (spreadVertices). Measured.
constexpr double VertexArea = 1.1;
// Each face of the surface is taken in SplitsPerSide^2 parts, and each part belongs to the face that has
// its centroid. Measured on half a brain: with 1, 2 and 4 the mean angle error of a map that was carried
// is above 20, 6.1 and 4.9 degrees.
constexpr int SplitsPerSide = 4;
// The least target of a face, in mean ones: the smallest faces cover no part.
constexpr double LeastTarget = 0.01;
// The greatest eigenvalue of a metric with determinant 1. A guard: a few slivers may be all that a face
// covers.
constexpr double GreatestStretch = 10.0;
// Faces between two reports of progress.
constexpr int FacesPerReport = 10000;

Eigen::Vector2d sideAcross(const Points2& positions, const Eigen::RowVector3i& face, int corner)
{
  return positions.row(face[(corner + 2) % 3]) - positions.row(face[(corner + 1) % 3]);
}

// The inverse of the metric, scaled to the determinant 1, that a face of the surface has in the chart.
Eigen::Matrix2d inverseMetric(const RefinementTerms& terms, const Points2& chart, int face)
{
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector2d side = sideAcross(chart, terms.Faces.row(face), k);
    sum += terms.Cotangents(face, k) * side * side.transpose();
  }
  const double determinant = sum.determinant();
  return determinant > 0.0 ? Eigen::Matrix2d(sum / std::sqrt(determinant)) : Eigen::Matrix2d::Identity();
}

// The metric for a mean of such inverses, scaled likewise and without stretches beyond GreatestStretch.
Eigen::Matrix2d metricOf(const Eigen::Matrix2d& inverse)
{
  const double determinant = inverse.determinant();
  if (!(determinant > 0.0)) // nothing is covered
  {
    return Eigen::Matrix2d::Identity();
  }
  // The eigenvalues of a matrix of determinant 1 are the mean plus and minus the deviation, and the
  // inverse has the same ones.
  const Eigen::Matrix2d scaled = inverse / std::sqrt(determinant);
  const double mean = 0.5 * scaled.trace();
  const Eigen::Matrix2d deviator = scaled - mean * Eigen::Matrix2d::Identity();
  constexpr double mostMean = 0.5 * (GreatestStretch + 1.0 / GreatestStretch);
  if (mean <= mostMean)
  {
    return mean * Eigen::Matrix2d::Identity() - deviator;
  }
  constexpr double mostDeviation = 0.5 * (GreatestStretch - 1.0 / GreatestStretch);
  const double deviation = deviator.norm() / std::sqrt(2.0);
  return mostMean * Eigen::Matrix2d::Identity() - (mostDeviation / deviation) * deviator;
}

// Makes a coarse disk of a surface.
class Coarsening
{
public:
  Coarsening(const TriangleMesh& surface,
    const std::vector<int>& loop,
    const Points2& chart,
    std::vector<int> vertices,
    const ProgressCallback& progress)
    : Surface(surface)
    , Loop(loop)
    , Chart(chart)
    , Triangles(chart,
        outlineEdges(loop),
        { vertices.begin() + static_cast<std::ptrdiff_t>(loop.size()), vertices.end() },
        progress)
  {
    std::vector<int> rowOf(surface.vertexCount(), -1);
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
      rowOf[vertices[k]] = static_cast<int>(k);
    }
    this->Disk.Faces = this->Triangles.inside().unaryExpr([&](int v) { return rowOf[v]; });
    this->Disk.Vertices = std::move(vertices);
  }

  CoarseDisk run(const Eigen::VectorXd& targets, const ProgressCallback& progress)
  {
    this->placeVertices();
    this->cover(targets, progress);
    return std::move(this->Disk);
  }

private:
  // The face that has a point of the chart, or a face near it if rounding takes the point out of the
  // outline.
  int faceAt(const Eigen::Vector2d& point, int near) const
  {
    const int face = this->Triangles.insideAt(point, near);
    return face >= 0 ? face : near;
  }

  // Each vertex is looked for from another one of its face.
  void placeVertices()
  {
    const int n = this->Surface.vertexCount();
    this->Disk.FaceOf.assign(n, -1);
    this->Disk.Weights.resize(n, 3);
    int near = 0;
    for (int f = 0; f < this->Surface.faceCount(); ++f)
    {
      const auto corners = this->Surface.Faces.row(f);
      for (int k = 0; k < 3; ++k)
      {
        near = this->Disk.FaceOf[corners[k]] >= 0 ? this->Disk.FaceOf[corners[k]] : near;
      }
      for (int k = 0; k < 3; ++k)
      {
        if (this->Disk.FaceOf[corners[k]] < 0)
        {
          near = this->place(corners[k], near);
        }
      }
    }
  }

  // Returns the face of the vertex.
  int place(int vertex, int near)
  {
    const Eigen::Vector2d point = this->Chart.row(vertex);
    const int face = this->faceAt(point, near);
    const auto corners = this->Triangles.inside().row(face);
    Eigen::RowVector3d parts;
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector2d begin = this->Chart.row(corners[(k + 1) % 3]);
      parts[k] = cross(sideAcross(this->Chart, corners, k), point - begin);
    }
    this->Disk.FaceOf[vertex] = face;
    this->Disk.Weights.row(vertex) = parts / parts.sum();
    return face;
  }

  // Finds the targets and the shapes.
  void cover(const Eigen::VectorXd& targets, const ProgressCallback& progress)
  {
    const RefinementTerms terms(this->Surface, this->Loop, 1.0, 1.0);
    const FaceMatrix& faces = this->Triangles.inside();
    std::vector<Eigen::Matrix2d> inverses(faces.rows(), Eigen::Matrix2d::Zero());
    this->Disk.Targets = Eigen::VectorXd::Zero(faces.rows());
    for (int f = 0; f < this->Surface.faceCount(); ++f)
    {
      if (f % FacesPerReport == 0)
      {
        report(progress, static_cast<double>(f) / this->Surface.faceCount(), "Coarse disk");
      }
      const Eigen::Matrix2d inverse = inverseMetric(terms, this->Chart, f);
      const double part = targets[f] / (SplitsPerSide * SplitsPerSide);
      int face = this->Disk.FaceOf[this->Surface.Faces(f, 0)];
      for (const Eigen::Vector2d& centroid : this->centroidsOfParts(f))
      {
        face = this->faceAt(centroid, face);
        this->Disk.Targets[face] += part;
        inverses[face] += part * inverse;
      }
    }
    this->Disk.Targets = this->Disk.Targets.cwiseMax(LeastTarget * this->Disk.Targets.mean());
    this->Disk.Cotangents.resize(faces.rows(), 3);
    for (Eigen::Index face = 0; face < faces.rows(); ++face)
    {
      const Eigen::Matrix2d metric = metricOf(inverses[face]);
      Eigen::Vector2d sides[3];
      for (int k = 0; k < 3; ++k)
      {
        sides[k] = sideAcross(this->Chart, faces.row(face), k);
      }
      for (int k = 0; k < 3; ++k)
      {
        this->Disk.Cotangents(face, k) =
          -sides[(k + 1) % 3].dot(metric * sides[(k + 2) % 3]) / cross(sides[0], sides[1]);
      }
    }
  }

  // The centroids of the parts of a face of the surface.
  std::vector<Eigen::Vector2d> centroidsOfParts(int face) const
  {
    const auto corners = this->Surface.Faces.row(face);
    const Eigen::Vector2d first = this->Chart.row(corners[0]);
    const Eigen::Vector2d toSecond = this->Chart.row(corners[1]).transpose() - first;
    const Eigen::Vector2d toThird = this->Chart.row(corners[2]).transpose() - first;
    std::vector<Eigen::Vector2d> centroids;
    centroids.reserve(SplitsPerSide * SplitsPerSide);
    constexpr int thirds = 3 * SplitsPerSide;
    // In thirds of a part's side: upright parts at 1, 4, 7, ..., inverted ones at 2, 5, 8, ...
    for (int begin = 1; begin <= 2; ++begin)
    {
      for (int i = begin; i < thirds; i += 3)
      {
        for (int j = begin; i + j < thirds; j += 3)
        {
          centroids.push_back(first + (i * toSecond + j * toThird) / thirds);
        }
      }
    }
    return centroids;
  }

  const TriangleMesh& Surface;
  const std::vector<int>& Loop;
  const Points2& Chart;
  OutlineTriangulation Triangles;
  CoarseDisk Disk;
};

} // namespace

Points2 CoarseDisk::carried(const Points2& positions) const
{
  Points2 all = Points2::Zero(this->Weights.rows(), 2);
  for (Eigen::Index v = 0; v < all.rows(); ++v)
  {
    for (int k = 0; k < 3; ++k)
    {
      all.row(v) += this->Weights(v, k) * positions.row(this->Faces(this->FaceOf[v], k));
    }
  }
  return all;
}

CoarseDisk coarseDisk(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& chart,
  const Eigen::VectorXd& targets,
  int vertices,
  const ProgressCallback& progress)
{
  const double area = faceAreas(surface.Vertices, surface.Faces).sum();
  std::vector<int> chosen = spreadVertices(
    surface, loop, std::sqrt(area / (VertexArea * vertices)), subrange(progress, 0.0, 0.3));
  Coarsening coarsening(surface, loop, chart, std::move(chosen), subrange(progress, 0.3, 0.6));
  return coarsening.run(targets, subrange(progress, 0.6, 1.0));
}

} // namespace flattening
