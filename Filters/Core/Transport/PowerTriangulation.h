// SPDX-License-Identifier: GPL-3.0-or-later
/// The regular triangulation of sites with weights of twice the precision of double.
#pragma once

#include "Base/DoubleDouble.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace flattening
{

using SiteKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A site with its weight. The kernel's weighted point, from which it is derived, has the weight rounded
/// to double.
class WeightedSite : public SiteKernel::Weighted_point_2
{
public:
  WeightedSite() = default;
  WeightedSite(double x, double y, const DoubleDouble& weight)
    : SiteKernel::Weighted_point_2(SiteKernel::Point_2(x, y), weight.high())
    , WeightRemainder(weight.low())
  {
  }
  double weightRemainder() const { return this->WeightRemainder; }

private:
  double WeightRemainder = 0.0;
};

/// CGAL's power test on such sites, exact: evaluated in intervals, and if these do not decide in
/// rational numbers. Coordinates are relative to the last site, which keeps the intervals narrow.
class PowerSideOfSites
{
public:
  template <typename... Sites>
  CGAL::Oriented_side operator()(const Sites&... sites) const
  {
    try
    {
      const CGAL::Protect_FPU_rounding<true> rounding;
      const CGAL::Uncertain<CGAL::Oriented_side> side =
        powerSide<CGAL::Interval_nt_advanced>(last(sites...), sites...);
      if (CGAL::is_certain(side))
      {
        return CGAL::get_certain(side);
      }
    }
    catch (const CGAL::Uncertain_conversion_exception&)
    {
    }
    return powerSide<CGAL::Exact_rational>(last(sites...), sites...);
  }

private:
  template <typename Number, typename... Sites>
  static auto powerSide(const WeightedSite& origin, const Sites&... sites)
  {
    using Kernel = CGAL::Simple_cartesian<Number>;
    const auto relative = [&origin](const WeightedSite& site)
    {
      return
        typename Kernel::Weighted_point_2(typename Kernel::Point_2(Number(site.x()) - Number(origin.x()),
                                            Number(site.y()) - Number(origin.y())),
          (Number(site.weight()) - Number(origin.weight())) +
            (Number(site.weightRemainder()) - Number(origin.weightRemainder())));
    };
    return typename Kernel::Power_side_of_oriented_power_circle_2()(relative(sites)...);
  }
  static const WeightedSite& last(const WeightedSite& site) { return site; }
  template <typename... Sites>
  static const WeightedSite& last(const WeightedSite&, const Sites&... sites)
  {
    return last(sites...);
  }
};

struct PowerTriangulationTraits : SiteKernel
{
  using Weighted_point_2 = WeightedSite;
  using Power_side_of_oriented_power_circle_2 = PowerSideOfSites;
  Power_side_of_oriented_power_circle_2 power_side_of_oriented_power_circle_2_object() const
  {
    return {};
  }
};

/// Vertices carry the site's number, faces a number of their own.
using PowerTriangulation = CGAL::Regular_triangulation_2<PowerTriangulationTraits,
  CGAL::Triangulation_data_structure_2<
    CGAL::Triangulation_vertex_base_with_info_2<int,
      PowerTriangulationTraits,
      CGAL::Regular_triangulation_vertex_base_2<PowerTriangulationTraits>>,
    CGAL::Triangulation_face_base_with_info_2<int,
      PowerTriangulationTraits,
      CGAL::Regular_triangulation_face_base_2<PowerTriangulationTraits>>>>;

} // namespace flattening
