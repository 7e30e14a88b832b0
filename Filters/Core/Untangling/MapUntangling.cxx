// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/MapUntangling.h"

#include "Mesh/FaceOrientation.h"
#include "Untangling/UntanglingPatch.h"
#include "Untangling/VertexUntangling.h"

#include <algorithm>

namespace flattening
{
namespace
{

// Newton steps times vertices, in vain, however small the map is.
constexpr double LeastWork = 5e4;
// Over all flipped faces, moving single vertices.
constexpr int LargestSweeps = 10;

std::vector<int> flippedFaces(const UntanglingMesh& mesh)
{
  std::vector<int> flipped;
  for (int f = 0; f < mesh.Faces.rows(); ++f)
  {
    if (!mesh.safelyPositive(f))
    {
      flipped.push_back(f);
    }
  }
  return flipped;
}

// Until no single vertex turns any more faces over, or nearly so.
void moveSingleVertices(UntanglingMesh& mesh)
{
  std::vector<int> flipped = flippedFaces(mesh);
  std::size_t left = flipped.size() + 1;
  for (int sweep = 0; sweep < LargestSweeps && flipped.size() < left; ++sweep)
  {
    left = flipped.size();
    std::vector<int> remaining;
    for (const int f : flipped)
    {
      if (!mesh.safelyPositive(f) && untangleByOneVertex(mesh, f) < 0)
      {
        remaining.push_back(f);
      }
    }
    flipped = remaining;
  }
}

class PatchRepairs
{
public:
  PatchRepairs(UntanglingMesh& mesh, const UntanglingOptions& options)
    : Mesh(mesh)
    , Options(options)
    , Work(LeastWork + options.WorkPerVertex * mesh.Positions.rows())
    , Hopeless(mesh.Faces.rows(), 0)
  {
  }

  // Grows a patch around the face by 1, 1, 2, 4 ... rings until it can be repaired.
  void repairAround(int face)
  {
    if (this->Hopeless[face])
    {
      return;
    }
    UntanglingPatch patch(this->Mesh, face, this->Options.LargestPatch);
    const std::vector<int> first = patch.faces();
    bool grows = true;
    for (int ring = 0, next = 0; grows && this->Work > 0.0 && this->promising(patch); ++ring)
    {
      if (ring == next)
      {
        next = std::max(1, 2 * ring);
        if (this->repair(patch, Start::AsItIs))
        {
          return;
        }
      }
      grows = patch.grow();
    }
    while (grows && this->promising(patch))
    {
      grows = patch.grow();
    }
    // All of the rim is fixed in the map then, as the vertices of a circle are.
    if (grows || !this->promising(patch) || !this->repair(patch, Start::Relaxed))
    {
      for (const int f : first)
      {
        this->Hopeless[f] = !this->Mesh.safelyPositive(f);
      }
    }
  }

private:
  enum class Start
  {
    AsItIs,
    Relaxed
  };

  bool promising(const UntanglingPatch& patch) const
  {
    const std::vector<int>& faces = patch.faces();
    return !patch.tooLarge() &&
           std::none_of(faces.begin(), faces.end(), [this](int f) { return this->Hopeless[f]; });
  }

  bool repair(const UntanglingPatch& patch, Start start)
  {
    UntanglingPatch::Local local = patch.local();
    if (local.Frame.isZero(0.0))
    {
      return false;
    }
    if (start == Start::Relaxed && local.Flat.FreeVertices < local.Flat.Positions.rows())
    {
      relaxPatch(local.Flat);
    }
    const UntangledPatch result = untanglePatch(local.Flat, this->Options.AreaWeight);
    if (result.Positive && this->place(patch, local))
    {
      return true;
    }
    this->Work -= static_cast<double>(result.Steps) * local.Flat.FreeVertices;
    return false;
  }

  // Gives the vertices their places in the map, rounded, if all faces are positive there.
  bool place(const UntanglingPatch& patch, const UntanglingPatch::Local& local)
  {
    Points2 places =
      (local.Flat.Positions.topRows(local.Flat.FreeVertices) * local.Frame).rowwise() + local.Origin;
    this->swap(patch, places);
    const std::vector<int>& faces = patch.faces();
    const bool positive =
      std::all_of(faces.begin(), faces.end(), [this](int f) { return this->Mesh.safelyPositive(f); });
    if (!positive)
    {
      this->swap(patch, places);
    }
    return positive;
  }

  void swap(const UntanglingPatch& patch, Points2& places)
  {
    Eigen::Index row = 0;
    for (const int v : patch.vertices())
    {
      this->Mesh.Positions.row(v).swap(places.row(row++));
    }
  }

  UntanglingMesh& Mesh;
  const UntanglingOptions& Options;
  double Work;                // that may still be in vain
  std::vector<char> Hopeless; // per face: 1 if no patch around it could be repaired
};

} // namespace

UntanglingReport untangleMap(const FaceMatrix& faces,
  const std::vector<char>& fixed,
  const TargetTriangles& targets,
  Points2& positions,
  const UntanglingOptions& options,
  const ProgressCallback& progress)
{
  UntanglingReport result;
  const int before = countFlippedFaces(positions, faces);
  const Points2 old = positions;
  UntanglingMesh mesh(faces, fixed, targets, positions);
  moveSingleVertices(mesh);
  PatchRepairs repairs(mesh, options);
  const std::vector<int> left = flippedFaces(mesh);
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    report(progress, static_cast<double>(i) / left.size(), "Repair of flipped faces");
    if (!mesh.safelyPositive(left[i]))
    {
      repairs.repairAround(left[i]);
    }
  }
  result.FlippedFaces = countFlippedFaces(positions, faces);
  result.RepairedFaces = before - result.FlippedFaces;
  for (int v = 0; v < positions.rows(); ++v)
  {
    const double move = (positions.row(v) - old.row(v)).norm();
    if (move > 0.0)
    {
      ++result.MovedVertices;
      result.GreatestMove = std::max(result.GreatestMove, move / mesh.edgeLengthAt(v));
    }
  }
  return result;
}

UntanglingReport untangleMap(const TriangleMesh& surface,
  const std::vector<int>& fixed,
  Points2& positions,
  const ProgressCallback& progress)
{
  std::vector<char> isFixed(surface.vertexCount(), 0);
  for (const int v : fixed)
  {
    isFixed[v] = 1;
  }
  return untangleMap(
    surface.Faces, isFixed, similarTriangles(surface, positions), positions, {}, progress);
}

} // namespace flattening
