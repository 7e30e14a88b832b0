// SPDX-License-Identifier: GPL-3.0-or-later
/// The faces of a surface while it is repaired.
#pragma once

#include <array>
#include <vector>

namespace flattening
{

using Triangle = std::array<int, 3>;

inline bool repeatsVertex(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

struct FaceList
{
  std::vector<Triangle> Faces;
  std::vector<int> Origins; ///< per face: the input face that it is a part of

  /// Drops the faces for whose index @p drop is true and returns their number; the others keep their
  /// order.
  template <typename Drop>
  int dropIf(Drop&& drop)
  {
    std::size_t kept = 0;
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      if (!drop(f))
      {
        this->Faces[kept] = this->Faces[f];
        this->Origins[kept++] = this->Origins[f];
      }
    }
    const int dropped = static_cast<int>(this->Faces.size() - kept);
    this->Faces.resize(kept);
    this->Origins.resize(kept);
    return dropped;
  }
};

} // namespace flattening
