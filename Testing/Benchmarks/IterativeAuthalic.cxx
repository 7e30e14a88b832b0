// SPDX-License-Identifier: GPL-3.0-or-later
#include "IterativeAuthalic.h"

#include "Base/Errors.h"
#include "Mesh/MeshTopology.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>

#include <filesystem>
#include <iostream>
#include <string>

#include <unistd.h>

namespace flattening::benchmarks
{
namespace
{

// CGAL's parameterizer prints its progress and writes every iteration's map to a file in the working
// directory: while this lives, the directory is one of its own, and nothing is printed.
class QuietDirectory
{
public:
  QuietDirectory()
  {
    std::filesystem::create_directories(this->Own);
    std::filesystem::current_path(this->Own);
  }
  ~QuietDirectory()
  {
    std::error_code ignored;
    std::filesystem::current_path(this->Before, ignored);
    std::filesystem::remove_all(this->Own, ignored);
    std::cout.rdbuf(this->Printed);
    std::cout.clear();
  }
  QuietDirectory(const QuietDirectory&) = delete;
  QuietDirectory& operator=(const QuietDirectory&) = delete;

private:
  std::filesystem::path Before = std::filesystem::current_path();
  std::filesystem::path Own =
    std::filesystem::temp_directory_path() / ("iterative_authalic." + std::to_string(getpid()));
  std::streambuf* Printed = std::cout.rdbuf(nullptr);
};

} // namespace

Points2 iterativeAuthalicDiskMap(const TriangleMesh& mesh)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  namespace parameterization = CGAL::Surface_mesh_parameterization;

  requireDisk(mesh);
  Surface surface;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    surface.add_vertex(Kernel::Point_3(mesh.Vertices(v, 0), mesh.Vertices(v, 1), mesh.Vertices(v, 2)));
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    surface.add_face(Surface::Vertex_index(mesh.Faces(f, 0)),
      Surface::Vertex_index(mesh.Faces(f, 1)),
      Surface::Vertex_index(mesh.Faces(f, 2)));
  }
  const auto flat = surface.add_property_map<Surface::Vertex_index, Kernel::Point_2>("v:flat").first;
  const auto boundary = CGAL::Polygon_mesh_processing::longest_border(surface).first;
  parameterization::Iterative_authalic_parameterizer_3<Surface> parameterizer;
  const auto status = [&]
  {
    const QuietDirectory quiet;
    return parameterizer.parameterize(surface, boundary, flat);
  }();
  if (status != parameterization::OK)
  {
    throw ConvergenceError(parameterization::get_error_message(status));
  }
  Points2 positions(mesh.vertexCount(), 2);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Kernel::Point_2& p = flat[Surface::Vertex_index(v)];
    positions.row(v) << p.x(), p.y();
  }
  if (signedFaceAreas(positions, mesh.Faces).sum() < 0.0)
  {
    positions.col(0) *= -1.0; // the boundary went round clockwise
  }
  return positions;
}

} // namespace flattening::benchmarks
