// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/CappedCut.h"

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{

class CutPlanner
{
public:
  CutPlanner(const HalfedgeSurface& surface, const std::vector<int>& loop, const LoopCap& cap)
    : Surface(surface)
    , Loop(loop)
    , LoopSize(static_cast<int>(loop.size()))
    , InsideSize(static_cast<int>(cap.Inside.size()))
  {
    this->Cut.Cap = cap;
    this->Cut.FirstCopy = surface.vertexCount();
    this->Cut.FirstRight = this->Cut.FirstCopy + this->LoopSize;
    this->Cut.FirstLeft = this->Cut.FirstRight + this->InsideSize;
  }

  CappedCut plan(double step)
  {
    this->moveLoop(step);
    this->moveInside();
    for (const auto& [face, corners] : this->FacesAround)
    {
      this->Cut.Faces.Replaced.push_back(face);
      this->Cut.Faces.Faces.push_back(corners);
    }
    std::vector<int> copies(this->LoopSize);
    std::iota(copies.begin(), copies.end(), this->Cut.FirstCopy);
    this->addCap(this->Cut.Vertices, this->Cut.FirstRight, false);
    this->addCap(copies, this->Cut.FirstLeft, true);
    return std::move(this->Cut);
  }

private:
  // Moves both copies of the loop's vertices apart.
  void moveLoop(double step)
  {
    std::map<int, Eigen::Vector3d>& positions = this->Cut.Faces.Positions;
    for (int i = 0; i < this->LoopSize; ++i)
    {
      const int v = this->Surface.source(this->Loop[i]);
      const int copy = this->Cut.FirstCopy + i;
      const int before = this->Loop[(i + this->LoopSize - 1) % this->LoopSize];
      this->Cut.Vertices.push_back(v);
      this->moveCorner(before, this->Loop[i], copy, step);
      this->moveCorner(this->Surface.twin(this->Loop[i]), this->Surface.twin(before), v, step);
      this->Apart.emplace_back(positions[copy] - positions[v]);
      this->Distance += this->Apart.back().norm() / this->LoopSize;
    }
  }

  // Gives a vertex of the loop its position and number on one side: the side on the left of the
  // half-edges `before`, which ends there, and `after`, which starts there.
  void moveCorner(int before, int after, int number, double step)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0.0;
    const Eigen::Vector3d& p = this->Surface.point(this->Surface.source(after));
    for (int h = after;; h = this->Surface.rotated(h))
    {
      const int previous = HalfedgeSurface::previous(h);
      const Eigen::Vector3d a = this->Surface.point(this->Surface.target(h)) - p;
      const Eigen::Vector3d b = this->Surface.point(this->Surface.source(previous)) - p;
      const double twice = a.cross(b).norm();
      sum += twice * (a + b) / 3.0;
      area += twice;
      this->cornersOf(HalfedgeSurface::face(h))[h % 3] = number;
      if (previous == before)
      {
        break;
      }
    }
    this->Cut.Faces.Positions[number] = area > 0.0 ? Eigen::Vector3d(p + step * sum / area) : p;
  }

  std::array<int, 3>& cornersOf(int face)
  {
    const std::array<int, 3> now{ this->Surface.source(3 * face),
      this->Surface.source(3 * face + 1),
      this->Surface.source(3 * face + 2) };
    return this->FacesAround.try_emplace(face, now).first->second;
  }

  // Moves the inner vertices of both caps along the cap's normal, to the sides to which the loop's
  // vertices moved.
  void moveInside()
  {
    const LoopCap& cap = this->Cut.Cap;
    const auto at = [&](int v) -> const Eigen::Vector3d&
    {
      return v < this->LoopSize ? this->Surface.point(this->Cut.Vertices[v])
                                : cap.Inside[v - this->LoopSize];
    };
    std::vector<Eigen::Vector3d> normals(this->LoopSize + this->InsideSize, Eigen::Vector3d::Zero());
    for (const auto& face : cap.Faces)
    {
      const Eigen::Vector3d normal = (at(face[1]) - at(face[0])).cross(at(face[2]) - at(face[0]));
      for (const int v : face)
      {
        normals[v] += normal;
      }
    }
    double side = 0.0;
    for (int i = 0; i < this->LoopSize; ++i)
    {
      side += this->Apart[i].dot(normals[i].stableNormalized());
    }
    const double offset = std::copysign(0.5 * this->Distance, side);
    for (int j = 0; j < this->InsideSize; ++j)
    {
      const Eigen::Vector3d shift = offset * normals[this->LoopSize + j].stableNormalized();
      this->Cut.Faces.Positions[this->Cut.FirstRight + j] = cap.Inside[j] - shift;
      this->Cut.Faces.Positions[this->Cut.FirstLeft + j] = cap.Inside[j] + shift;
    }
  }

  // Adds the cap of one side. `loop` has the vertices of the loop there, and the inner vertices of the
  // cap are numbered from `firstInside` on.
  void addCap(const std::vector<int>& loop, int firstInside, bool reversed)
  {
    for (std::array<int, 3> face : this->Cut.Cap.Faces)
    {
      for (int& v : face)
      {
        v = v < this->LoopSize ? loop[v] : firstInside + v - this->LoopSize;
      }
      if (reversed)
      {
        std::swap(face[0], face[2]);
      }
      this->Cut.Faces.Faces.push_back(face);
    }
  }

  const HalfedgeSurface& Surface;
  const std::vector<int>& Loop;
  int LoopSize;
  int InsideSize;
  CappedCut Cut;
  std::map<int, std::array<int, 3>> FacesAround; // faces that meet the loop, with their new corners
  std::vector<Eigen::Vector3d> Apart;            // from each right copy to the left one
  double Distance = 0.0;                         // mean length of Apart
};

} // namespace

CappedCut capBothSides(const HalfedgeSurface& surface,
  const std::vector<int>& loop,
  const LoopCap& cap,
  double step)
{
  return CutPlanner(surface, loop, cap).plan(step);
}

} // namespace flattening
