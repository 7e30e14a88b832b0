// SPDX-License-Identifier: GPL-3.0-or-later
#include "Generators.h"

#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMarchingCubes.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fuzz
{
namespace
{

// The values of a volume of n points per side.
struct Volume
{
  int Size;
  std::vector<double> Values;
  double at(int i, int j, int k) const { return this->Values[(k * this->Size + j) * this->Size + i]; }
};

// About as many points per side as an isosurface of so many faces needs.
int sideFor(int faces, double facesPerSquare)
{
  return std::clamp(static_cast<int>(std::sqrt(faces / facesPerSquare)), 3, 60);
}

Volume noise(Random& random, int size)
{
  Volume volume{ size, std::vector<double>(size * size * size) };
  for (double& value : volume.Values)
  {
    value = random.normal();
  }
  return volume;
}

Volume waves(Random& random, int size)
{
  struct Wave
  {
    double X, Y, Z, Phase;
  };
  std::vector<Wave> sum(random.integer(1, 6));
  const double frequency = random.uniform(1.0, 9.0);
  for (Wave& wave : sum)
  {
    wave = { frequency * random.normal(),
      frequency * random.normal(),
      frequency * random.normal(),
      random.uniform(0.0, 6.3) };
  }
  const double bowl = random.chance(0.5) ? random.uniform(0.0, 8.0) : 0.0; // closes the surface
  Volume volume{ size, {} };
  for (int k = 0; k < size; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        const double x = i / (size - 1.0) - 0.5;
        const double y = j / (size - 1.0) - 0.5;
        const double z = k / (size - 1.0) - 0.5;
        double value = bowl * (0.1 - x * x - y * y - z * z);
        for (const Wave& wave : sum)
        {
          value += std::cos(wave.X * x + wave.Y * y + wave.Z * z + wave.Phase) / sum.size();
        }
        volume.Values.push_back(value);
      }
    }
  }
  return volume;
}

// The outermost values become low, so that the surface is closed.
void close(Volume& volume)
{
  const double low = *std::min_element(volume.Values.begin(), volume.Values.end());
  for (int k = 0; k < volume.Size; ++k)
  {
    for (int j = 0; j < volume.Size; ++j)
    {
      for (int i = 0; i < volume.Size; ++i)
      {
        if (std::min({ i, j, k }) == 0 || std::max({ i, j, k }) == volume.Size - 1)
        {
          volume.Values[(k * volume.Size + j) * volume.Size + i] = low;
        }
      }
    }
  }
}

// The value below which a share of the volume lies.
double quantile(const Volume& volume, double share)
{
  std::vector<double> sorted = volume.Values;
  std::sort(sorted.begin(), sorted.end());
  return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * sorted.size()))];
}

Soup contour(Random& random, const Volume& volume, double value)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(volume.Size, volume.Size, volume.Size);
  image->SetSpacing(1.0, random.chance(0.7) ? 1.0 : random.logUniform(0.05, 5.0), 1.0);
  image->AllocateScalars(VTK_DOUBLE, 1);
  auto* scalars = vtkDoubleArray::SafeDownCast(image->GetPointData()->GetScalars());
  std::copy(volume.Values.begin(), volume.Values.end(), scalars->GetPointer(0));
  if (random.chance(0.5))
  {
    vtkNew<vtkMarchingCubes> cubes;
    cubes->SetInputData(image);
    cubes->SetValue(0, value);
    cubes->ComputeNormalsOff();
    cubes->Update();
    return soupOf(cubes->GetOutput());
  }
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, value);
  edges->ComputeNormalsOff();
  edges->Update();
  return soupOf(edges->GetOutput());
}

using Index = std::array<int, 3>;

// Squares between the corners of voxels, whole or as two triangles.
class SquareFaces
{
public:
  SquareFaces(int size, bool triangles)
    : Size(size + 1)
    , HasTriangles(triangles)
    , Ids(static_cast<std::size_t>(this->Size) * this->Size * this->Size, -1)
  {
  }

  // The square of a corner and two sides, clockwise if reversed.
  void add(const Index& corner, const Index& u, const Index& v, bool reversed)
  {
    Cell cell = { this->pointAt(corner),
      this->pointAt(sum(corner, u)),
      this->pointAt(sum(sum(corner, u), v)),
      this->pointAt(sum(corner, v)) };
    if (reversed)
    {
      std::reverse(cell.begin(), cell.end());
    }
    if (this->HasTriangles)
    {
      this->Faces.addTriangle(cell[0], cell[1], cell[2]);
      this->Faces.addTriangle(cell[0], cell[2], cell[3]);
      return;
    }
    this->Faces.Polygons.push_back(cell);
  }

  Soup Faces;

private:
  static Index sum(const Index& a, const Index& b) { return { a[0] + b[0], a[1] + b[1], a[2] + b[2] }; }

  vtkIdType pointAt(const Index& corner)
  {
    vtkIdType& id = this->Ids[(corner[2] * this->Size + corner[1]) * this->Size + corner[0]];
    if (id < 0)
    {
      id = this->Faces.add({ static_cast<double>(corner[0]),
        static_cast<double>(corner[1]),
        static_cast<double>(corner[2]) });
    }
    return id;
  }

  int Size;
  bool HasTriangles;
  std::vector<vtkIdType> Ids;
};

} // namespace

Soup smoothIsosurface(Random& random, int faces)
{
  Volume volume = waves(random, sideFor(faces, 4.0));
  const double value = quantile(volume, random.uniform(0.1, 0.9));
  if (random.chance(0.5))
  {
    close(volume);
  }
  return contour(random, volume, value);
}

Soup noiseIsosurface(Random& random, int faces)
{
  Volume volume = noise(random, std::clamp(static_cast<int>(std::cbrt(faces / 1.5)), 3, 24));
  // Many values that equal the threshold give many faces without area.
  const double rounding = random.chance(0.3) ? 2.0 : 0.0;
  for (double& value : volume.Values)
  {
    value = rounding > 0.0 ? std::round(rounding * value) : value;
  }
  const double value = quantile(volume, random.uniform(0.02, 0.98));
  if (random.chance(0.5))
  {
    close(volume);
  }
  return contour(random, volume, value);
}

Soup voxelFaces(Random& random, int faces)
{
  const bool smooth = random.chance(0.6);
  Volume volume = smooth ? waves(random, std::min(30, sideFor(faces, 6.0)))
                         : noise(random, std::clamp(static_cast<int>(std::cbrt(faces / 2.0)), 3, 20));
  const double value = quantile(volume, random.uniform(0.2, 0.97));
  close(volume);
  const int n = volume.Size;
  SquareFaces squares(n, random.chance(0.6));
  for (int k = 1; k < n; ++k)
  {
    for (int j = 1; j < n; ++j)
    {
      for (int i = 1; i < n; ++i)
      {
        const bool in = volume.at(i, j, k) > value;
        if (in != (volume.at(i - 1, j, k) > value))
        {
          squares.add({ i, j, k }, { 0, 1, 0 }, { 0, 0, 1 }, in);
        }
        if (in != (volume.at(i, j - 1, k) > value))
        {
          squares.add({ i, j, k }, { 0, 0, 1 }, { 1, 0, 0 }, in);
        }
        if (in != (volume.at(i, j, k - 1) > value))
        {
          squares.add({ i, j, k }, { 1, 0, 0 }, { 0, 1, 0 }, in);
        }
      }
    }
  }
  return squares.Faces;
}

} // namespace fuzz
