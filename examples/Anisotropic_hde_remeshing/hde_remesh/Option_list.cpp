// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Option_list.h"
#include "Failure.h"
#include "Text_reader.h"
#include "kernels.h"

#include <charconv>

namespace hde_remesh {

namespace {

bool read_number(const std::string& text, std::optional<double>& target)
{
  double value = 0;
  if (text.empty() || !Text_reader::to_number(text, value))
    return false;
  target = value;
  return true;
}

bool read_count(const std::string& text, std::optional<long long>& target)
{
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    return false;
  target = value;
  return true;
}

// "a, b or c"
std::string in_words(const std::vector<std::string>& choices)
{
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i)
    text += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + choices[i];
  return text;
}

} // namespace

Option_list::Option_list(CLI::App& app, Options& options) : m_app(app), m_options(options)
{
  app.add_option("IN", options.input);
  app.add_option("OUT", options.output);
  add_sizes();
  add_embedding();
  add_remeshing();
  add_input();
  add_points();
  add_function();
  add_output();
  add_help();
}

void Option_list::fail(const std::string& option, const std::string& text) const
{
  const std::string quoted = excerpt(text);
  throw Failure(option + " needs " + need_of(option) + ", got " +
                    (text.empty() ? "nothing" : quoted.substr(1, quoted.size() - 2)),
                STATUS_USAGE);
}

void Option_list::add(const std::string& option, const char* value, const std::string& need, const char* meaning,
                      const Reader& read)
{
  m_needs[option] = need;
  const auto read_or_fail = [this, option, read](const std::string& text)
  {
    if (!read(text))
      fail(option, text);
  };
  m_app.add_option_function<std::string>(option, read_or_fail, meaning)->type_name(value)->group(m_group);
}

void Option_list::add_number(const std::string& option, const char* value, std::optional<double>& target, const char* meaning)
{
  add(option, value, "a number", meaning, [&target](const std::string& text) { return read_number(text, target); });
}

void Option_list::add_number_or_auto(const std::string& option, std::optional<double>& target, bool& is_automatic,
                                     const char* meaning)
{
  const auto read = [&target, &is_automatic](const std::string& text)
  {
    is_automatic = text == "auto";
    return is_automatic || read_number(text, target);
  };
  add(option, "X|auto", "a number or auto", meaning, read);
}

void Option_list::add_count(const std::string& option, std::optional<long long>& target, const char* meaning)
{
  add(option, "N", "a whole number", meaning, [&target](const std::string& text) { return read_count(text, target); });
}

void Option_list::add_text(const std::string& option, const char* value, const std::string& need, std::string& target,
                           const char* meaning)
{
  const auto read = [&target](const std::string& text)
  {
    target = text;
    return !text.empty();
  };
  add(option, value, need, meaning, read);
}

void Option_list::add_choice(const std::string& option, const std::vector<std::string>& choices, std::string& target,
                             const char* meaning)
{
  const auto read = [&target, choices](const std::string& text)
  {
    target = text;
    return std::find(choices.begin(), choices.end(), text) != choices.end();
  };
  add(option, "NAME", in_words(choices), meaning, read);
}

void Option_list::add_flag(const std::string& option, bool& target, const char* meaning)
{
  m_app.add_flag(option, target, meaning)->group(m_group);
}

void Option_list::add_sizes()
{
  Options& o = m_options;
  m_group = "How many triangles";
  add_count("--faces", o.faces, "number of triangles to aim at (default: as many as IN has)");
  add_count("--vertices", o.vertices, "number of vertices to aim at, instead");
  add_number("--length", "L", o.length, "edge length to aim at, instead; it is one in 6D, see --help-all");
  add_number("--error", "E", o.error, "largest distance between IN and OUT, both ways, over D: as few triangles as keep it");
  add_number("--absolute-error", "L", o.absolute_error, "the same in the unit of the mesh");
  add_flag("--fit", o.fit, "move the vertices off the surface in the end, to where the distance is least");
  add_number("--aspect-ratio", "Q", o.aspect_ratio,
             "for a mesh to compute on: the longest edge is at most Q times the altitude on it, where possible; 5 is "
             "usual, an equilateral triangle has 1.15; not by an embedding");
  add_number("--shape-weight", "W", o.shape_weight,
             "what long triangles cost, 0 for the least distance (default 2; with --fit 0.1); not by an embedding");
}

void Option_list::add_embedding()
{
  Options& o = m_options;
  m_group = "Where triangles are small and thin";
  add_number_or_auto("--sigma", o.sigma, o.adaptive_sigma,
                     "even triangles in 6D, see --help-all: X is the weight of the normals over D, 0 or more (default 0.01); "
                     ".005 to .05 suits scans, .05 to .3 smooth shapes; auto: by the curvature");
  add_number("--absolute-sigma", "X", o.absolute_sigma, "the same in the unit of the mesh");
  const auto read_metric = [&o](const std::string& text) { return read_number(text, o.metric); };
  add("--metric", "P|inf", "a number or inf",
      "in place of sigma: the metric of the curvature that makes the distance to the surface least in the norm L^P; P "
      "from 1 to inf, for the largest distance",
      read_metric);
  add_text("--field", "NAME", "the name of a property", o.field,
           "a vertex property of IN, a PLY file: triangles are small where it varies, too");
  add_number("--tau", "W", o.tau, "weight of the field: at 1 its range counts as D (default 0.1)");
}

void Option_list::add_remeshing()
{
  Options& o = m_options;
  m_group = "The remeshing";
  add_number("--sharp", "ANGLE", o.sharp,
             "keep edges at which triangles of IN turn by ANGLE degrees or more, and their corners; 20 to 40 suits "
             "machine parts (default: none)");
  add_choice("--scheme", {"default", "measured-error", "embedding", "paper"}, o.scheme,
             "measured-error: the least distance to IN, whose triangles are split first if there are fewer than asked "
             "for. embedding: even triangles in 6D, with vertices on the smooth surface. paper: the same by Algorithm 2 "
             "of Dassi, Farrell and Si. default: see the beginning");
  add_count("--iterations", o.iterations, "number of iterations");
  add_count("--relaxation-steps", o.relaxation_steps, "smoothing passes in an iteration");
  add_number("--smoothing-ratio", "X", o.smoothing_ratio, "share of the vertices that are smoothed, from 0 to 1");
  add_number("--collapse-ratio", "X", o.collapse_ratio, "edges shorter than X times the length are contracted; up to 1");
  add_number("--split-ratio", "X", o.split_ratio, "edges longer than X times the length are split; from 1 to 100");
  m_app
      .add_flag("--avoid-self-intersections,!--allow-self-intersections", o.avoid_self_intersections,
                "let no more triangles intersect than do so in IN (default), or do not test it")
      ->group(m_group);
  add_count("--threads", o.threads, "use at most N threads (default: all); the result is the same");
}

void Option_list::add_input()
{
  Options& o = m_options;
  m_group = "The input";
  add_flag("--repair", o.repair,
           "mend IN first: join equal points, close cracks, remove double faces and walls inside, turn faces alike, divide "
           "polygons, untangle faces that intersect");
  add_number("--merge", "L", o.merge,
             "points of IN that are no further apart than L, in the unit of the mesh, become one where this joins "
             "boundary edges (default for STL files and with --repair: 4 units in the last place of the coordinates)");
}

void Option_list::add_points()
{
  Options& o = m_options;
  m_group = "Points";
  m_app
      .add_flag("--detect-outliers,!--keep-outliers", o.detect_outliers,
                "leave out points that their neighbours contradict, and turn or drop such normals (default), or not")
      ->group(m_group);
  add_number("--trim", "L", o.trim,
             "points only: cut the surface off further than L from all points (default: it is closed); at least two "
             "spacings of the points");
  add_flag("--keep-largest", o.keep_largest, "remove all components of the surface but the one with the most triangles");
}

void Option_list::add_function()
{
  Options& o = m_options;
  m_group = "The smooth function";
  add_choice("--kernel", names_of_kernels(), o.kernel, "radial function: r3 by default; thin-plate is r^2 log r");
  add_number("--shape", "X", o.shape,
             "width of the kernel, or radius of its support, in local edge lengths; r3 and thin-plate have none");
  add_count("--patches", o.patches, "number of overlapping patches (default: one for 25 points)");
  add_number("--overlap", "X", o.overlap, "how far a patch gathers vertices beyond its part, in local edge lengths");
  add_number("--offset", "L", o.offset,
             "distance of the points off the surface, in the unit of the mesh (default: a share of the local edge length)");
  add_number_or_auto("--smoothing", o.smoothing, o.automatic_smoothing,
                     "noise of the vertices, a standard deviation in the unit of the mesh; auto: estimated (default: 0, "
                     "of points auto)");
  add_flag("--smooth-edges", o.smooth_edges,
           "where triangles turn by more than 57 degrees, take normals between theirs; the surface swells there");
  add_flag("--vertices-only", o.vertices_only,
           "put no points on facets that are large for what is around them; the surface swells there");
}

void Option_list::add_output()
{
  Options& o = m_options;
  m_group = "What is printed and written";
  add_text("--report", "FILE", "the name of a file", o.report, "write a page for browsers: figures, histograms, both meshes");
  add_text("--json", "FILE", "the name of a file, or -", o.json,
           "write all figures to FILE as JSON; -: to the standard output, without the table");
  add_flag("--details", o.details, "print all figures, not only the most important ones");
  add_flag("--arrays", o.arrays,
           "write figures of each triangle and vertex into OUT, a PLY or VTP file: aspect ratio, least angle, distance, "
           "normal");
  add_flag("--self-intersections", o.self_intersections, "count the pairs of triangles that intersect, before and after");
  add_flag("--no-distance", o.no_distance, "do not measure the distance between IN and OUT");
  add_flag("-q,--quiet", o.quiet, "print nothing but errors");
}

void Option_list::add_help()
{
  m_app.set_help_flag("-h,--help", "print the most important options")->group("Help");
  m_app.set_help_all_flag("--help-all", "print all options, by groups, and how the program works")->group("Help");
  m_app.set_version_flag("--version", version_text(), "print the versions of the program and of CGAL")->group("Help");
}

} // namespace hde_remesh
