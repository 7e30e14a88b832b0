// SPDX-License-Identifier: GPL-3.0-or-later
/// Exact distances along a surface of triangles.
#pragma once

#include "Geodesics/UnfoldableFaces.h"

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

/// The exact geodesic distances from one vertex after the other of a surface of triangles: the lengths
/// of the shortest paths over its faces. The search propagates windows, the intervals of edges that
/// straight lines from one point reach (Chen, Han 1990, "Shortest paths on a polyhedron"), in buckets by
/// distance (Xu, Wang, Liu, Liu, He 2015, "Fast wavefront propagation (FWP) for computing exact geodesic
/// distances on meshes"). It drops windows that a path through a vertex beats (Xin, Wang 2009,
/// "Improving Chen and Han's algorithm on the discrete geodesic problem").
///
/// CGAL's Surface_mesh_shortest_path, which geodesicPath() uses, does not end at a distance and cannot
/// close seams.
class GeodesicSearch
{
public:
  /// Called now and then during a search, in its thread. An exception of it ends the search.
  using Checkpoint = std::function<void()>;

  /// Several searches may share the @p faces, each in its own thread; the faces must outlive them.
  explicit GeodesicSearch(const UnfoldableFaces& faces);

  /// The vertices no farther than @p limit (input units; may be infinite) from vertex @p source, in
  /// ascending order, itself among them.
  std::vector<ReachedVertex> within(double limit, int source, const Checkpoint& checkpoint = {});

  /// The distances of @p targets from vertex @p source, in their order (input units); infinite where no
  /// path leads.
  std::vector<double> to(const std::vector<int>& targets, int source, const Checkpoint& checkpoint = {});

private:
  // The interval of a half-edge that straight lines from one point reach before they enter its face.
  // The point lies below the half-edge in the plane of the face (see PlanarSide).
  struct Window
  {
    int Halfedge;
    double Begin; // along the half-edge
    double End;
    double X; // of the point
    double Y;
    double Before; // distance of the point from the source

    double distanceAt(double position) const;
    double nearest() const;
  };
  struct PlaceEvent
  {
    int Place;
    double Distance;
  };
  // A bucket holds windows and places that are processed together: their distances differ by less than
  // its width.
  struct Bucket
  {
    std::vector<Window> Windows;
    std::vector<PlaceEvent> Places;
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
  void lower(int place, double distance);
  void spreadFrom(int place);
  void enterFace(const Window& window);
  bool isFirstAtApex(const Window& window, double crossing, double distance);
  void pushLeft(const Window& window, double begin, double end);
  void pushRight(const Window& window, double begin, double end);
  void push(const Window& window);
  bool isBeaten(const Window& window) const;
  std::size_t bucketOf(double distance) const;

  const UnfoldableFaces& Faces;
  double Width; // of a bucket
  double Limit = 0.0;
  std::size_t Current = 0;
  std::vector<Bucket> Buckets;
  std::vector<double> Distances; // of the places; infinite where not reached
  std::vector<int> ReachedPlaces;
  std::vector<ApexView> Views; // by half-edge
  std::vector<int> ViewedHalfedges;
};

} // namespace flattening
