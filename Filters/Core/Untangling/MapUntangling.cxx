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

// Work for patches that stay flipped, in Newton steps times free vertices, that is allowed even for the
// smallest map: a guard, a fraction of a second. With less, small maps are given up too early.
constexpr double LeastWork = 5e4;
// Most sweeps over all flipped faces in which single vertices move: a guard, for sweeps end as soon as
// one does not help.
constexpr int MostSweeps = 10;
// Faces of a sweep from one report to the next: a choice. A face takes a ten-thousandth of a second at
// most.
constexpr std::size_t SweptFacesPerReport = 256;

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

// Moves single vertices, in sweeps over the flipped faces, as long as that untangles more faces.
void moveSingleVertices(UntanglingMesh& mesh, const ProgressCallback& progress)
{
  std::size_t seen = 0;
  const auto isUntangled = [&](int f)
  {
    if (seen++ % SweptFacesPerReport == 0)
    {
      report(progress, 0.0, UntanglingStage);
    }
    return mesh.safelyPositive(f) || untangleByOneVertex(mesh, f);
  };
  std::vector<int> flipped = flippedFaces(mesh);
  std::size_t before = flipped.size() + 1;
  for (int sweep = 0; sweep < MostSweeps && flipped.size() < before; ++sweep)
  {
    before = flipped.size();
    flipped.erase(std::remove_if(flipped.begin(), flipped.end(), isUntangled), flipped.end());
  }
}

class PatchwiseUntangling
{
public:
  PatchwiseUntangling(UntanglingMesh& mesh, const UntanglingOptions& options)
    : Mesh(mesh)
    , Options(options)
    , WorkLeft(LeastWork + options.WorkPerVertex * mesh.Positions.rows())
    , Hopeless(mesh.Faces.rows(), 0)
  {
  }

  // Grows a patch around the face until it can be untangled, and tries after 0, 1, 2, 4, 8 ... rings.
  void untangleAround(int face, const ProgressCallback& progress)
  {
    if (this->Hopeless[face])
    {
      return;
    }
    UntanglingPatch patch(this->Mesh, face, this->Options.LargestPatch, progress);
    const std::vector<int> first = patch.faces();
    bool grows = true;
    for (int ring = 0, next = 0; grows && this->WorkLeft > 0.0 && this->isPromising(patch); ++ring)
    {
      if (ring == next)
      {
        next = std::max(1, 2 * ring);
        // Tutte's map is for parts that are inside out: from their positions in the map, the energy
        // would have to grow before it falls.
        if (this->untangle(patch, Start::Map, progress) || this->untangle(patch, Start::Tutte, progress))
        {
          return;
        }
      }
      grows = patch.grow();
    }
    while (grows && this->isPromising(patch))
    {
      grows = patch.grow();
    }
    // A patch that cannot grow has a rim of fixed vertices. If that is convex, as a piece of a circle
    // is, Tutte's map is a start without flipped faces.
    if (grows || !this->isPromising(patch) || !this->untangle(patch, Start::Tutte, progress))
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
    Map,  // the positions in the map
    Tutte // the means of neighbours with equal weights
  };

  bool isPromising(const UntanglingPatch& patch) const
  {
    const std::vector<int>& faces = patch.faces();
    return !patch.tooLarge() &&
           std::none_of(faces.begin(), faces.end(), [this](int f) { return this->Hopeless[f]; });
  }

  bool untangle(const UntanglingPatch& patch, Start start, const ProgressCallback& progress)
  {
    UntanglingPatch::Local local = patch.local();
    if (local.Frame.isZero(0.0))
    {
      return false;
    }
    if (start == Start::Tutte && local.Flat.FreeVertices < local.Flat.Positions.rows())
    {
      relaxPatch(local.Flat, progress);
    }
    const UntangledPatch result = untanglePatch(local.Flat, this->Options.AreaWeight, progress);
    if (result.Positive && this->moveIntoMap(patch, local))
    {
      return true;
    }
    this->WorkLeft -= static_cast<double>(result.Steps) * local.Flat.FreeVertices;
    return false;
  }

  // Gives the vertices their positions in the map, if all faces are positive after rounding.
  bool moveIntoMap(const UntanglingPatch& patch, const UntanglingPatch::Local& local)
  {
    Points2 positions =
      (local.Flat.Positions.topRows(local.Flat.FreeVertices) * local.Frame).rowwise() + local.Origin;
    this->swapPositions(patch, positions);
    const std::vector<int>& faces = patch.faces();
    const bool positive =
      std::all_of(faces.begin(), faces.end(), [this](int f) { return this->Mesh.safelyPositive(f); });
    if (!positive)
    {
      this->swapPositions(patch, positions);
    }
    return positive;
  }

  void swapPositions(const UntanglingPatch& patch, Points2& positions)
  {
    Eigen::Index row = 0;
    for (const int v : patch.vertices())
    {
      this->Mesh.Positions.row(v).swap(positions.row(row++));
    }
  }

  UntanglingMesh& Mesh;
  const UntanglingOptions& Options;
  double WorkLeft;            // that may still be in vain
  std::vector<char> Hopeless; // per face: 1 if no patch around it could be untangled
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
  const auto vertexCount = static_cast<int>(positions.rows());
  UntanglingMesh mesh{ faces, fixed, targets, positions, VertexFaces(faces, vertexCount) };
  moveSingleVertices(mesh, progress);
  PatchwiseUntangling patches(mesh, options);
  const std::vector<int> left = flippedFaces(mesh);
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    const double fraction = static_cast<double>(i) / left.size();
    report(progress, fraction, UntanglingStage);
    if (!mesh.safelyPositive(left[i]))
    {
      patches.untangleAround(left[i], atFraction(progress, fraction, UntanglingStage));
      // No other patch moves the vertices of a face that could not be untangled.
      if (options.AllOrNone && faceOrientation(positions, faces, left[i]) <= 0)
      {
        break;
      }
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
