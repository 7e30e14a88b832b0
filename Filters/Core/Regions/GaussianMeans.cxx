// SPDX-License-Identifier: GPL-3.0-or-later
#include "Regions/GaussianMeans.h"

#include "Base/Errors.h"

#include <Eigen/Geometry>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// The width of a bin in deviations. A bin is a little wider than the deviation, so that a ball of radius
// two deviations and the cells on its rim reach into two bins on each side; cells are a whole fraction
// of a bin.
constexpr double BinWidth = 1.1;
// The number of bins on each side that a ball reaches into; follows from BinWidth.
constexpr int Reach = 2;
// The greatest number of bins per axis, so that the number of a bin fits into 64 bits.
constexpr std::int64_t MaxBins = 1 << 18;
// The greatest number of cells per axis of a bin; a smaller spacing gets cells of a sixteenth of a bin.
constexpr int MaxCells = 16;
// In a bin with more points the octants are evaluated one by one, each with fewer neighbours; concerns
// speed alone.
constexpr int ManyPoints = 48;

// A point, or the points of a cell taken together.
struct Sample
{
  Eigen::RowVector3d Position; // centre of mass
  double Mass;
  double Integral;
  bool IsPoint; // whether it is a single point
};

// The samples around a point, in single precision relative to a centre nearby.
struct Neighbours
{
  Eigen::ArrayXf X, Y, Z, Mass, Integral;
  Eigen::ArrayXf Slope;  // slope of the share of the sample in a ball over the squared distance
  Eigen::ArrayXf Share;  // share of the sample in the ball of the last query
  Eigen::ArrayXf Weight; // Gaussian of the last query

  void resize(Eigen::Index count)
  {
    for (Eigen::ArrayXf* array :
      { &this->X, &this->Y, &this->Z, &this->Mass, &this->Integral, &this->Slope })
    {
      array->conservativeResize(count);
    }
    this->Share.resize(count);
    this->Weight.resize(count);
  }

  // Sets Weight to the Gaussian at distances from @p x below twice the deviation, and to 0 beyond. The
  // loop has no branches, so that the compiler vectorises it.
  void weigh(const Eigen::RowVector3f& x, float deviation)
  {
    const float radius2 = 4.0f * deviation * deviation;
    const float scale = 1.0f / (8.0f * deviation * deviation); // a quarter of the exponent
    const Eigen::Index count = this->X.size();
    const float* xs = this->X.data();
    const float* ys = this->Y.data();
    const float* zs = this->Z.data();
    const float* slopes = this->Slope.data();
    float* shares = this->Share.data();
    float* weights = this->Weight.data();
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const float dx = xs[i] - x[0];
      const float dy = ys[i] - x[1];
      const float dz = zs[i] - x[2];
      const float distance2 = dx * dx + dy * dy + dz * dz;
      // exp(-u) for u in [0, 1/2], by its series around 1/4; the fourth power is the Gaussian.
      const float t = 0.25f - scale * distance2;
      const float series =
        1.0f + t * (1.0f + t * (0.5f + t * (1.0f / 6 + t * (1.0f / 24 + t * (1.0f / 120)))));
      const float root = 0.77880078f * series;
      const float square = root * root;
      shares[i] = 0.5f + slopes[i] * (radius2 - distance2);
      weights[i] = square * square;
    }
    this->Weight *= this->Share.cwiseMax(0.0f).cwiseMin(1.0f);
  }
};

class BinnedSamples
{
public:
  BinnedSamples(const WeightedPoints& points, double deviation, double spacing)
    : Points(points)
    , Deviation(deviation)
    , Low(points.Positions.colwise().minCoeff())
    , CellsPerBin(
        spacing > 0.0 ? std::clamp(static_cast<int>(std::lround(BinWidth / spacing)), 1, MaxCells) : 1)
    , Cell(BinWidth * deviation / this->CellsPerBin)
    , Ramp(1.0 / (4.0 * deviation * this->Cell))
    , Rim2(4.0 * deviation * deviation + (spacing > 0.0 ? 0.5 / this->Ramp : 0.0))
  {
    const Eigen::RowVector3d extent = points.Positions.colwise().maxCoeff() - this->Low;
    if (!(deviation > 0.0) ||
        extent.maxCoeff() / deviation > static_cast<double>(MaxBins - 2 * Reach - 2))
    {
      throw InvalidInput("means over a distance of " + formatted(deviation) +
                         " cannot be computed on a surface of extent " + formatted(extent.maxCoeff()) +
                         ": choose a larger scale");
    }
    this->sortPoints();
    this->gatherSamples(spacing > 0.0);
  }

  int binCount() const { return static_cast<int>(this->Bins.size()); }

  // Computes the means at the points of a bin.
  void evaluate(int bin, Neighbours& around, Eigen::VectorXd& means) const
  {
    const auto first = this->Order.begin() + this->PointStarts[bin];
    const auto last = this->Order.begin() + this->PointStarts[bin + 1];
    const std::vector<std::pair<int, int>> ranges = this->samplesAround(this->Bins[bin]);
    if (last - first <= ManyPoints)
    {
      this->evaluate({ first, last }, ranges, around, means);
      return;
    }
    std::array<std::vector<int>, 8> octants;
    for (auto point = first; point != last; ++point)
    {
      const int cell = this->CellOfOrder[point - this->Order.begin()];
      const auto upper = [&](int place) { return 2 * place >= this->CellsPerBin ? 1 : 0; };
      octants[4 * upper(cell / (MaxCells * MaxCells)) + 2 * upper(cell / MaxCells % MaxCells) +
              upper(cell % MaxCells)]
        .push_back(*point);
    }
    for (const std::vector<int>& points : octants)
    {
      if (!points.empty())
      {
        this->evaluate(points, ranges, around, means);
      }
    }
  }

private:
  std::int64_t binNumber(std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    return (x * MaxBins + y) * MaxBins + z;
  }

  void sortPoints()
  {
    const int n = static_cast<int>(this->Points.Positions.rows());
    struct Place
    {
      std::int64_t Bin;
      int Cell;
      int Point;
      bool operator<(const Place& other) const
      {
        return std::tie(this->Bin, this->Cell, this->Point) <
               std::tie(other.Bin, other.Cell, other.Point);
      }
    };
    std::vector<Place> places(n);
    tbb::parallel_for(0,
      n,
      [&](int v)
      {
        std::int64_t bin[3];
        int within[3];
        for (int k = 0; k < 3; ++k)
        {
          const auto place =
            static_cast<std::int64_t>((this->Points.Positions(v, k) - this->Low[k]) / this->Cell);
          bin[k] = place / this->CellsPerBin + Reach;
          within[k] = static_cast<int>(place % this->CellsPerBin);
        }
        places[v] = { this->binNumber(bin[0], bin[1], bin[2]),
          (within[0] * MaxCells + within[1]) * MaxCells + within[2],
          v };
      });
    tbb::parallel_sort(places.begin(), places.end());
    this->Order.resize(n);
    this->CellOfOrder.resize(n);
    for (int i = 0; i < n; ++i)
    {
      this->Order[i] = places[i].Point;
      this->CellOfOrder[i] = places[i].Cell;
      if (i == 0 || places[i].Bin != places[i - 1].Bin)
      {
        this->Bins.push_back(places[i].Bin);
        this->PointStarts.push_back(i);
      }
    }
    this->PointStarts.push_back(n);
  }

  void gatherSamples(bool together)
  {
    this->SampleStarts.assign(1, 0);
    for (int bin = 0; bin < this->binCount(); ++bin)
    {
      const int end = this->PointStarts[bin + 1];
      for (int first = this->PointStarts[bin], next = first; first < end; first = next)
      {
        next = first + 1;
        while (together && next < end && this->CellOfOrder[next] == this->CellOfOrder[first])
        {
          ++next;
        }
        this->addSample(first, next);
      }
      this->SampleStarts.push_back(static_cast<int>(this->Samples.size()));
    }
  }

  void addSample(int first, int next)
  {
    Sample sample{ Eigen::RowVector3d::Zero(), 0.0, 0.0, next == first + 1 };
    for (int i = first; i < next; ++i)
    {
      const int v = this->Order[i];
      const double mass = this->Points.Mass[v];
      sample.Position += mass * this->Points.Positions.row(v);
      sample.Mass += mass;
      sample.Integral += this->Points.Integral[v];
    }
    if (sample.Mass > 0.0)
    {
      sample.Position /= sample.Mass;
      this->Samples.push_back(sample);
    }
  }

  // The samples in the bins around a bin as ranges; bins along z follow each other.
  std::vector<std::pair<int, int>> samplesAround(std::int64_t bin) const
  {
    std::vector<std::pair<int, int>> ranges;
    for (int dx = -Reach; dx <= Reach; ++dx)
    {
      for (int dy = -Reach; dy <= Reach; ++dy)
      {
        const std::int64_t middle = bin + this->binNumber(dx, dy, 0);
        const auto low = std::lower_bound(this->Bins.begin(), this->Bins.end(), middle - Reach);
        const auto high = std::upper_bound(low, this->Bins.end(), middle + Reach);
        const int first = this->SampleStarts[low - this->Bins.begin()];
        const int last = this->SampleStarts[high - this->Bins.begin()];
        if (first < last)
        {
          ranges.emplace_back(first, last);
        }
      }
    }
    return ranges;
  }

  void evaluate(const std::vector<int>& points,
    const std::vector<std::pair<int, int>>& ranges,
    Neighbours& around,
    Eigen::VectorXd& means) const
  {
    const Eigen::RowVector3d centre = this->Points.Positions.row(points.front());
    this->gatherNeighbours(points, ranges, centre, around);
    const auto deviation = static_cast<float>(this->Deviation);
    for (const int v : points)
    {
      around.weigh((this->Points.Positions.row(v) - centre).cast<float>(), deviation);
      const double mass = (around.Weight * around.Mass).sum();
      means[v] = mass > 0.0 ? (around.Weight * around.Integral).sum() / mass : 0.0;
    }
  }

  // Copies the samples that can be in the ball around one of the points.
  void gatherNeighbours(const std::vector<int>& points,
    const std::vector<std::pair<int, int>>& ranges,
    const Eigen::RowVector3d& centre,
    Neighbours& around) const
  {
    Eigen::AlignedBox<double, 3> box;
    for (const int v : points)
    {
      box.extend(this->Points.Positions.row(v).transpose());
    }
    // A cell on the rim of a ball is in it by a share that falls from 1 to 0 over the cell's width; a
    // point is in it or not.
    const auto ramp = static_cast<float>(this->Ramp);
    const float step = 1e30f;
    const double reach2 = this->Rim2 * (1.0 + 1e-5); // a margin for the rounding of single precision
    Eigen::Index count = 0;
    for (const auto& [first, last] : ranges)
    {
      count += last - first;
    }
    around.resize(count);
    Eigen::Index i = 0;
    for (const auto& [first, last] : ranges)
    {
      for (int s = first; s < last; ++s)
      {
        const Sample& sample = this->Samples[s];
        if (box.squaredExteriorDistance(sample.Position.transpose()) > reach2)
        {
          continue;
        }
        around.X[i] = static_cast<float>(sample.Position[0] - centre[0]);
        around.Y[i] = static_cast<float>(sample.Position[1] - centre[1]);
        around.Z[i] = static_cast<float>(sample.Position[2] - centre[2]);
        around.Mass[i] = static_cast<float>(sample.Mass);
        around.Integral[i] = static_cast<float>(sample.Integral);
        around.Slope[i] = sample.IsPoint ? step : ramp;
        ++i;
      }
    }
    around.resize(i);
  }

  const WeightedPoints& Points;
  double Deviation;
  Eigen::RowVector3d Low;
  int CellsPerBin;
  double Cell;                    // width of a cell
  double Ramp;                    // slope of the share of a cell in a ball over the squared distance
  double Rim2;                    // squared distance beyond which that share is 0
  std::vector<int> Order;         // the points, sorted by bin and cell
  std::vector<int> CellOfOrder;   // the cell of each of them within its bin
  std::vector<std::int64_t> Bins; // numbers of the bins that have points, ascending
  std::vector<int> PointStarts;   // first point of each bin in Order
  std::vector<int> SampleStarts;  // first sample of each bin in Samples
  std::vector<Sample> Samples;
};

} // namespace

Eigen::VectorXd gaussianMeans(const WeightedPoints& points,
  double deviation,
  double spacing,
  const ProgressCallback& progress)
{
  Eigen::VectorXd means = Eigen::VectorXd::Zero(points.Positions.rows());
  if (means.size() == 0)
  {
    return means;
  }
  const BinnedSamples samples(points, deviation, spacing);
  constexpr int rounds = 10; // progress is reported between them, from the calling thread
  for (int round = 0; round < rounds; ++round)
  {
    report(progress, static_cast<double>(round) / rounds, "Averaging");
    const auto bins = static_cast<std::int64_t>(samples.binCount());
    tbb::parallel_for(
      tbb::blocked_range<int>(
        static_cast<int>(bins * round / rounds), static_cast<int>(bins * (round + 1) / rounds), 8),
      [&](const tbb::blocked_range<int>& range)
      {
        Neighbours around;
        for (int bin = range.begin(); bin < range.end(); ++bin)
        {
          samples.evaluate(bin, around, means);
        }
      });
  }
  return means;
}

} // namespace flattening
