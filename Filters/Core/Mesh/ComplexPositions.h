// SPDX-License-Identifier: GPL-3.0-or-later
/// Positions in the plane as complex numbers.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <complex>
#include <vector>

namespace flattening
{

using ComplexVector = std::vector<std::complex<double>>;

/// The points (Re z, Im z), n x 2.
Points2 pointsOf(const ComplexVector& positions);
/// The numbers x + i y of points (n x 2).
ComplexVector complexOf(const Points2& positions);

} // namespace flattening
