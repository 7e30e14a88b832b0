// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/UntanglingPatch.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace flattening
{
namespace
{

// Ratio of the common stretch's singular values from which on the coordinates undo it. A choice:
// Newton's method copes with milder stretches, and the plain coordinates are the simpler ones.
constexpr double LeastAnisotropy = 4.0;
// Steps of Tyler's fixed point, of which each reduces the error by about half: the stretch need not be
// exact.
constexpr int ScatterSteps = 10;

void sortUnique(std::vector<int>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

// The stretch that the maps from the targets to the faces have in common: a symmetric matrix of
// determinant 1, the identity if the stretch is mild. It is the root of a robust scatter matrix of these
// maps in which every face has the same weight, whatever its size (Tyler, "A distribution-free
// M-estimator of multivariate scatter", 1987).
Eigen::Matrix2d commonStretch(const FlatPatch& patch)
{
  std::vector<Eigen::Matrix2d> stretches;
  for (Eigen::Index f = 0; f < patch.Faces.rows(); ++f)
  {
    const TargetTriangle& target = patch.Targets[f];
    Eigen::Matrix2d edges;
    Eigen::Matrix2d targetEdges;
    for (int k = 0; k < 2; ++k)
    {
      edges.col(k) = patch.Positions.row(patch.Faces(f, k + 1)) - patch.Positions.row(patch.Faces(f, 0));
    }
    targetEdges << target.Second, target.Third;
    const Eigen::Matrix2d jacobian = edges * targetEdges.inverse();
    stretches.emplace_back(jacobian * jacobian.transpose());
  }
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Identity();
  for (int step = 0; step < ScatterSteps; ++step)
  {
    const Eigen::Matrix2d inverse = scatter.inverse();
    Eigen::Matrix2d next = Eigen::Matrix2d::Zero();
    for (const Eigen::Matrix2d& stretch : stretches)
    {
      const double size = (inverse * stretch).trace();
      if (size > 0.0)
      {
        next += stretch / size;
      }
    }
    const double determinant = next.determinant();
    if (!(determinant > 0.0) || !std::isfinite(determinant))
    {
      return Eigen::Matrix2d::Identity();
    }
    scatter = next / std::sqrt(determinant);
  }
  // The eigenvalues are s and 1 / s, where s is the ratio of the singular values, and the root of a
  // matrix M of determinant 1 is (M + I) / sqrt(tr M + 2), by the theorem of Cayley and Hamilton.
  if (scatter.trace() <= LeastAnisotropy + 1.0 / LeastAnisotropy)
  {
    return Eigen::Matrix2d::Identity();
  }
  return (scatter + Eigen::Matrix2d::Identity()) / std::sqrt(scatter.trace() + 2.0);
}

} // namespace

UntanglingPatch::UntanglingPatch(const UntanglingMesh& mesh,
  int face,
  int mostVertices,
  const ProgressCallback& progress)
  : Mesh(mesh)
  , MostVertices(mostVertices)
  , Progress(progress)
{
  this->free(face);
  this->includeFlippedFaces();
}

bool UntanglingPatch::grow()
{
  const std::size_t before = this->Vertices.size();
  for (const int f : this->Faces)
  {
    this->free(f);
  }
  this->includeFlippedFaces();
  return this->Vertices.size() > before;
}

void UntanglingPatch::free(int face)
{
  for (int k = 0; k < 3; ++k)
  {
    const int v = this->Mesh.Faces(face, k);
    if (!this->Mesh.Fixed[v])
    {
      this->Vertices.push_back(v);
    }
  }
}

void UntanglingPatch::includeFlippedFaces()
{
  sortUnique(this->Vertices);
  std::size_t known = 0;
  while (this->Vertices.size() > known && !this->tooLarge())
  {
    report(this->Progress, 0.0, UntanglingStage);
    known = this->Vertices.size();
    this->Faces.clear();
    for (const int v : this->Vertices)
    {
      const auto faces = this->Mesh.FacesOf[v];
      this->Faces.insert(this->Faces.end(), faces.begin(), faces.end());
    }
    sortUnique(this->Faces);
    for (const int f : this->Faces)
    {
      if (!this->Mesh.safelyPositive(f))
      {
        this->free(f);
      }
    }
    sortUnique(this->Vertices);
  }
}

UntanglingPatch::Local UntanglingPatch::local() const
{
  Local result;
  std::vector<int> vertices = this->Vertices;
  if (vertices.empty())
  {
    return result;
  }
  FlatPatch& flat = result.Flat;
  flat.FreeVertices = static_cast<int>(vertices.size());
  std::unordered_map<int, int> numbers;
  for (const int v : vertices)
  {
    numbers.emplace(v, static_cast<int>(numbers.size()));
  }
  flat.Faces.resize(this->Faces.size(), 3);
  for (std::size_t i = 0; i < this->Faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = this->Mesh.Faces(this->Faces[i], k);
      const auto [entry, isNew] = numbers.emplace(v, static_cast<int>(numbers.size()));
      if (isNew)
      {
        vertices.push_back(v);
      }
      flat.Faces(i, k) = entry->second;
    }
  }
  result.Origin = this->Mesh.Positions.row(vertices.front());
  flat.Positions.resize(vertices.size(), 2);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    flat.Positions.row(i) = this->Mesh.Positions.row(vertices[i]) - result.Origin;
  }
  for (const int f : this->Faces)
  {
    flat.Targets.push_back(this->Mesh.Targets(f));
  }
  const Eigen::Matrix2d stretch = commonStretch(flat);
  flat.Positions *= stretch.inverse();
  const double unit = flat.Positions.cwiseAbs().maxCoeff();
  if (unit > 0.0)
  {
    flat.Positions /= unit;
    for (TargetTriangle& target : flat.Targets)
    {
      target = { target.Second / unit, target.Third / unit };
    }
    result.Frame = unit * stretch;
  }
  return result;
}

} // namespace flattening
