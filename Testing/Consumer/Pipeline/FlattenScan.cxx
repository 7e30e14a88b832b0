// SPDX-License-Identifier: GPL-3.0-or-later
// A C++ pipeline of another project: from a scan to a measured flat map.
//   FlattenScan [scan.nii.gz isovalue flat.vtp]
// Without arguments the scan is a ball, 40 voxels across.
#include <vtkConformalDiskFilter.h>
#include <vtkContourFilter.h>
#include <vtkDataArray.h>
#include <vtkDistortionMetrics.h>
#include <vtkFieldData.h>
#include <vtkImageCast.h>
#include <vtkImageEllipsoidSource.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkPolyData.h>
#include <vtkSurfaceToDiskFilter.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  vtkNew<vtkImageEllipsoidSource> ball;
  ball->SetWholeExtent(0, 49, 0, 49, 0, 49);
  ball->SetCenter(24.5, 24.5, 24.5);
  ball->SetRadius(20, 20, 20);
  vtkNew<vtkNIFTIImageReader> scan;
  vtkNew<vtkImageCast> voxels; // smoothed integers would make a terraced surface
  voxels->SetOutputScalarTypeToFloat();
  if (argc == 4)
  {
    scan->SetFileName(argv[1]);
    voxels->SetInputConnection(scan->GetOutputPort());
  }
  else
  {
    voxels->SetInputConnection(ball->GetOutputPort());
  }
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputConnection(voxels->GetOutputPort());
  smooth->SetStandardDeviation(2.0);
  smooth->SetRadiusFactor(3.0);
  vtkNew<vtkContourFilter> surface;
  surface->SetInputConnection(smooth->GetOutputPort());
  surface->SetValue(0, argc == 4 ? std::stod(argv[2]) : 127.5);

  vtkNew<vtkSurfaceToDiskFilter> disk;
  disk->SetInputConnection(surface->GetOutputPort());
  disk->RemeshOn();
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputConnection(disk->GetOutputPort());
  vtkNew<vtkOMTAreaPreservingFilter> areaPreserving;
  areaPreserving->SetInputConnection(conformal->GetOutputPort());
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputConnection(areaPreserving->GetOutputPort());
  metrics->Update();

  const auto figure = [&metrics](const char* name)
  {
    vtkDataArray* array = metrics->GetOutput()->GetFieldData()->GetArray(name);
    return array ? array->GetTuple1(0) : std::nan(""); // a filter that fails says why, and gives nothing
  };
  std::cout << "area " << figure("SurfaceArea") << ", largest error of a cell's area "
            << figure("MaxCellAreaError") << ", mean error of the faces' areas "
            << figure("AreaWeightedMeanAreaError") << " %, faces flipped " << figure("FlippedFaces")
            << " of " << metrics->GetOutput()->GetNumberOfCells() << "\n";
  if (argc == 4)
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputConnection(metrics->GetOutputPort());
    writer->SetFileName(argv[3]);
    writer->SetDataModeToBinary(); // Debian's ParaView cannot read appended data
    writer->Write();
  }
  return figure("MaxCellAreaError") <= 1e-6 ? 0 : 1;
}
