// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/MapByTransport.h"

#include "Areas/FaceRefinement.h"
#include "Areas/WarmStart.h"
#include "Base/EigenVersions.h"
#include "Mesh/FaceOrientation.h"
#include "Transport/BoundaryPlacement.h"
#include "Transport/TransportInterpolation.h"
#include "Transport/TransportSites.h"
#include "Untangling/ConformalFactors.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// A mesh has at least so many sites, or a site per vertex: groups are for large meshes, small ones take
// no time. With fewer sites the interpolation between them gets coarse.
constexpr int LeastSites = 1000;

// Gives each corner of the domain the boundary vertex whose cell contains it.
void chooseCorners(BoundaryLoop& boundary,
  const PowerDiagram& diagram,
  const std::vector<int>& siteOfVertex)
{
  std::vector<int>& corners = boundary.Corners;
  std::vector<double>& parameters = boundary.CornerParameters;
  corners = cornerMembers(diagram, boundary.Vertices, siteOfVertex, parameters);
  // The corner of the loop's first member comes first.
  const auto first = std::min_element(corners.begin(), corners.end());
  const auto before = first - corners.begin();
  std::for_each(parameters.begin(),
    parameters.begin() + before,
    [turn = diagram.domain().perimeter()](double& parameter) { parameter += turn; });
  std::rotate(parameters.begin(), parameters.begin() + before, parameters.end());
  std::rotate(corners.begin(), first, corners.end());
}

// One surface on its way to its area-preserving map; each step is a stage of make().
class MapMaker
{
public:
  MapMaker(const MapProblem& problem, const MapStart& start)
    : Mesh(problem.Mesh)
    , Conformal(start.Conformal)
    , OnDomain(start.OnDomain)
    , Domain(problem.Target.Domain)
    , Boundary(problem.Target.Boundary)
    , Weights(problem.Weights)
    , Options(problem.Options)
  {
  }

  AreaPreservingResult make(const ProgressCallback& progress)
  {
    const double transportEnd = this->Options.RefineFaces ? 0.5 : 0.95;
    this->transportSites(subrange(progress, 0.0, transportEnd));
    if (!this->startWarm())
    {
      this->startFromTransport();
    }
    this->countFlipped();
    this->Map.OnDomain = this->Map.Positions;
    if (this->Options.RefineFaces)
    {
      this->refine(subrange(progress, transportEnd + 0.02, 1.0));
    }
    return this->made(progress);
  }

  AreaPreservingResult makeTransported(const ProgressCallback& progress)
  {
    this->transportSites(subrange(progress, 0.0, 0.95));
    this->startFromTransport();
    this->countFlipped();
    this->Map.OnDomain = this->Map.Positions;
    return this->made(progress);
  }

private:
  void transportSites(const ProgressCallback& progress)
  {
    this->chooseSites();
    this->transport(progress);
    report(progress, 1.0, "Flat positions");
    this->measureCells();
    this->placeSites();
  }

  AreaPreservingResult made(const ProgressCallback& progress)
  {
    report(progress, 1.0, "Area-preserving map");
    return { std::move(this->Map), std::move(*this->Diagram), std::move(this->Sites.SiteOfVertex) };
  }

  void chooseSites()
  {
    const int n = this->Mesh.vertexCount();
    this->Map.TargetAreas = targetAreas(this->Mesh, this->Weights);
    this->Sites = distinctSites(this->Conformal);
    this->Map.CoincidentVertices = n - this->Sites.count();
    const int perSite = this->verticesPerSite();
    if (perSite > 1)
    {
      // Groups by areas without weights: the sites stay where they are when weights change.
      this->Sites = groupedSites(this->Conformal,
        targetAreas(this->Mesh, {}),
        logConformalFactors(this->Mesh, this->Conformal),
        this->Boundary.Vertices,
        perSite);
    }
    this->Map.Sites = this->Sites.count();
    this->SiteTargets = this->Sites.sums(this->Map.TargetAreas);
  }

  // At most as many as leave LeastSites.
  int verticesPerSite() const
  {
    return this->Options.RefineFaces
             ? std::clamp(
                 this->Mesh.vertexCount() / LeastSites, 1, std::max(1, this->Options.VerticesPerSite))
             : 1;
  }

  void transport(const ProgressCallback& progress)
  {
    this->Diagram.emplace(this->Sites.Positions, this->Domain);
    const TransportResult transport = transportNewton(*this->Diagram,
      this->SiteTargets,
      this->Options.Transport,
      progress,
      this->Options.Start.weightsOf(this->Sites));
    this->SiteWeights = transport.Weights.cast<double>();
    this->Map.NewtonIterations = transport.NewtonIterations;
    this->Map.PowerDiagrams = this->Diagram->updates();
    this->Map.MaxCellError = transport.MaxCellError;
  }

  void measureCells()
  {
    const int n = this->Mesh.vertexCount();
    this->Map.CellAreas.resize(n);
    this->Map.PowerWeights.resize(n);
    for (int v = 0; v < n; ++v)
    {
      const int site = this->Sites.SiteOfVertex[v];
      this->Map.CellAreas[v] =
        this->Diagram->areas()[site] * (this->Map.TargetAreas[v] / this->SiteTargets[site]);
      this->Map.PowerWeights[v] = this->SiteWeights[site];
    }
  }

  // Sites go to the centroids of their cells, boundary vertices to the boundary.
  void placeSites()
  {
    if (this->Boundary.Corners.size() < this->Boundary.CornerParameters.size())
    {
      chooseCorners(this->Boundary, *this->Diagram, this->Sites.SiteOfVertex);
    }
    for (const int corner : this->Boundary.Corners)
    {
      this->Map.CornerVertices.push_back(this->Boundary.Vertices[corner]);
    }
    this->Images = siteImages(*this->Diagram, this->SiteTargets, this->Sites, this->Boundary);
  }

  // The angle weight of an earlier map is not known, and so only maps without one are gone on from.
  bool startWarm()
  {
    if (!this->Options.RefineFaces || this->Options.Refinement.AngleWeight > 0.0)
    {
      return false;
    }
    std::optional<Points2> warm = warmPositions(
      this->Options.Start, this->Mesh.Faces, this->Sites, *this->Diagram, this->Images, this->Boundary);
    this->Map.WarmStarted = warm.has_value();
    if (warm)
    {
      this->Map.Positions = std::move(*warm);
    }
    return this->Map.WarmStarted;
  }

  void startFromTransport()
  {
    this->Map.Positions =
      this->Options.RefineFaces
        ? interpolateTransport(this->Sites, this->Images, this->Conformal, *this->Domain)
        : Points2(this->Diagram->centroids()(this->Sites.SiteOfVertex, flattening::all));
    for (std::size_t k = 0; k < this->Boundary.Vertices.size(); ++k)
    {
      this->Map.Positions.row(this->Boundary.Vertices[k]) =
        this->Domain->at(this->Images.BoundaryParameters[k]);
    }
  }

  void countFlipped()
  {
    this->Map.FlippedFaces = countFlippedFaces(this->Map.Positions, this->Mesh.Faces);
    this->Map.Bijective = this->Map.FlippedFaces == 0; // boundaryParameters() are in order
  }

  void refine(const ProgressCallback& progress)
  {
    const TransportedMap transported{ this->Domain,
      this->Boundary.Vertices,
      this->Boundary.Corners,
      this->Conformal,
      this->Map.Positions,
      this->OnDomain,
      this->Map.WarmStarted ? RefinementStart::WarmStart : RefinementStart::Transport };
    FaceRefinementResult refined = refineFaces(this->Mesh,
      transported,
      faceTargets(this->Mesh, this->Weights),
      this->Options.Refinement,
      progress);
    this->Map.Positions = std::move(refined.Positions);
    this->Map.FlippedFaces = refined.FlippedFaces;
    this->Map.Bijective = refined.Bijective;
    this->Map.RefinementRounds = refined.Rounds;
    this->Map.RepairedFaces = refined.RepairedFaces;
    this->Map.StartShare = refined.StartShare;
    this->Map.OnDomain = this->Map.Positions;
  }

  const TriangleMesh& Mesh;
  const Points2& Conformal;
  const Points2& OnDomain;
  std::shared_ptr<const ConvexDomain> Domain;
  BoundaryLoop Boundary;
  const Eigen::VectorXd& Weights;
  const AreaPreservingOptions& Options;

  TransportSites Sites;
  Eigen::VectorXd SiteTargets;
  std::optional<PowerDiagram> Diagram;
  Eigen::VectorXd SiteWeights;
  SiteImages Images;
  AreaPreservingMap Map;
};

} // namespace

AreaPreservingResult mapByTransport(const MapProblem& problem,
  const MapStart& start,
  const ProgressCallback& progress)
{
  return MapMaker(problem, start).make(progress);
}

AreaPreservingResult transportedMap(const MapProblem& problem,
  const Points2& start,
  const ProgressCallback& progress)
{
  return MapMaker(problem, { start, start }).makeTransported(progress);
}

} // namespace flattening
