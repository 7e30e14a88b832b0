// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPlanarWarp
 * @brief   warps points, lines, graphs and images along with a planar mesh that was deformed
 *
 * Input port 0 is a flat map of a planar mesh: triangles in a plane z = constant that went through
 * vtkConformalDiskFilter and, with weights, vtkOMTAreaPreservingFilter. Its point array `SurfacePoints`
 * says where each point was. Input port 1 is the data on that mesh, in the same coordinates: polygonal
 * data, a graph or an image. Every point of the data is located in a triangle of the undeformed mesh
 * and goes to the same barycentric coordinates of that triangle in the flat map: a region of weight 4
 * becomes four times as large as the rest. Heights above the plane of the mesh are kept.
 *
 * - vtkPolyData: its points are warped. Long segments of lines are subdivided, so that they bend
 *   (SubdivideLines); polygons and strips keep their points.
 * - vtkGraph: its vertices and the points within its edges are warped; straight edges are subdivided.
 *   The output is a vtkDirectedGraph or vtkUndirectedGraph.
 * - vtkImageData with one pixel in z: all arrays are resampled on a grid over the flat map; or the
 *   output is the flat map with texture coordinates for the image (ImageOutput).
 *
 * The output has all arrays of the data; those of a graph are on its vertices. At points that were
 * inserted on lines, arrays of floating point numbers are interpolated, and others take the value of
 * the nearer end. Composite data sets on port 1 and port 0 are warped block by block
 * (vtkBlockwisePolyDataAlgorithm), so that several data sets may lie on one mesh. A warning is given if
 * the mesh faced down, so that the warped data are mirrored.
 *
 * Output arrays:
 * - point `SurfacePoints` (double x 3, input units): where the point was before; not in images.
 * - point `InMap` (unsigned char): 1 if the point lay on the mesh, or if the pixel shows a point of the
 *   image; 0 elsewhere, where the other arrays of a resampled image are 0, too.
 * - point `TCoords` (float x 2, dimensionless): active texture coordinates for the image; only if
 *   ImageOutput is TEXTURED_MESH.
 *
 * Field data (one tuple each):
 * - `OutsidePoints` (vtkIdType): number of points of the data that lie outside the mesh; of a resampled
 *   image, the number of pixels of the flat map that lie outside the image.
 * - `InsertedPoints` (vtkIdType): number of points that were inserted on lines and edges and are
 *   in the output.
 *
 * An empty input on either port gives an empty output. The following are errors, each with an empty
 * output: no array `SurfacePoints`; an undeformed mesh that is not in a plane of constant z or folds
 * over itself; data of which no point lies on the mesh; a graph whose vertices have no positions; an
 * image with several slices, one row or no arrays; an output image for which there is too little memory;
 * settings out of range.
 *
 * @sa vtkAreaWeights vtkOMTAreaPreservingFilter
 */
#ifndef vtkPlanarWarp_h
#define vtkPlanarWarp_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro

#include "vtkBlockwisePolyDataAlgorithm.h"

namespace flattening
{
struct WarpRules;
}

class vtkImageData;

class SURFACEFLATTENINGFILTERS_EXPORT vtkPlanarWarp : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkPlanarWarp* New();
  vtkTypeMacro(vtkPlanarWarp, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Data to warp, input port 1: vtkPolyData, vtkGraph or vtkImageData.
   */
  void SetCarriedConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetCarriedData(vtkDataObject* data) { this->SetInputData(1, data); }
  ///@}

  enum OutsideChoices
  {
    REMOVE = 0,
    LEAVE_UNMOVED = 1
  };

  ///@{
  /**
   * Treatment of points outside the undeformed mesh. REMOVE (0): they are removed together with the
   * polygons, strips and edges that use them; lines end at the last point inside. LEAVE_UNMOVED (1):
   * they stay unmoved, and an image grows to cover both its own extent and that of the flat map; this
   * makes sense if the flat map covers the same part of the plane as the undeformed mesh. Default:
   * REMOVE.
   */
  vtkSetClampMacro(OutsidePoints, int, REMOVE, LEAVE_UNMOVED);
  vtkGetMacro(OutsidePoints, int);
  void SetOutsidePointsToRemove() { this->SetOutsidePoints(REMOVE); }
  void SetOutsidePointsToLeaveUnmoved() { this->SetOutsidePoints(LEAVE_UNMOVED); }
  ///@}

  ///@{
  /**
   * Whether long segments of lines and of edges of graphs are divided into equal parts before they are
   * warped. Default: on.
   */
  vtkSetMacro(SubdivideLines, bool);
  vtkGetMacro(SubdivideLines, bool);
  vtkBooleanMacro(SubdivideLines, bool);
  ///@}

  ///@{
  /**
   * Greatest length of these parts before they are warped (input units); 0 takes half of the mean side
   * of the triangles of the undeformed mesh. Range [0, inf), otherwise an error. Default: 0.
   */
  vtkSetMacro(MaximumSegmentLength, double);
  vtkGetMacro(MaximumSegmentLength, double);
  ///@}

  enum ImageOutputs
  {
    RESAMPLED_IMAGE = 0,
    TEXTURED_MESH = 1
  };

  ///@{
  /**
   * Output for an image. RESAMPLED_IMAGE (0): an image over the flat map. TEXTURED_MESH (1): the flat
   * map as vtkPolyData with texture coordinates (`TCoords`), by which the image is drawn on it. Default:
   * RESAMPLED_IMAGE.
   */
  vtkSetClampMacro(ImageOutput, int, RESAMPLED_IMAGE, TEXTURED_MESH);
  vtkGetMacro(ImageOutput, int);
  void SetImageOutputToResampledImage() { this->SetImageOutput(RESAMPLED_IMAGE); }
  void SetImageOutputToTexturedMesh() { this->SetImageOutput(TEXTURED_MESH); }
  ///@}

  ///@{
  /**
   * Width and height of the resampled image in pixels. The pixels are square, and as small as possible
   * so that the image covers the flat map. 0 0 takes the size of the input image. Range [2, 65535],
   * otherwise an error. Default: 0 0.
   */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

  ///@{
  /**
   * Whether a pixel takes the value of the nearest pixel of the image, as labels need it, instead of the
   * interpolation between four pixels. Default: off.
   */
  vtkSetMacro(NearestPixel, bool);
  vtkGetMacro(NearestPixel, bool);
  vtkBooleanMacro(NearestPixel, bool);
  ///@}

  /**
   * The warped data: vtkPolyData, vtkDirectedGraph, vtkUndirectedGraph, vtkImageData, or a composite
   * data set.
   */
  vtkDataObject* GetOutput() { return this->GetOutputDataObject(0); }

protected:
  vtkPlanarWarp();
  ~vtkPlanarWarp() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  const char* GetBlockOutputType(int port, vtkInformationVector** inputVector) override;
  int RequestInformation(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  int OutsidePoints = REMOVE;
  bool SubdivideLines = true;
  double MaximumSegmentLength = 0.0;
  int ImageOutput = RESAMPLED_IMAGE;
  int ImageSize[2] = { 0, 0 };
  bool NearestPixel = false;

private:
  vtkPlanarWarp(const vtkPlanarWarp&) = delete;
  void operator=(const vtkPlanarWarp&) = delete;

  // The number of columns and rows of the output image. Throws InvalidInput if they are out of range.
  const int* SizeOfImage(vtkImageData* image) const;

  long long WarpImage(vtkImageData* image,
    vtkPolyData* flat,
    const flattening::WarpRules& rules,
    vtkDataObject* output);
};

#endif
