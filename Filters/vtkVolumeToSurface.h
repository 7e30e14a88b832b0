// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkVolumeToSurface
 * @brief   takes the surface out of a scan in one step
 *
 * The input is a volume (vtkImageData) with one number at each voxel. The steps are those that a scan
 * needs, each by a filter of VTK: the voxels become floating-point numbers, get a margin of air
 * (vtkImageConstantPad), so that the surface is closed where it leaves the scan, and are smoothed by a
 * Gaussian whose width is a length and no number of voxels (vtkImageGaussianSmooth). The isosurface is
 * taken (vtkFlyingEdges3D), its largest component chosen, and carried to where it lies in the patient if
 * the volume has the field array `PatientMatrix` (vtkPatientSpace).
 *
 * The isovalue is suggested by the histogram of the voxels: Otsu's threshold parts them into two classes
 * such that as much as possible of their variance lies between the classes. It finds the skin in a CT of
 * a head and the brain in an MRI without skull. Other tissues have isovalues of their own; those of a CT
 * are Hounsfield units, such as 300 for bone.
 *
 * The second output (GetReport) is a vtkTable of what was done, for readers; the field data have the
 * same numbers for programs. The third output (GetHistogram) is the histogram.
 *
 * Voxels that are NaN or infinite are taken for air. A volume of whole numbers that is not smoothed has
 * voxels at an isovalue that is a whole number, and a surface that touches itself there; such an
 * isovalue is moved down by a half. The directions of the axes of the volume are kept.
 *
 * Columns of port 1:
 * - `Amount` (double): how much there is of it.
 * - `Change` (string): what there is so much of.
 * - `Setting` (string): label of the parameter that decides it.
 *
 * Columns of port 2:
 * - `Value` (double, as in the volume): centre of the bin.
 * - `VoxelsBelow` (double): number of voxels in the bin if it is below the isovalue, or else 0.
 * - `VoxelsAbove` (double): number of voxels in the bin if it is above the isovalue, or else 0.
 *
 * Field data (one tuple each):
 * - `Isovalue` (double, as in the volume): isovalue of the surface.
 * - `ShareBelow` (double, 0 to 1): share of the voxels below the isovalue.
 * - `MeanBelow`, `MeanAbove` (double, as in the volume): mean of the voxels below and above the
 * isovalue.
 * - `ClassSeparation` (double, 0 to 1): share of the variance of the voxels that lies between both
 * classes; the suggested isovalue makes it greatest. Below about 0.5 the histogram does not show two
 * classes.
 * - `AirValue` (double, as in the volume): value of the margin.
 * - `SmoothingLength` (double, input units): standard deviation of the Gaussian.
 * - `NotFiniteVoxels` (vtkIdType): number of voxels that were NaN or infinite.
 * - `IsosurfaceComponents` (vtkIdType): number of components of the isosurface.
 * - `LeftOutArea` (double, input units squared): area of the components that were left out.
 *
 * An empty input gives an empty output. The following are errors, each with an empty output: a single
 * slice; voxels of no size; no array of numbers, or one with several components; a chosen array that
 * does not exist, unless the volume has one array only; voxels that are all the
 * same or all not finite; an isovalue that is not between the values of the smoothed volume; a length
 * that is negative or not finite; too little memory.
 *
 * A warning is given if components of more than a thousandth of the area were left out.
 *
 * @sa vtkSurfaceToDiskFilter vtkPatientSpace
 */
#ifndef vtkVolumeToSurface_h
#define vtkVolumeToSurface_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include "vtkBlockwisePolyDataAlgorithm.h"

class vtkDataArray;
class vtkImageData;
class vtkTable;

class SURFACEFLATTENINGFILTERS_EXPORT vtkVolumeToSurface : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkVolumeToSurface* New();
  vtkTypeMacro(vtkVolumeToSurface, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ComponentModes
  {
    AllComponents = 0,
    LargestComponent = 1
  };

  ///@{
  /**
   * Takes the isovalue that the histogram suggests (Otsu), in place of Isovalue. Default: on.
   */
  vtkSetMacro(AutomaticIsovalue, bool);
  vtkGetMacro(AutomaticIsovalue, bool);
  vtkBooleanMacro(AutomaticIsovalue, bool);
  ///@}

  ///@{
  /**
   * Value of the voxels on the surface, if AutomaticIsovalue is off. Default: 0.
   */
  vtkSetMacro(Isovalue, double);
  vtkGetMacro(Isovalue, double);
  ///@}

  ///@{
  /**
   * Smooths by twice the size of a voxel, the cube root of its volume, in place of Smoothing. Default:
   * on.
   */
  vtkSetMacro(AutomaticSmoothing, bool);
  vtkGetMacro(AutomaticSmoothing, bool);
  vtkBooleanMacro(AutomaticSmoothing, bool);
  ///@}

  ///@{
  /**
   * Standard deviation of the Gaussian, in units of the volume (mm for a scan), if AutomaticSmoothing is
   * off. 0 smooths nothing. Default: 1.
   */
  vtkSetMacro(Smoothing, double);
  vtkGetMacro(Smoothing, double);
  ///@}

  ///@{
  /**
   * Voxels of air that are added on every side, so that the surface is closed. With 0 it is open where
   * it leaves the scan. Default: 10.
   */
  vtkSetClampMacro(Margin, int, 0, 1000);
  vtkGetMacro(Margin, int);
  ///@}

  ///@{
  /**
   * Takes the least value of the volume for air, in place of Air. Default: on.
   */
  vtkSetMacro(AutomaticAir, bool);
  vtkGetMacro(AutomaticAir, bool);
  vtkBooleanMacro(AutomaticAir, bool);
  ///@}

  ///@{
  /**
   * Value of the margin, and of voxels that are not finite, if AutomaticAir is off; -1000 in a CT.
   * Default: 0.
   */
  vtkSetMacro(Air, double);
  vtkGetMacro(Air, double);
  ///@}

  ///@{
  /**
   * Which components of the isosurface are kept: all, or the one of the largest area. Default: Largest.
   */
  vtkSetClampMacro(ComponentMode, int, AllComponents, LargestComponent);
  vtkGetMacro(ComponentMode, int);
  void SetComponentModeToAll() { this->SetComponentMode(AllComponents); }
  void SetComponentModeToLargest() { this->SetComponentMode(LargestComponent); }
  ///@}

  ///@{
  /**
   * Carries the surface to where it lies in the patient, if the volume has a PatientMatrix. Default: on.
   */
  vtkSetMacro(PatientSpace, bool);
  vtkGetMacro(PatientSpace, bool);
  vtkBooleanMacro(PatientSpace, bool);
  ///@}

  /**
   * The table of what was done.
   */
  vtkTable* GetReport();

  /**
   * The histogram of the voxels.
   */
  vtkTable* GetHistogram();

protected:
  vtkVolumeToSurface();
  ~vtkVolumeToSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  const char* GetBlockOutputType(int port, vtkInformationVector** inputVector) override;
  int RequestUpdateExtent(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  void RequireSettings() const;
  vtkDataArray* VoxelsOf(vtkImageData* volume);

  bool AutomaticIsovalue = true;
  double Isovalue = 0.0;
  bool AutomaticSmoothing = true;
  double Smoothing = 1.0;
  int Margin = 10;
  bool AutomaticAir = true;
  double Air = 0.0;
  int ComponentMode = LargestComponent;
  bool PatientSpace = true;

  vtkVolumeToSurface(const vtkVolumeToSurface&) = delete;
  void operator=(const vtkVolumeToSurface&) = delete;
};

#endif
