// SPDX-License-Identifier: GPL-3.0-or-later
/// The rounds of isotropic remeshing.
#pragma once

#include "Base/Progress.h"
#include "Remeshing/MeshOnSurface.h"

#include <cstddef>

namespace flattening
{

/// How many vertices splitting may make on the way.
struct VertexLimit
{
  std::size_t Most;   ///< of the whole surface, as the message says it
  double Share = 1.0; ///< the part of them that this mesh may have
};

/// Changes a mesh by the operations of Botsch, Kobbelt 2004, "A remeshing approach to multiresolution
/// modeling".
class IsotropicRemesher
{
public:
  /// @param length  that the edges should have, input units
  IsotropicRemesher(MeshOnSurface& surface, double length, const VertexLimit& limit)
    : Surface(surface)
    , Length(length)
    , Limit(limit)
  {
  }

  /// One round of collapses, splits, flips and relaxation. @throws InvalidInput if there are too many
  /// vertices.
  void iterate(const ProgressCallback& progress);

  /// Flips edges until hardly any is left whose opposite angles are more than 180 degrees together.
  void flipToDelaunay(const ProgressCallback& progress);

  /// Admits flips that keep the surface nearly as it is.
  MeshOnSurface::Guard keepsSurface() const;

  /// Whether a change leaves no face steep against the old surface or with a small angle, unless such a
  /// face was there before.
  static bool staysSound(const LocalChange& change);

private:
  template <typename Order, typename IsWanted, typename Change>
  void changeEdges(IsWanted&& isWanted, Change&& change, const ProgressCallback& progress);
  bool isBesideLongerEdge(MeshOnSurface::Edge edge) const;
  void splitLongEdges(const ProgressCallback& progress);
  void collapseShortEdges(const ProgressCallback& progress);
  void relax(const ProgressCallback& progress);

  MeshOnSurface& Surface;
  double Length;
  VertexLimit Limit;
};

} // namespace flattening
