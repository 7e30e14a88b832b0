// SPDX-License-Identifier: GPL-3.0-or-later
/// Isosurfaces of real scans, made with VTK's filters.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace flattening::benchmarks
{

/// The isosurface of a NIfTI volume: cast to float before smoothing, or the plateaus of the integer
/// image fall apart into thousands of handles; padded, so that the surface closes.
/// @param sigma standard deviation of the Gaussian, voxels; cut off at three of them. 0: none.
vtkSmartPointer<vtkPolyData> scanSurface(const std::string& scan, double sigma, double isovalue);

/// An isosurface with handles, before Surface To Disk.
struct NamedScan
{
  std::string File;
  double Sigma;
  double Isovalue;

  std::string name() const;
};

/// The isosurfaces on which Surface To Disk is measured.
/// @param folder  of Debian's mricron-data
std::vector<NamedScan> scansWithHandles(const std::string& folder);

/// The triangles of @p data, which has no other cells.
TriangleMesh meshOf(vtkPolyData* data);

} // namespace flattening::benchmarks
