// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "report_page.h"
#include "Shown_mesh.h"
#include "base64.h"
#include "report_page_template.h"

#include <CGAL/Bbox_3.h>

#include <boost/histogram.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

typedef nlohmann::ordered_json Json;
typedef std::vector<double> Values;

constexpr std::size_t largest_number_of_shown_faces = 150000; // about 40 bytes of the page each
constexpr unsigned int number_of_bins = 60;

// how a figure is coloured and counted: from `low` to `high`, the last bin and colour stand for more
struct Scale
{
  double low, high;
  bool logarithmic;
};

// the value that this share of the finite ones does not exceed
double quantile(Values values, const double share)
{
  values.erase(std::remove_if(values.begin(), values.end(), [](const double x) { return !std::isfinite(x); }), values.end());
  if (values.empty())
    return 0;
  const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
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
  if (scale.logarithmic)
    return counts(values, axis::regular<double, axis::transform::log>(number_of_bins, scale.low, scale.high));
  return counts(values, axis::regular<double>(number_of_bins, scale.low, scale.high));
}

Json histogram(const std::string& title, const std::string& unit, const Values& before, const Values& after, const Scale& scale)
{
  return {{"title", title},
          {"unit", unit},
          {"low", scale.low},
          {"high", scale.high},
          {"logarithmic", scale.logarithmic},
          {"before", counts(before, scale)},
          {"after", counts(after, scale)}};
}

Values divided(Values values, const double divisor)
{
  for (double& value : values)
    value /= divisor;
  return values;
}

// so that both meshes fit, hardly any outlier is cut, and the scale is never empty
Scale common_scale(const Values& before, const Values& after, const double low, const double least_high, const bool logarithmic)
{
  return Scale{low, (std::max)({least_high, quantile(before, 0.99), quantile(after, 0.99)}), logarithmic};
}

// The names and scales of what the faces are coloured by.
struct Figure
{
  std::string key, title, unit;
  Values before, after;
  Scale scale;

  Json to_json() const
  {
    return {{"key", key},       {"title", title},     {"unit", unit},
            {"low", scale.low}, {"high", scale.high}, {"logarithmic", scale.logarithmic}};
  }
};

std::vector<Figure> figures_of_faces(const Element_figures& before, const Element_figures& after, const double diagonal)
{
  std::vector<Figure> result;
  result.push_back({"aspect_ratio", "aspect ratio", "", before.aspect_ratios, after.aspect_ratios,
                    common_scale(before.aspect_ratios, after.aspect_ratios, 1, 2, true)});
  result.push_back({"smallest_angle",
                    before.is_by_function ? "least 6D angle" : "least angle",
                    "\u00b0",
                    before.smallest_angles,
                    after.smallest_angles,
                    {0, 60, false}});
  const Values distances_before = divided(before.face_distances, diagonal),
               distances_after = divided(after.face_distances, diagonal);
  result.push_back({"distance", before.is_by_function ? "distance to the surface" : "distance to the other mesh", " D",
                    distances_before, distances_after, common_scale(distances_before, distances_after, 0, 1e-12, false)});
  return result;
}

std::vector<float> to_floats(const Values& values, const std::vector<std::size_t>& places)
{
  const double largest = double((std::numeric_limits<float>::max)());
  std::vector<float> result;
  result.reserve(places.size());
  for (const std::size_t i : places)
    result.push_back(float((std::min)(values[i], largest)));
  return result;
}

// in the ball of radius one about the middle of the bounding box
Json to_json(const Shown_mesh& shown, const CGAL::Bbox_3& box,
             const std::vector<std::pair<std::string, const Values*>>& figures)
{
  const double radius = 0.5 * std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  std::vector<float> points;
  for (const Point_3& p : shown.soup.points)
    for (int i = 0; i < 3; ++i)
      points.push_back(float((p[i] - 0.5 * ((box.min)(i) + (box.max)(i))) / radius));
  std::vector<std::uint32_t> faces;
  for (const std::vector<std::size_t>& face : shown.soup.faces)
    for (const std::size_t v : face)
      faces.push_back(std::uint32_t(v));
  Json json = {{"number_of_faces", shown.number_of_faces},
               {"number_of_shown_faces", shown.soup.faces.size()},
               {"is_simplified", shown.is_simplified()},
               {"points", base64(points)},
               {"faces", base64(faces)}};
  for (const auto& [key, values] : figures)
    json["figures"][key] = base64(to_floats(*values, shown.origins));
  return json;
}

Json to_json_of_meshes(const Measured_elements& before, const Measured_elements& after, const std::vector<Figure>& figures)
{
  std::vector<std::pair<std::string, const Values*>> of_before, of_after;
  for (const Figure& figure : figures)
  {
    of_before.emplace_back(figure.key, &figure.before);
    of_after.emplace_back(figure.key, &figure.after);
  }
  const CGAL::Bbox_3 box = CGAL::bbox_3(before.mesh.points().begin(), before.mesh.points().end());
  return {{"before", to_json(shown_mesh(before.mesh, largest_number_of_shown_faces), box, of_before)},
          {"after", to_json(shown_mesh(after.mesh, largest_number_of_shown_faces), box, of_after)}};
}

// no character of it ends the script element that it lies in
std::string in_html(const Json& json)
{
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace), result;
  for (const char c : text)
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  return result;
}

} // namespace

std::string report_page(const Report& report, const std::string& command_line, const Measured_elements& before,
                        const Measured_elements& after)
{
  const std::vector<Figure> figures = figures_of_faces(before.figures, after.figures, report.diagonal);
  Json json = {{"report", Json::parse(to_json(report))}, {"command_line", command_line}};
  for (const Figure& figure : figures)
  {
    json["figures"].push_back(figure.to_json());
    json["histograms"].push_back(histogram(figure.title, figure.unit, figure.before, figure.after, figure.scale));
  }
  const double length = report.result.target_edge_length;
  if (report.has_6d_lengths && length > 0)
    json["histograms"].push_back(histogram("6D edge length over that aimed at", "",
                                           divided(before.figures.edge_lengths, length),
                                           divided(after.figures.edge_lengths, length), {0, 2.5, false}));
  json.update(to_json_of_meshes(before, after, figures));
  const std::string page = report_page_template, place = "@DATA@";
  const std::size_t at = page.find(place);
  return page.substr(0, at) + in_html(json) + page.substr(at + place.size());
}

} // namespace hde_remesh
