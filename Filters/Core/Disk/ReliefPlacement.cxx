// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/ReliefPlacement.h"

#include "Base/Errors.h"
#include "Disk/ConformalStrain.h"
#include "Disk/SeamFlags.h"
#include "Geodesics/DijkstraDistance.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/IsotropicRemeshing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Vertex = SurfaceMesh::Vertex_index;

// The number of faces of the coarse copy. A convention: tips move by less than two edges of it if it has
// twice as many, and folds that it does not resolve have no influence on where a cut helps.
constexpr int CoarseFaces = 6000;
constexpr int CoarseningRounds = 3; // a convention, as where surfaces are remeshed for their own sake
// The number of peaks that are tried for each branch. A convention between time and distortion: where
// folds are many, the eight highest peaks often lie in one fold that a single branch cannot open, and
// with 24 a relief of the same length leaves up to a third less strain. More help little.
constexpr int Candidates = 24;
// The length by which each branch counts as longer than it is, in square roots of the surface's area. A
// convention: without it, a relief of the same strain has twice as many branches, most of them shorter
// than this and of no use; with twice as much, folds beside a branch stay uncut.
constexpr double BranchAllowance = 0.05;
// The distance that the branches keep from the region to be avoided, where there is room, in square
// roots of the surface's area. As for a seam (SeamPlacement.cxx).
constexpr double ReliefClearance = 0.02;

// The mean distance between branches, in edges of the surface, and the length of a relief that may have
// less, in square roots of the surface's area. Measured with a free outline and a gain of 0.02 on 43
// generated surfaces of some hundred or thousand vertices: 99.65 % of the faces are within 2 % with 10
// edges and 98.9 % with 8; where the length does not count, the angle error is 22 degrees instead of 14.
// Such a length suits a disk, too.
constexpr double RoomBetweenBranches = 10.0;
constexpr double AlwaysAllowed = 2.66;

constexpr const char* PlacementStage = "Placing the relief";

struct Branch
{
  std::vector<int> Path; // from the tip to the outline
  double Length = 0.0;
};

// The relief after one of its branches.
struct Stage
{
  std::size_t Tips;
  double Strain;
  double Cost; // the strain and the price of the length
};

// The coarse copy, and the branches placed on it.
class ReliefPlacer
{
public:
  ReliefPlacer(const DerivedMesh& coarse, const std::vector<char>& avoided, const ReliefOptions& options)
    : Coarse(coarse.Mesh)
    , Options(options)
    , Strain(coarse.Mesh)
    , Surface(toSurfaceMesh(coarse.Mesh))
    , Unit(std::sqrt(faceAreas(coarse.Mesh.Vertices, coarse.Mesh.Faces).sum()))
  {
    this->DistanceFromAvoided = distancesFromFlagged(
      this->Surface, avoided.empty() ? avoided : flagsOf(coarse.Vertices, avoided, false));
  }

  PlacedRelief place(const ProgressCallback& progress)
  {
    this->Outline.assign(this->Coarse.vertexCount(), 0);
    const auto loops = analyseTopology(this->Coarse.Faces, this->Coarse.vertexCount()).BoundaryLoops;
    for (const std::vector<int>& loop : loops)
    {
      for (const int v : loop)
      {
        this->Outline[v] = 1;
      }
    }
    report(progress, 0.0, PlacementStage);
    PlacedRelief relief;
    if (loops.empty())
    {
      if (!this->openClosed(relief, progress))
      {
        return relief;
      }
    }
    else
    {
      this->block(ReliefClearance);
      this->update(atFraction(progress, 0.0, PlacementStage));
      relief.StrainBefore = this->PresentStrain;
      if (this->PresentStrain < this->Options.LeastStrain)
      {
        relief.StrainAfter = this->PresentStrain;
        return relief;
      }
    }
    this->addBranches(relief, progress);
    report(progress, 1.0, PlacementStage);
    return relief;
  }

private:
  // Vertices at most so far from the region are closed to branches.
  void block(double clearance)
  {
    this->Blocked.resize(this->Coarse.vertexCount());
    for (int v = 0; v < this->Coarse.vertexCount(); ++v)
    {
      this->Blocked[v] = this->DistanceFromAvoided[v] <= clearance * this->Unit;
    }
  }

  // Cuts the first branch of a closed surface, between two peaks that are free. Returns whether there is
  // room for it.
  bool openClosed(PlacedRelief& relief, const ProgressCallback& progress)
  {
    for (const double clearance : { ReliefClearance, 0.5 * ReliefClearance, 0.0 })
    {
      this->block(clearance);
      int root = indexOfLargest(this->DistanceFromAvoided);
      if (this->Blocked[root])
      {
        continue;
      }
      this->openAt(root, progress);
      if (const int tip = this->highestReached(root); tip >= 0)
      {
        root = tip;
        this->openAt(root, progress);
      }
      const int tip = this->highestReached(root);
      if (tip < 0)
      {
        continue;
      }
      relief.StrainBefore = this->PresentStrain;
      relief.Tips.emplace_back(this->Coarse.Vertices.row(root));
      this->keep(this->branchTo(tip, this->distances()), relief, progress);
      return true;
    }
    return false;
  }

  void openAt(int root, const ProgressCallback& progress)
  {
    std::fill(this->Outline.begin(), this->Outline.end(), 0);
    this->Outline[root] = 1;
    this->update(atFraction(progress, 0.0, PlacementStage));
  }

  // The vertex of the greatest factor to which a free path leads; -1 if there is none.
  int highestReached(int root) const
  {
    const Eigen::VectorXd distance = this->distances();
    const Eigen::VectorXd height =
      distance.array().isFinite().select(this->Strain.conformalFactors().cwiseAbs().array(), -1.0);
    const int highest = indexOfLargest(height);
    return height[highest] >= 0.0 && highest != root ? highest : -1;
  }

  void update(const ProgressCallback& progress)
  {
    this->Strain.open(this->Outline, progress);
    this->PresentStrain = this->Strain.strain();
  }

  // Distances from the outline along free edges.
  Eigen::VectorXd distances() const
  {
    std::vector<Vertex> sources;
    for (int v = 0; v < this->Coarse.vertexCount(); ++v)
    {
      if (this->Outline[v])
      {
        sources.emplace_back(v);
      }
    }
    return distancesAlongEdges(this->Surface, sources, this->Blocked);
  }

  // What the relief costs by its length, in strain.
  double price() const { return this->Options.Gain * this->CountedLength / this->Unit; }
  double cost() const { return this->PresentStrain + this->price(); }

  // Adds branches, and takes back those after the stage at which strain and price together were least,
  // but for the slack.
  // To stop at the first branch that is not worth its length would leave folds of one depth uncut, of
  // which several have to be cut before the strain falls.
  void addBranches(PlacedRelief& relief, const ProgressCallback& progress)
  {
    double leastCost = this->cost();
    std::vector<Stage> stages{ { relief.Tips.size(), this->PresentStrain, leastCost } };
    // A relief whose price alone is as high cannot be better, as strain is not negative.
    while (this->price() < leastCost)
    {
      const double done =
        std::max(this->price() / leastCost, this->Length / (this->Options.Longest * this->Unit));
      const ProgressCallback still =
        atFraction(progress, std::min(0.1 + 0.9 * done, 1.0), PlacementStage);
      const Branch branch = this->bestBranch(still);
      if (branch.Path.empty())
      {
        break;
      }
      this->keep(branch, relief, still);
      leastCost = std::min(leastCost, this->cost());
      stages.push_back({ relief.Tips.size(), this->PresentStrain, this->cost() });
    }
    const double bound = (1.0 + this->Options.Slack) * leastCost;
    const auto taken = std::find_if(
      stages.begin(), stages.end(), [bound](const Stage& stage) { return stage.Cost <= bound; });
    relief.StrainAfter = taken->Strain;
    relief.Tips.resize(taken->Tips);
  }

  // The branch that lowers the strain most for its length, of those that keep the bound on the length of
  // all branches; without a path if there is none.
  Branch bestBranch(const ProgressCallback& progress)
  {
    const Eigen::VectorXd distance = this->distances();
    std::vector<Branch> branches;
    for (const int tip : this->peaks(distance))
    {
      if (this->Length + distance[tip] <= this->Options.Longest * this->Unit)
      {
        branches.push_back(this->branchTo(tip, distance));
      }
    }
    report(progress, 0.0, PlacementStage);
    std::vector<std::vector<int>> paths;
    for (const Branch& branch : branches)
    {
      paths.push_back(branch.Path);
    }
    const std::vector<double> strains = this->Strain.strainsWith(paths);
    Branch best;
    double bestGain = -HUGE_VAL;
    for (std::size_t i = 0; i < branches.size(); ++i)
    {
      const double gain = (this->PresentStrain - strains[i]) / this->countedLength(branches[i]);
      if (gain > bestGain)
      {
        bestGain = gain;
        best = std::move(branches[i]);
      }
    }
    return best;
  }

  double countedLength(const Branch& branch) const
  {
    return branch.Length + BranchAllowance * this->Unit;
  }

  // The greatest of the peaks of the factors to which a free path leads.
  std::vector<int> peaks(const Eigen::VectorXd& distance) const
  {
    const Eigen::VectorXd height = this->Strain.conformalFactors().cwiseAbs();
    std::vector<int> peaks;
    for (const Vertex v : this->Surface.vertices())
    {
      const auto isLower = [&](Vertex other)
      { return height[other] < height[v] || (height[other] == height[v] && v < other); };
      const auto around = this->Surface.vertices_around_target(this->Surface.halfedge(v));
      if (!this->Outline[v] && std::isfinite(distance[v]) &&
          std::all_of(around.begin(), around.end(), isLower))
      {
        peaks.push_back(static_cast<int>(v.idx()));
      }
    }
    std::stable_sort(
      peaks.begin(), peaks.end(), [&height](int a, int b) { return height[a] > height[b]; });
    peaks.resize(std::min<std::size_t>(peaks.size(), Candidates));
    return peaks;
  }

  // The shortest path of edges from the outline to the tip.
  Branch branchTo(int tip, const Eigen::VectorXd& distance) const
  {
    return { shortestPath(this->Surface, distance, Vertex(tip)), distance[tip] };
  }

  void keep(const Branch& branch, PlacedRelief& relief, const ProgressCallback& progress)
  {
    for (const int v : branch.Path)
    {
      this->Outline[v] = 1;
    }
    this->Length += branch.Length;
    this->CountedLength += this->countedLength(branch);
    relief.Tips.emplace_back(this->Coarse.Vertices.row(branch.Path.front()));
    this->update(progress);
  }

  const TriangleMesh& Coarse;
  const ReliefOptions& Options;
  ConformalStrain Strain;
  const SurfaceMesh Surface;
  const double Unit;                   // the square root of the area
  Eigen::VectorXd DistanceFromAvoided; // infinite if there is no region
  std::vector<char> Blocked;           // per vertex: whether no branch may run there
  std::vector<char> Outline;           // per vertex: whether it is on the boundary or a branch
  double PresentStrain = 0.0;          // of the surface cut open along the outline
  double Length = 0.0;                 // of all branches
  double CountedLength = 0.0;          // the same, with what is added to each branch
};

// The edge of equilateral triangles of which so many have the area.
double edgeOf(int faces, double area)
{
  return std::sqrt(4.0 / std::sqrt(3.0) * area / faces);
}

// A copy with equilateral triangles, or the mesh itself if it is as coarse.
DerivedMesh coarseCopy(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  if (mesh.faceCount() <= 2 * CoarseFaces)
  {
    return derivedFromItself(mesh);
  }
  const double area = faceAreas(mesh.Vertices, mesh.Faces).sum();
  return remeshIsotropically(mesh, edgeOf(CoarseFaces, area), CoarseningRounds, progress);
}

void requireNotNegative(double value, const char* what)
{
  if (!(value >= 0.0))
  {
    throw InvalidInput(
      std::string(what) + " is " + formatted(value) + ": set it to 0 or a positive number");
  }
}

void requireValid(const TriangleMesh& mesh,
  const std::vector<char>& avoided,
  const ReliefOptions& options)
{
  requireNotNegative(options.Gain, "the gain of a relief's branch");
  requireNotNegative(options.Slack, "the slack of a relief");
  requireNotNegative(options.LeastStrain, "the least strain for a relief");
  if (!(options.Longest > 0.0))
  {
    throw InvalidInput("the longest relief is " + formatted(options.Longest) +
                       ": set it above 0, in square roots of the area");
  }
  if (!avoided.empty() && avoided.size() != static_cast<std::size_t>(mesh.vertexCount()))
  {
    throw InvalidInput("the region that the relief must avoid has " + std::to_string(avoided.size()) +
                       " flags, but the surface has " + std::to_string(mesh.vertexCount()) +
                       " vertices: pass one flag per vertex");
  }
  if (!avoided.empty() && std::find(avoided.begin(), avoided.end(), 0) == avoided.end())
  {
    throw InvalidInput("the region that the relief must avoid covers all of the surface: mark a part of "
                       "it");
  }
}

} // namespace

PlacedRelief placeRelief(const TriangleMesh& mesh,
  const std::vector<char>& avoided,
  const ReliefOptions& options,
  const ProgressCallback& progress)
{
  requireValid(mesh, avoided, options);
  ReliefOptions bounded = options;
  const double withRoom = 1.0 / (RoomBetweenBranches * edgeOf(mesh.faceCount(), 1.0));
  bounded.Longest = std::min(options.Longest, std::max(withRoom, AlwaysAllowed));
  const DerivedMesh coarse = coarseCopy(mesh, subrange(progress, 0.0, 0.5));
  return ReliefPlacer(coarse, avoided, bounded).place(subrange(progress, 0.5, 1.0));
}

} // namespace flattening
