// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/AreaApproach.h"

#include "Areas/TargetAreas.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{

// The length of a step. A compromise: where the logarithms differ by 3, 93.2, 94.7 and 95.7 % of the
// faces of a folded brain were within 2 % after 5, 10 and 20 steps.
constexpr double LogAreaStep = 0.3;
// A limit of the time.
constexpr int MostAreaSteps = 100;

} // namespace

AreaApproach::AreaApproach(const Points2& positions,
  const FaceMatrix& faces,
  const Eigen::VectorXd& targets)
  : First(signedFaceAreas(positions, faces).array().max(std::numeric_limits<double>::min()).log())
  , Last(targets.array().log())
{
}

double AreaApproach::distance() const
{
  const Eigen::ArrayXd ratios = this->First - this->Last;
  const Eigen::ArrayXd weights = this->Last.exp() / this->Last.exp().sum();
  return std::sqrt((weights * (ratios - (weights * ratios).sum()).square()).sum());
}

int AreaApproach::steps() const
{
  return std::clamp(static_cast<int>(std::ceil(this->distance() / LogAreaStep)), 1, MostAreaSteps);
}

Eigen::VectorXd AreaApproach::targets(double share, double area) const
{
  return scaledTargets(((1.0 - share) * this->First + share * this->Last).exp().matrix(), area);
}

} // namespace flattening
