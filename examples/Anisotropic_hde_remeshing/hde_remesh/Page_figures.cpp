// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Page_figures.h"
#include "Signed_distance.h"

#include <boost/histogram.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace hde_remesh {

namespace {

typedef nlohmann::ordered_json Json;
typedef std::vector<double> Values;

constexpr unsigned int number_of_bins = 60;

// the absolute value that this share of the finite ones does not exceed
double quantile_of_sizes(Values values, const double share)
{
  values.erase(std::remove_if(values.begin(), values.end(), [](const double x) { return !std::isfinite(x); }), values.end());
  if (values.empty())
    return 0;
  const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), place, values.end(),
                   [](const double a, const double b) { return std::abs(a) < std::abs(b); });
  return std::abs(*place);
}

Values divided(Values values, const double divisor)
{
  for (double& value : values)
    value /= divisor;
  return values;
}

// so that it is never empty
Scale scale_of(const Values& values, const double low, const double least_high, const bool is_logarithmic)
{
  return {low, (std::max)(least_high, quantile_of_sizes(values, 0.99)), is_logarithmic};
}

Scale signed_scale_of(const Values& values)
{
  const double high = (std::max)(1e-12, quantile_of_sizes(values, 0.99));
  return {-high, high, false};
}

template <typename Axis>
std::vector<std::size_t> counts(const Values& values, const Axis& axis)
{
  auto histogram = boost::histogram::make_histogram_with(std::vector<std::size_t>(), axis);
  for (const double value : values)
    if (!std::isnan(value))
      histogram(value);
  std::vector<std::size_t> result;
  result.reserve(number_of_bins);
  for (int i = 0; i < int(number_of_bins); ++i)
    result.push_back(histogram.at(i));
  result.front() += histogram.at(-1);
  result.back() += histogram.at(int(number_of_bins));
  return result;
}

std::vector<std::size_t> counts(const Values& values, const Scale& scale)
{
  namespace axis = boost::histogram::axis;
  if (scale.is_logarithmic)
    return counts(values, axis::regular<double, axis::transform::log>(number_of_bins, scale.low, scale.high));
  return counts(values, axis::regular<double>(number_of_bins, scale.low, scale.high));
}

Json histogram(const std::string& title, const std::string& unit, const Values& before, const Values& after, const Scale& scale)
{
  return {{"title", title},
          {"unit", unit},
          {"low", scale.low},
          {"high", scale.high},
          {"logarithmic", scale.is_logarithmic},
          {"before", counts(before, scale)},
          {"after", counts(after, scale)}};
}

Page_figure aspect_ratio(const Element_figures& before, const Element_figures& after)
{
  return {"aspect_ratio",
          "aspect ratio",
          "",
          "largest",
          before.aspect_ratios,
          after.aspect_ratios,
          scale_of(before.aspect_ratios, 1, 2, true),
          scale_of(after.aspect_ratios, 1, 2, true)};
}

Page_figure smallest_angle(const Element_figures& before, const Element_figures& after)
{
  const Scale scale = {0, 60, false};
  const bool is_6d = before.is_by_function;
  return {is_6d ? "smallest_angle_6d" : "smallest_angle",
          is_6d ? "least 6D angle" : "least angle",
          "\u00b0",
          "least",
          before.smallest_angles,
          after.smallest_angles,
          scale,
          scale};
}

Page_figure distance_to_zero_set(const Element_figures& before, const Element_figures& after, const double diagonal)
{
  const Values of_before = divided(before.face_distances, diagonal), of_after = divided(after.face_distances, diagonal);
  return {"distance_to_zero_set",
          "distance to the zero set",
          " D",
          "largest",
          of_before,
          of_after,
          scale_of(of_before, 0, 1e-12, false),
          scale_of(of_after, 0, 1e-12, false)};
}

Page_figure distance_to_other_mesh(const Mesh& before, const Mesh& after, const double diagonal)
{
  const Values of_before = divided(signed_distances(before, after), diagonal),
               of_after = divided(signed_distances(after, before), diagonal);
  return {"signed_distance",
          "signed distance to the other mesh",
          " D",
          "absolute",
          of_before,
          of_after,
          signed_scale_of(of_before),
          signed_scale_of(of_after)};
}

} // namespace

Scale Page_figure::common_scale() const
{
  return {(std::min)(scale_before.low, scale_after.low), (std::max)(scale_before.high, scale_after.high),
          scale_after.is_logarithmic};
}

std::vector<Page_figure> page_figures(const Measured_elements& before, const Measured_elements& after, const double diagonal)
{
  std::vector<Page_figure> result = {aspect_ratio(before.figures, after.figures),
                                     smallest_angle(before.figures, after.figures)};
  if (before.figures.is_by_function)
    result.push_back(distance_to_zero_set(before.figures, after.figures, diagonal));
  result.push_back(distance_to_other_mesh(before.mesh, after.mesh, diagonal));
  return result;
}

Json to_json(const Page_figure& figure)
{
  return {{"key", figure.key},
          {"title", figure.title},
          {"unit", figure.unit},
          {"worst", figure.worst},
          {"logarithmic", figure.scale_after.is_logarithmic},
          {"range_before", {figure.scale_before.low, figure.scale_before.high}},
          {"range_after", {figure.scale_after.low, figure.scale_after.high}}};
}

Json histograms(const std::vector<Page_figure>& figures, const Report& report, const Element_figures& before,
                const Element_figures& after)
{
  Json result;
  for (const Page_figure& figure : figures)
    result.push_back(histogram(figure.title, figure.unit, figure.before, figure.after, figure.common_scale()));
  const double length = report.result.target_edge_length;
  if (report.has_6d_lengths && length > 0)
    result.push_back(histogram("6D edge length over that aimed at", "", divided(before.edge_lengths, length),
                               divided(after.edge_lengths, length), {0, 2.5, false}));
  return result;
}

} // namespace hde_remesh
