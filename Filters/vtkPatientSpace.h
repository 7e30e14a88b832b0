// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPatientSpace
 * @brief   moves a surface from the voxels of its scan to the space of the patient
 *
 * The input is polydata with the field array `PatientMatrix`, which the plugin's readers of scans write
 * and other filters pass on, for example the isosurface of a scan. The points are carried to
 * millimetres along the patient's right, front and top (RAS+, the space of NIfTI, nibabel and most
 * atlases), in double precision. The point and cell arrays `Normals` are turned along, and so are the
 * active normals. If the matrix mirrors, the cells are reversed, so that the surface keeps its outside,
 * and triangle strips become triangles.
 *
 * Apply it to the surface, before vtkSurfaceToDiskFilter: areas and lengths are those of the patient
 * only in patient space if the voxels are sheared, as those of a CT with a tilted gantry. A surface in
 * patient space already is passed on as it is. So is one without the array, with a warning.
 *
 * Field data (one tuple each):
 * - `PatientMatrix` (double x 16): the matrix, row by row, that takes the coordinates of the voxels,
 *   index times size, to patient space; passed on.
 * - `InPatientSpace` (vtkIdType): 1 once the points are in patient space.
 *
 * An empty input gives an empty output. The following are errors, each with an empty output: a matrix
 * that does not have 16 finite numbers, whose last row is not 0 0 0 1, or that is singular; a flat map
 * (the point array `SurfacePoints`), whose points are not in space.
 *
 * @sa vtkSurfaceToDiskFilter vtkFlatMapSlab
 */
#ifndef vtkPatientSpace_h
#define vtkPatientSpace_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include "vtkBlockwisePolyDataAlgorithm.h"

class SURFACEFLATTENINGFILTERS_EXPORT vtkPatientSpace : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkPatientSpace* New();
  vtkTypeMacro(vtkPatientSpace, vtkBlockwisePolyDataAlgorithm);

protected:
  vtkPatientSpace() = default;
  ~vtkPatientSpace() override = default;

  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkPatientSpace(const vtkPatientSpace&) = delete;
  void operator=(const vtkPatientSpace&) = delete;
};

#endif
