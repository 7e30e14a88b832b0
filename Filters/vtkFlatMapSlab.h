// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkFlatMapSlab
 * @brief   samples a volume below the surface and shows the values on the flat map
 *
 * Port 0 takes a flat map (triangles in the plane with the point array `SurfacePoints`), and port 1
 * takes the volume that the surface came from, or another volume in the same coordinates
 * (vtkImageData). Composite data sets on both ports are paired block by block. For each point of the
 * map, the volume is sampled at several depths along the inward normal of the surface, starting from
 * the point's position on the surface. The result is a flattened slab of the volume, such as the cortex
 * at 0, 1 and 2 mm.
 *
 * Output port 0 is the flat map with the samples as point arrays. Output port 1 is a stack of images
 * (vtkImageData) over the square that vtkFlatMapImage covers, with one layer per depth. Each pixel is
 * sampled in the volume itself, at its own point of the surface. If the depths are equally spaced, z is
 * the depth; otherwise the layers are one pixel apart.
 *
 * A surface in patient space (vtkPatientSpace) is sampled where the field array `PatientMatrix` of the
 * volume says that it lies in the patient. The same is done if both have a matrix and these differ.
 * Otherwise surface and volume are taken to have the same coordinates, with a warning if the volume
 * alone has a matrix.
 *
 * Samples deeper than the radius of curvature of a surface that bends inwards cross those of
 * neighbouring points. A warning is given if samples lie outside the volume.
 *
 * Output arrays of port 0:
 * - point `XSlab` (float x depths, as in the volume): samples of the point array X of the
 *   volume, one component per depth and named by it; an array with several components has all
 *   components of the first depth first. The value is NaN outside the volume. With NearestVoxel, values
 *   of 32 and more bits are double.
 * - point `InVolume` (unsigned char x depths): 1 where the sample lies inside the volume, 0 outside.
 * - point `SurfaceNormals` (double x 3, dimensionless): outward unit normal of the surface.
 *
 * Output arrays of port 1:
 * - point `X` (float or double as `XSlab`, x components of the array, as in the volume): samples of the
 *   point array X of the volume; NaN outside the volume and the map.
 * - point `InVolume` (unsigned char): 1 where the pixel lies on the map and its sample inside the
 *   volume, 0 elsewhere.
 *
 * Image filters after the stack ask for its extent, its spacing and the type of its values before there
 * are data. Therefore this filter brings its inputs up to date when it is asked for information, if it
 * makes a stack.
 *
 * Field data of both ports:
 * - `Depths` (double, input units, one tuple per depth): depths below the surface.
 * - `OutsideSamples` (vtkIdType, one tuple): number of samples of port 0 outside the volume.
 *
 * An empty input on either port gives empty outputs. The following are errors, each with empty outputs:
 * cells that are not triangles; no array `SurfacePoints`; no depth; a depth that is not finite or given
 * twice; a volume that has no point arrays, has voxels without size, or contains no sample; a volume
 * that does not say where it lies in the patient, though the surface is in patient space; a stack for
 * which there is too little memory.
 *
 * @sa vtkFlatMapImage vtkOMTAreaPreservingFilter vtkProbeFilter
 */
#ifndef vtkFlatMapSlab_h
#define vtkFlatMapSlab_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include "vtkBlockwisePolyDataAlgorithm.h"

#include <vector>

class vtkImageData;

class SURFACEFLATTENINGFILTERS_EXPORT vtkFlatMapSlab : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkFlatMapSlab* New();
  vtkTypeMacro(vtkFlatMapSlab, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Volume that is sampled, input port 1 (vtkImageData with point arrays).
   */
  void SetVolumeConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetVolumeData(vtkImageData* volume);
  ///@}

  ///@{
  /**
   * Depths below the surface (input units), in the order of components and layers; negative depths are
   * above the surface. An error if there is none, or if one is not finite or given twice. GetDepth
   * returns NaN for an index without a depth. Default: 0, 1, 2.
   */
  void AddDepth(double depth);
  void ClearDepths();
  int GetNumberOfDepths() { return static_cast<int>(this->Depths.size()); }
  double GetDepth(int i);
  ///@}

  ///@{
  /**
   * Whether depths are measured outwards, along the normals, for surfaces whose triangles are oriented
   * inwards. Default: off.
   */
  vtkSetMacro(Outwards, bool);
  vtkGetMacro(Outwards, bool);
  vtkBooleanMacro(Outwards, bool);
  ///@}

  ///@{
  /**
   * Whether a sample takes the value of the nearest voxel, as labels need it, instead of the linear
   * interpolation between the eight voxels around it. Default: off.
   */
  vtkSetMacro(NearestVoxel, bool);
  vtkGetMacro(NearestVoxel, bool);
  vtkBooleanMacro(NearestVoxel, bool);
  ///@}

  ///@{
  /**
   * Number of pixels per side of the stack of images; below 2 the stack is empty. Range [0, 4096].
   * Default: 256.
   */
  vtkSetClampMacro(StackSize, int, 0, 4096);
  vtkGetMacro(StackSize, int);
  ///@}

  /**
   * The stack of output port 1.
   */
  vtkImageData* GetStack();

protected:
  vtkFlatMapSlab();
  ~vtkFlatMapSlab() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  const char* GetBlockOutputType(int port, vtkInformationVector** inputVector) override;
  int RequestInformation(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  std::vector<double> Depths{ 0.0, 1.0, 2.0 };
  bool Outwards = false;
  bool NearestVoxel = false;
  int StackSize = 256;

private:
  vtkFlatMapSlab(const vtkFlatMapSlab&) = delete;
  void operator=(const vtkFlatMapSlab&) = delete;

  void RequireDepths() const;
};

#endif
