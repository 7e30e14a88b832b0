// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SurfacePick.h"

#include "Base/Errors.h"

#include <sstream>

namespace flattening
{
namespace
{

// A convention: picked points lie on the surface up to the rounding of the display, and points meant for
// another surface lie much farther off. The message below names the same 5 %.
constexpr double GreatestShareOfDiagonal = 0.05;

} // namespace

double boxDiagonal(const TriangleMesh& mesh)
{
  return (mesh.Vertices.colwise().maxCoeff() - mesh.Vertices.colwise().minCoeff()).norm();
}

SurfacePoint pickOnSurface(const ClosestPointTree& surface,
  double diagonal,
  const Eigen::Vector3d& picked,
  const std::string& what)
{
  if (!picked.allFinite())
  {
    throw InvalidInput(what + " is not finite: set all of its coordinates");
  }
  const SurfacePoint nearest = surface.closest(picked);
  const double distance = (nearest.Position - picked).norm();
  if (!(distance <= GreatestShareOfDiagonal * diagonal))
  {
    std::ostringstream message;
    message << what << " (" << picked.transpose() << ") lies " << distance
            << " off the surface, more than 5 % of its size (" << diagonal
            << "): pick a point on the surface (in ParaView, press P with the mouse over it)";
    throw InvalidInput(message.str());
  }
  return nearest;
}

} // namespace flattening
