// SPDX-License-Identifier: GPL-3.0-or-later
/// Regression images of the filters. A surface or a map is drawn without light, so that a pixel has the
/// colour of the face that it shows, and the image is compared with a baseline in Testing/Baseline by
/// vtkImageDifference, as VTK's own tests do. Each test also checks numbers of the same output, and that
/// images of wrong results differ from the baseline.
#pragma once

#include "AnalyticSurfaces.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

namespace flattening::testing
{

using Image = vtkSmartPointer<vtkImageData>;

/// A camera of parallel projection.
struct View
{
  std::array<double, 3> Centre{};                 ///< this point is in the middle of the image
  std::array<double, 3> Towards{ 0.0, 0.0, 1.0 }; ///< from the centre to the camera
  std::array<double, 3> Up{ 0.0, 1.0, 0.0 };
  double HalfHeight = 1.05; ///< half the height of the image, in units of the data
  int Size = 150;           ///< pixels a side
  bool Edges = false;       ///< whether the edges of the faces are drawn
};

/// The map of a surface of revolution to the disk whose radius is a function of the meridian parameter:
/// the mesh's vertices in the plane, with the array `SurfacePoints`.
vtkSmartPointer<vtkPolyData> radialMap(const analytic::RevolutionMesh& mesh,
  const analytic::SurfaceOfRevolution::Function& radius);

/// Greatest distance of a point from its position on that map.
double distanceFromRadialMap(const analytic::RevolutionMesh& mesh,
  vtkPolyData* flat,
  const analytic::SurfaceOfRevolution::Function& radius);

/// Adds the cell array `Tile` to a surface around the z-axis, with numbers from 1 to 8. There is a tile
/// for each of twelve sectors of longitude and of the rings of width @p ring around the axis.
/// Neighbouring tiles differ, and so do those of one quadrant from the rest, so that neither a rotated
/// nor a mirrored surface looks the same. Within a tile, cells with odd and even ids differ by 1, so
/// that moved points show.
void addTiles(vtkPolyData* surface, double ring);

/// Colours the cells by one component of an array in eight steps, from blue at @p low over green to red
/// at @p high, which keeps the baselines small. A cell has the mean of its corners' values if the array
/// is a point array.
void colourBy(vtkPolyData* data, const char* array, double low, double high, int component = 0);

/// The surface in the colours of its cells, on a white background. Faces that are seen from behind are
/// not drawn.
Image imageOf(vtkPolyData* data, const View& view = {});

/// One component of a point array of an image on the same scale of colours, one pixel per point; NaN is
/// white.
Image imageOf(vtkImageData* image, const char* array, double low, double high);

/// Expects that the image looks like the baseline <name>.png: it differs from it by less than
/// BaselineTolerance. The image is left in the folder of temporary files. If the environment has
/// WRITE_BASELINES, it becomes the baseline.
void expectBaseline(const Image& image, const std::string& name);

/// Expects that the image of a wrong result differs from the baseline by at least @p times
/// BaselineTolerance.
void expectNotBaseline(const Image& image,
  const std::string& name,
  const std::string& wrong,
  double times = 6.0);

/// Greatest difference from the baseline, as vtkImageDifference sums it over the pixels with threshold
/// 16: about the number of pixels of quite another colour. The same driver gives 0; drivers may differ
/// in the pixels that an edge covers.
inline constexpr double BaselineTolerance = 15.0;

} // namespace flattening::testing
