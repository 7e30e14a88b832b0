// SPDX-License-Identifier: GPL-3.0-or-later
/// The exact side of a point in the plane.
#pragma once

#include "../Soup.h"

namespace fuzz
{

/// 1 if a, b, c turn left in the plane of x and y, -1 if they turn right, 0 if they lie on a line.
int orientation(const Point& a, const Point& b, const Point& c);

} // namespace fuzz
