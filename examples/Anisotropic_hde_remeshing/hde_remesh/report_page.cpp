// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "report_page.h"
#include "page_mesh.h"
#include "report_page_template.h"
#include "table_rows.h"
#include "verdict.h"

#include <CGAL/Bbox_3.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hde_remesh {

namespace {

typedef nlohmann::ordered_json Json;

constexpr std::size_t largest_number_of_shown_faces = 150000;

Json to_json(const std::vector<Table_row>& rows)
{
  Json json = Json::array();
  for (const Table_row& row : rows)
    json.push_back({row.name, row.before, row.after});
  return json;
}

Json to_json(const std::vector<Verdict_line>& lines)
{
  Json json = Json::array();
  for (const Verdict_line& line : lines)
    json.push_back({line.name, line.text});
  return json;
}

void add_meshes(const Mesh& before, const Mesh& after, const std::vector<Page_figure>& figures, Json& json)
{
  std::vector<Face_figure> of_before, of_after;
  for (const Page_figure& figure : figures)
  {
    of_before.push_back({figure.key, figure.before, figure.scale_before.is_logarithmic});
    of_after.push_back({figure.key, figure.after, figure.scale_after.is_logarithmic});
  }
  const CGAL::Bbox_3 box =
      CGAL::bbox_3(before.points().begin(), before.points().end()) + CGAL::bbox_3(after.points().begin(), after.points().end());
  json["box"] = {{"low", {box.xmin(), box.ymin(), box.zmin()}}, {"high", {box.xmax(), box.ymax(), box.zmax()}}};
  json["before"] = page_mesh(before, box, of_before, largest_number_of_shown_faces);
  json["after"] = page_mesh(after, box, of_after, largest_number_of_shown_faces);
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

std::string with_data(const std::string& page, const std::string& data)
{
  const std::string place = "@DATA@";
  const std::size_t at = page.find(place);
  return page.substr(0, at) + data + page.substr(at + place.size());
}

} // namespace

std::string report_page(const Report& report, const std::string& command_line, const Measured_elements& before,
                        const Measured_elements& after)
{
  const std::vector<Page_figure> figures = page_figures(before, after, report.diagonal);
  Json json = {{"report", Json::parse(to_json(report))},
               {"verdict", to_json(verdict(report))},
               {"table", to_json(table_rows(report))},
               {"command_line", command_line},
               {"histograms", histograms(figures, report, before.figures, after.figures)}};
  for (const Page_figure& figure : figures)
    json["figures"].push_back(to_json(figure));
  add_meshes(before.mesh, after.mesh, figures, json);
  return with_data(report_page_template, in_html(json));
}

} // namespace hde_remesh
