// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/TextureCoordinates.h"

#include "Internal/PolyDataConversion.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace flattening
{

TextureSquare textureSquare(const Points2& positions)
{
  const Eigen::RowVector2d low = positions.colwise().minCoeff();
  const Eigen::RowVector2d high = positions.colwise().maxCoeff();
  const double side = (high - low).maxCoeff();
  return { (0.5 * (low + high)).array() - 0.5 * side, side };
}

void setTextureCoordinates(vtkPolyData* output, const Points2& positions)
{
  const TextureSquare square = textureSquare(positions);
  const Eigen::RowVector2d centre = square.Low.array() + 0.5 * square.Side;
  vtkNew<vtkFloatArray> coordinates; // VTK's PLY writer crashes on doubles
  coordinates->SetName(TextureCoordinatesName);
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(positions.rows());
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    for (int k = 0; k < 2; ++k)
    {
      const double t = 0.5 + (positions(v, k) - centre[k]) / square.Side;
      coordinates->SetTypedComponent(v, k, static_cast<float>(std::clamp(t, 0.0, 1.0)));
    }
  }
  // SetTCoords() would remove the active array, which the user may need.
  output->GetPointData()->AddArray(coordinates);
  output->GetPointData()->SetActiveTCoords(TextureCoordinatesName);
}

void keepSurfaceTextureCoordinates(vtkPolyData* output)
{
  vtkPointData* arrays = output->GetPointData();
  if (arrays->HasArray(SurfacePointsName))
  {
    arrays->RemoveArray(TextureCoordinatesName); // those of the map
  }
  else if (vtkDataArray* own = arrays->GetArray(TextureCoordinatesName))
  {
    const auto copy = vtk::TakeSmartPointer(own->NewInstance());
    copy->ShallowCopy(own);
    copy->SetName(SurfaceTextureCoordinatesName);
    arrays->RemoveArray(TextureCoordinatesName);
    arrays->AddArray(copy);
  }
}

} // namespace flattening
