// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HandleLoops.h"

#include "Base/EigenVersions.h"
#include "Handles/HandleCutting.h"

#include <utility>

namespace flattening
{
namespace
{

// Cuts the surface, leaves it open, and remembers which vertices the cuts copied.
class LoopRecorder
{
public:
  explicit LoopRecorder(const TriangleMesh& mesh)
    : Surface(mesh)
  {
    this->followSplits();
  }

  HandleLoops run(const ProgressCallback& progress)
  {
    HandleLoops result;
    result.Lengths = cutHandles(
      this->Surface,
      [&](const SurfaceLoop& loop, int, int) -> CutOutcome
      {
        this->followSplits();
        std::vector<int> vertices;
        for (const int h : loop.Halfedges)
        {
          vertices.push_back(this->Uncut[this->Surface.source(h)]);
        }
        this->Uncut.insert(this->Uncut.end(), vertices.begin(), vertices.end());
        result.Loops.push_back(std::move(vertices));
        return { this->Surface.cut(loop.Halfedges), 0 };
      },
      progress);
    this->followSplits();
    result.Surface = this->uncut();
    return result;
  }

private:
  // Takes note of the vertices that are not copies: those of the mesh, and middles of split edges.
  void followSplits()
  {
    while (static_cast<int>(this->Uncut.size()) < this->Surface.vertexCount())
    {
      this->Kept.push_back(static_cast<int>(this->Uncut.size()));
      this->Uncut.push_back(static_cast<int>(this->Kept.size()) - 1);
    }
  }

  // The surface without the copies of vertices.
  DerivedMesh uncut() const
  {
    DerivedMesh result = this->Surface.derived();
    result.Vertices =
      VertexOrigins(keptVertices(this->Kept, result.Mesh.vertexCount()) * result.Vertices);
    result.Mesh.Vertices = Points3(result.Mesh.Vertices(this->Kept, flattening::all));
    for (int& v : result.Mesh.Faces.reshaped())
    {
      v = this->Uncut[v];
    }
    return result;
  }

  HalfedgeSurface Surface;
  std::vector<int> Uncut; // per vertex of the cut surface: its vertex in the surface without copies
  std::vector<int> Kept;  // per vertex of the surface without copies: the cut surface's vertex
};

} // namespace

HandleLoops handleLoops(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  return LoopRecorder(mesh).run(progress);
}

} // namespace flattening
