// SPDX-License-Identifier: GPL-3.0-or-later
/// The classes of surfaces of a campaign.
#pragma once

#include "../Random.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace fuzz
{

const std::vector<std::string>& surfaceClasses();

/// A random surface of a class. Most have 50 to 500 faces, one in a hundred up to 20,000.
vtkSmartPointer<vtkPolyData> makeSurface(const std::string& surfaceClass, Random& random);

} // namespace fuzz
