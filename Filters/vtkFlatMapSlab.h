// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkFlatMapSlab
 * @brief   the grey values of a volume on a flat map, at depths below the surface
 *
 * Port 0 takes a flat map (triangles in the plane with the point array `SurfacePoints`), port 1 the
 * volume that its surface came from, or another in the same coordinates (vtkImageData); of composite
 * data sets on both, block for block. At every point of the map the volume is sampled where the point
 * lies in space and at each depth from there along the inward normal of the surface: a slab of the
 * volume, made flat, such as the cortex at 0, 1, 2 mm.
 *
 * Output port 0 is the flat map with these point arrays:
 * - for every point array of the volume, one with `Slab` after its name (float): a component per depth,
 *   named by it; of an array of several components all of the first depth, then of the second. NaN
 *   outside of the volume
 * - `InVolume` (unsigned char), a component per depth: 1 inside of the volume
 * - `SurfaceNormals` (double x 3): the outward unit normal of the surface
 *
 * Output port 1 is the slab as a stack of images (vtkImageData) over the square that vtkFlatMapImage
 * covers, a layer per depth, the first first. Each pixel is sampled in the volume itself, at its own
 * point of the surface. It has an array for each of the volume, with its name (float, NaN outside of
 * volume and map), and `InVolume`. If the depths are at equal steps, z is depth; else layers are one
 * pixel apart. The field array `Depths` holds the depths in any case.
 *
 * Field data of both ports: `Depths` (a value per depth, input units) and, of port 0,
 * `OutsideSamples`, how many samples of the points are outside of the volume, with a warning if there
 * are any. Depths beyond the radius of curvature of a surface bent inwards cross what belongs to
 * neighbouring points.
 *
 * An empty input on either port gives empty outputs. Errors, each with empty outputs: cells that are not
 * triangles, no array `SurfacePoints`, no depth, a depth that is not finite or given twice, a volume
 * without point arrays, or in which no sample lies.
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
   * The volume that is sampled, input port 1 (vtkImageData).
   */
  void SetVolumeConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetVolumeData(vtkImageData* volume);
  ///@}

  ///@{
  /**
   * The depths below the surface (input units), in the order of components and layers; negative ones are
   * above it. Default: 0, 1, 2. GetDepth of a number that there is none for is NaN.
   */
  void AddDepth(double depth);
  void ClearDepths();
  int GetNumberOfDepths() { return static_cast<int>(this->Depths.size()); }
  double GetDepth(int i);
  ///@}

  ///@{
  /**
   * Whether depths count outwards instead, along the normals: for surfaces whose triangles are
   * oriented inwards. Default: off.
   */
  vtkSetMacro(Outwards, bool);
  vtkGetMacro(Outwards, bool);
  vtkBooleanMacro(Outwards, bool);
  ///@}

  ///@{
  /**
   * Whether a sample is the value of the nearest voxel, as labels need it, instead of linear between the
   * eight around it. Default: off.
   */
  vtkSetMacro(NearestVoxel, bool);
  vtkGetMacro(NearestVoxel, bool);
  vtkBooleanMacro(NearestVoxel, bool);
  ///@}

  ///@{
  /**
   * Pixels a side of the stack of images; below 2: none. Range [0, 4096]. Default: 256.
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
