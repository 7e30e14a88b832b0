// SPDX-License-Identifier: GPL-3.0-or-later
#include "ScanSurface.h"

#include <vtkCellArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageCast.h>
#include <vtkImageConstantPad.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>

#include <stdexcept>

namespace flattening::benchmarks
{

vtkSmartPointer<vtkPolyData> scanSurface(const std::string& scan, double sigma, double isovalue)
{
  constexpr int margin = 10;
  vtkNew<vtkNIFTIImageReader> reader;
  if (!reader->CanReadFile(scan.c_str()))
  {
    throw std::runtime_error("cannot read " + scan + ": install Debian's mricron-data");
  }
  reader->SetFileName(scan.c_str());
  reader->Update();
  vtkNew<vtkImageCast> cast;
  cast->SetInputConnection(reader->GetOutputPort());
  cast->SetOutputScalarTypeToFloat();
  int extent[6];
  reader->GetOutput()->GetExtent(extent);
  vtkNew<vtkImageConstantPad> pad;
  pad->SetInputConnection(cast->GetOutputPort());
  pad->SetOutputWholeExtent(extent[0] - margin,
    extent[1] + margin,
    extent[2] - margin,
    extent[3] + margin,
    extent[4] - margin,
    extent[5] + margin);
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputConnection(pad->GetOutputPort());
  smooth->SetStandardDeviation(sigma);
  smooth->SetRadiusFactors(3.0, 3.0, 3.0);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputConnection(sigma > 0.0 ? smooth->GetOutputPort() : pad->GetOutputPort());
  contour->SetValue(0, isovalue);
  contour->ComputeNormalsOff();
  contour->Update();
  return contour->GetOutput();
}

std::string NamedScan::name() const
{
  const std::size_t slash = this->File.find_last_of('/');
  return this->File.substr(slash + 1, this->File.find('.', slash) - slash - 1) + ", iso " +
         std::to_string(static_cast<int>(this->Isovalue)) + ", sigma " +
         std::to_string(this->Sigma).substr(0, 3);
}

std::vector<NamedScan> scansWithHandles(const std::string& folder)
{
  return { { folder + "/ch2bet.nii.gz", 2.0, 40.0 },
    { folder + "/ch2bet.nii.gz", 1.0, 40.0 },
    { folder + "/ch2bet.nii.gz", 1.0, 75.0 },
    { folder + "/ch2better.nii.gz", 1.0, 60.0 },
    { folder + "/ch2better.nii.gz", 0.6, 75.0 },
    { folder + "/ch2better.nii.gz", 0.0, 75.0 } };
}

TriangleMesh meshOf(vtkPolyData* data)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(data->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, mesh.Vertices.row(i).data());
  }
  mesh.Faces.resize(data->GetNumberOfPolys(), 3);
  vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < data->GetNumberOfPolys(); ++f)
  {
    data->GetPolys()->GetCellAtId(f, corners);
    mesh.Faces.row(f) << static_cast<int>(corners->GetId(0)), static_cast<int>(corners->GetId(1)),
      static_cast<int>(corners->GetId(2));
  }
  return mesh;
}

} // namespace flattening::benchmarks
