// SPDX-License-Identifier: GPL-3.0-or-later
/// Exact distances and shortest paths along a surface of triangles.
#pragma once

#include "Geodesics/UnfoldableFaces.h"
#include "Geodesics/WindowBucket.h"

#include <functional>
#include <utility>
#include <vector>

namespace flattening
{

/// A vertex that a search has reached.
struct ReachedVertex
{
  int Vertex;
  double Distance; ///< from the source, input units
};

/// A place or a point of a half-edge where a path passes.
struct PathCrossing
{
  int Place;             ///< -1 between the ends of a half-edge
  int Halfedge = -1;     ///< -1 at a place
  double Fraction = 0.0; ///< share of the way from the half-edge's begin to its end, in (0, 1)
};

/// Whether a search keeps what its paths are made of, about a hundred bytes per face.
enum class Paths
{
  Dropped, ///< it finds distances alone
  Kept     ///< pathFrom() may be called
};

/// The exact geodesic distances from one vertex after the other of a surface of triangles: the lengths
/// of the shortest paths over its faces. The search propagates windows, the intervals of edges that
/// straight lines from one point reach (Chen, Han 1990, "Shortest paths on a polyhedron"), in buckets by
/// distance (Xu, Wang, Liu, Liu, He 2015, "Fast wavefront propagation (FWP) for computing exact geodesic
/// distances on meshes"). It drops windows that a path through a vertex beats (Xin, Wang 2009,
/// "Improving Chen and Han's algorithm on the discrete geodesic problem").
///
/// CGAL's Surface_mesh_shortest_path is not used: it cannot end at a distance and cannot close seams,
/// and that of CGAL 5.5 crashes where a loop of edges is so short that a path does not grow by it in
/// double precision. Here a distance is only replaced by a smaller one, so that no path can end its
/// own beginning.
class GeodesicSearch
{
public:
  /// Called during a search, in its thread, at the latest after some thousandths of a second. An
  /// exception of it ends the search.
  using Checkpoint = std::function<void()>;

  /// Several searches may share the @p faces, each in its own thread; the faces must outlive them.
  explicit GeodesicSearch(const UnfoldableFaces& faces, Paths paths = Paths::Dropped);

  /// The vertices no farther than @p limit (input units; may be infinite) from vertex @p source, in
  /// ascending order, itself among them.
  std::vector<ReachedVertex> within(double limit, int source, const Checkpoint& checkpoint = {});

  /// The distances of @p targets from vertex @p source, in their order (input units); infinite where no
  /// path leads.
  std::vector<double> to(const std::vector<int>& targets, int source, const Checkpoint& checkpoint = {});

  /// The shortest path from vertex @p target, which the last search has reached, back to its source,
  /// both ends included; consecutive crossings lie on one face. Only for a search that keeps paths.
  std::vector<PathCrossing> pathFrom(int target) const;

private:
  using Window = GeodesicWindow;

  // A half-edge that the lines of a window cross, and the number of the trail of those before; -1 if
  // there are none.
  struct Trail
  {
    int Halfedge;
    int Before;
  };
  // How the shortest path so far comes to a place: along an edge from another place, or in a straight
  // line over faces.
  struct Arrival
  {
    int Origin;            // the place before
    int Trail = -1;        // of the half-edges that the line crosses; -1 along an edge
    double Position = 0.0; // where it crosses the last one
    double X = 0.0;        // of the image of the place before, in the plane of the last half-edge's face
    double Y = 0.0;
  };
  // The best window so far that saw the apex of a half-edge's face.
  struct ApexView
  {
    double Distance;
    double Crossing; // where the straight line to the apex crosses the half-edge
  };

  void start(int source, double limit);
  // Processes the next bucket. Returns false if none is left.
  bool advance(const Checkpoint& checkpoint);
  void lower(int place, double distance, const Arrival& arrival);
  void spreadFrom(int place);
  void enterFace(const Window& window);
  void splitAtApex(const Window& window, double crossing, double distance);
  void pushLeft(const Window& window, double begin, double end);
  void pushRight(const Window& window, double begin, double end);
  void push(Window window);
  bool isBeaten(const Window& window) const;
  std::size_t bucketOf(double distance) const;
  void appendLine(const Arrival& arrival, std::vector<PathCrossing>& path) const;

  const UnfoldableFaces& Faces;
  const Paths KeptPaths;
  double Width; // of a bucket
  double Limit = 0.0;
  std::size_t Current = 0;
  std::vector<WindowBucket> Buckets;
  std::vector<double> Distances; // of the places; infinite where not reached
  std::vector<Arrival> Arrivals; // at the places that are reached
  std::vector<int> ReachedPlaces;
  std::vector<Trail> Trails;   // empty if paths are not kept
  std::vector<ApexView> Views; // by half-edge
  std::vector<int> ViewedHalfedges;
};

} // namespace flattening
