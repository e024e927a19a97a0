// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "options.h"
#include "Failure.h"
#include "kernels.h"

#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <sstream>

#ifndef HDE_REMESH_VERSION
#  define HDE_REMESH_VERSION "of unknown version" // the build system knows it
#endif

namespace hde_remesh {

namespace {

const char* help_header()
{
  return "Remeshes the surface of a triangle mesh, or of points, with triangles that follow its curvature.\n\n"
         "If only a number of triangles is given, of at most 3/4 of those of IN, or if these are the\n"
         "long ones of a CAD program, the distance to IN leads, measured both ways. Else it goes as\n"
         "follows.\n\n"
         "The vertices of the mesh IN and their normals give a smooth function, by radial basis\n"
         "functions, whose zero set is the surface. New vertices are put on that surface, not on the\n"
         "flat triangles of IN. Lengths are measured in six dimensions, position and sigma times unit\n"
         "normal: an edge across a bend is longer than one along it, so that triangles of equal 6D\n"
         "edges are short across bends and long along them.\n\n"
         "If IN has points and no faces, a surface is made of them first, closed where points are missing:\n"
         "noise is estimated, outliers are left out, and normals are estimated where there are none. Then\n"
         "IN is the mesh of that surface. Colours and other numbers of points go to OUT, a PLY or VTP file.";
}

const char* help_footer()
{
  return "Formats: OFF, OBJ, PLY and STL, by the extension of the file name, and VTP for OUT only. PLY and\n"
         "STL are written binary; STL keeps 7 digits only. Points come as OFF, OBJ or PLY without faces, or as\n"
         "XYZ: coordinates, then a normal or a colour, then any numbers.\n"
         "Units: lengths are in the unit of the mesh, but --sigma and --error are fractions of the\n"
         "diagonal D of the bounding box of IN. A larger sigma gives longer, thinner triangles along\n"
         "the bends; 0 gives triangles of equal sides everywhere. Useful values of --sigma are .005 to\n"
         ".05 for scans and .05 to .3 for smooth, simple shapes.\n\n"
         "Examples:\n"
         "  hde_remesh bunny.off out.off                         as many triangles as before\n"
         "  hde_remesh bunny.off out.ply --faces 20000           the nearest mesh of so many\n"
         "  hde_remesh bunny.off out.ply --faces 20000 --sigma .02\n"
         "  hde_remesh part.stl out.obj --vertices 5000 --json out.json\n"
         "  hde_remesh scan.obj out.off --length .5 --scheme paper\n"
         "  hde_remesh bunny.off out.off --error .001            within a thousandth of D\n"
         "  hde_remesh bunny.off out.vtp --arrays --report out.html\n"
         "  hde_remesh part.stl out.stl --metric 2 --faces 5000 --fit\n"
         "  hde_remesh part.stl out.stl --sharp 30 --sigma .03   edges and corners are kept\n"
         "  hde_remesh scan.xyz out.ply --faces 20000 --trim .5 --keep-largest\n\n"
         "Exit status: 0 done; 1 the input, a value or the output cannot be used; 2 the command line\n"
         "cannot be understood; 130 cancelled by Ctrl-C. OUT and FILE are written whole or not at all:\n"
         "without exit status 0, files of these names are as they were, but where the message says so.";
}

// `inf` is a number, too
double number_or_infinity(const std::string& text)
{
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value))
    throw CLI::ConversionError("Could not convert: --metric = " + text);
  return value;
}

void add_embedding_options(CLI::App& app, Options& o)
{
  const std::string group = "Where triangles are small and thin";
  auto* sigma = app.add_option_function<std::string>(
                       "--sigma",
                       [&o](const std::string& text)
                       {
                         double value = 0;
                         if (text == "auto")
                           o.adaptive_sigma = true;
                         else if (CLI::detail::lexical_cast(text, value))
                           o.sigma = value;
                         else
                           throw CLI::ConversionError("Could not convert: --sigma = " + text);
                       },
                       "weight of the normals, a fraction of D (default 0.01); or auto: 1 / sqrt|K|, with the\n"
                       "Gauss curvature K")
                    ->type_name("FLOAT|auto")
                    ->group(group);
  auto* absolute_sigma = app.add_option("--absolute-sigma", o.absolute_sigma, "weight of the normals, in the unit of the mesh")
                             ->excludes(sigma)
                             ->group(group);
  auto* metric = app.add_option_function<std::string>(
                        "--metric", [&o](const std::string& text) { o.metric = number_or_infinity(text); },
                        "in place of sigma: the metric of the curvature that makes the distance to the surface least in the\n"
                        "norm L^P; P from 1 to inf, for the largest distance")
                     ->type_name("P|inf")
                     ->excludes(sigma)
                     ->excludes(absolute_sigma)
                     ->group(group);
  auto* field =
      app.add_option("--field", o.field, "a vertex property of IN, a PLY file: triangles are small where it varies, too")
          ->type_name("NAME")
          ->excludes(metric)
          ->group(group);
  app.add_option("--tau", o.tau, "weight of the field: D over its range is 1 (default 0.1)")->needs(field)->group(group);
}

void add_size_options(CLI::App& app, Options& o)
{
  auto* faces = app.add_option("--faces", o.faces, "number of triangles to aim at (default: as many as IN has)");
  auto* vertices =
      app.add_option("--vertices", o.vertices, "number of vertices to aim at; turned into triangles by Euler's formula");
  auto* length = app.add_option("--length", o.length, "6D edge length to aim at, in the unit of the mesh")
                     ->excludes(faces)
                     ->excludes(vertices);
  vertices->excludes(faces);
  auto* error = app.add_option("--error", o.error,
                               "largest distance between IN and OUT, both ways, a fraction of D: as few triangles as keep\n"
                               "it, at most --faces; with an option of the embedding or the function: to the surface")
                    ->excludes(length);
  app.add_option("--absolute-error", o.absolute_error, "the same in the unit of the mesh")->excludes(length)->excludes(error);
  app.add_flag("--fit", o.fit,
               "move the vertices off the surface in the end, to where the distance is least; by measured error, where they\n"
               "are off it anyway: more iterations, and hardly a price of long triangles");
  app.add_option("--aspect-ratio", o.aspect_ratio,
                 "by measured error: the longest edge over the altitude that triangles shall not exceed, 5 for a mesh to\n"
                 "compute on (an equilateral triangle has 1.15)");
  app.add_option("--shape-weight", o.shape_weight,
                 "by measured error: what long triangles cost, 0 for the least distance (default 2; with --fit 0.1)");
}

void add_function_options(CLI::App& app, Options& o)
{
  const std::string group = "The smooth function";
  app.add_option("--kernel", o.kernel, "radial function, r^3 by default; thin-plate is r^2 log r")
      ->check(CLI::IsMember(names_of_kernels()))
      ->group(group);
  app.add_option("--shape", o.shape,
                 "width of the kernel, or radius of its support, in local edge lengths; r3 and thin-plate have none")
      ->group(group);
  app.add_option("--patches", o.patches, "number of overlapping patches (default: one for 25 points)")->group(group);
  app.add_option("--overlap", o.overlap, "how far a patch gathers vertices beyond its part, in local edge lengths")
      ->group(group);
  app.add_option("--offset", o.offset,
                 "distance of the off-surface points, in the unit of the mesh\n"
                 "(default: a share of the local edge length)")
      ->group(group);
  app.add_option_function<std::string>(
         "--smoothing",
         [&o](const std::string& text)
         {
           double value = 0;
           if (text == "auto")
             o.automatic_smoothing = true;
           else if (CLI::detail::lexical_cast(text, value))
             o.smoothing = value;
           else
             throw CLI::ConversionError("Could not convert: --smoothing = " + text);
         },
         "standard deviation of the noise of the vertices, in the unit of the mesh, which the surface misses them by; or "
         "auto:\n"
         "estimated (default: 0; of points: auto)")
      ->type_name("FLOAT|auto")
      ->group(group);
  app.add_flag("--smooth-edges", o.smooth_edges,
               "where triangles turn by more than 57 degrees, take normals between theirs: there the surface swells")
      ->group(group);
  app.add_flag("--vertices-only", o.vertices_only,
               "put no points on facets that are large for what is around them: there the surface swells")
      ->group(group);
}

void add_points_options(CLI::App& app, Options& o)
{
  const std::string group = "Points";
  app.add_flag("--detect-outliers,!--keep-outliers", o.detect_outliers,
               "leave out points that their neighbours contradict, and turn or drop such normals (default), or not")
      ->group(group);
  app.add_option("--trim", o.trim,
                 "cut the surface off where no point is nearer than DISTANCE, in the unit of the points (default: it is\n"
                 "closed). At least two spacings of the points")
      ->type_name("DISTANCE")
      ->group(group);
  app.add_flag("--keep-largest", o.keep_largest, "remove all components of the surface but the one with the most triangles")
      ->group(group);
}

void add_remeshing_options(CLI::App& app, Options& o)
{
  const std::string group = "The remeshing";
  app.add_option("--sharp", o.sharp,
                 "keep edges at which triangles of IN turn by DEGREES or more, and their corners: the surface is smooth\n"
                 "between them only (default: it is smooth everywhere). 20 to 40 suits mechanical parts")
      ->type_name("DEGREES")
      ->group(group);
  app.add_option("--scheme", o.scheme,
                 "measured-error: the least distance to IN, whose triangles are split first if there are fewer than asked\n"
                 "for; embedding: uniform in the embedding, vertices on the smooth surface; paper: the same by Algorithm 2 of "
                 "Dassi, Farrell and Si.\n"
                 "By default the first if a number is asked for that is at most 3/4 of that of IN, or any if more than 1/4\n"
                 "of the area is in triangles 8 times as long as high, and nothing of the embedding or the smooth\n"
                 "function; else the second, but the first where that cannot keep exact facets")
      ->check(CLI::IsMember({"default", "measured-error", "embedding", "paper"}))
      ->group(group);
  app.add_option("--iterations", o.iterations, "number of iterations")->group(group);
  app.add_option("--relaxation-steps", o.relaxation_steps, "smoothing passes in an iteration")->group(group);
  app.add_option("--smoothing-ratio", o.smoothing_ratio, "share of the vertices that are smoothed, from 0 to 1")->group(group);
  app.add_option("--collapse-ratio", o.collapse_ratio, "edges shorter than this times the length are contracted")->group(group);
  app.add_flag("--avoid-self-intersections,!--allow-self-intersections", o.avoid_self_intersections,
               "let no more triangles intersect than do so in IN (default), or do not ask")
      ->group(group);
  app.add_option("--split-ratio", o.split_ratio, "edges longer than this times the length are split")->group(group);
}

void add_report_options(CLI::App& app, Options& o)
{
  const std::string group = "The report";
  app.add_option("--json", o.json, "write the table to FILE as JSON; - writes it to the standard output, without the table")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--report", o.report,
                 "write a page of HTML to FILE: the table, histograms and both meshes, to be turned in a browser")
      ->type_name("FILE")
      ->group(group);
  app.add_flag("--arrays", o.arrays,
               "write figures of each triangle and vertex into OUT, which must be PLY or VTP: aspect ratio,\n"
               "least 6D angle, distance to the surface, normal; by measured error, the angle in space and the\n"
               "distance to IN")
      ->group(group);
  app.add_flag("--self-intersections", o.self_intersections, "count the pairs of triangles that intersect, before and after")
      ->group(group);
  app.add_flag("--no-distance", o.no_distance, "do not measure the distance between IN and OUT")->group(group);
  app.add_flag("-q,--quiet", o.quiet, "print nothing but errors")->group(group);
}

// `value` as a message shows it
template <typename T>
std::string to_text(const T value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

template <typename T>
void require(const char* name, const std::optional<T>& value, const bool holds, const char* what)
{
  if (value && !holds)
    throw Failure(std::string(name) + " must be " + what + ", not " + to_text(*value));
}

void require_count(const char* name, const std::optional<long long>& value, const bool zero_is_fine = false)
{
  const long long least = zero_is_fine ? 0 : 1;
  require(name, value, value && *value >= least, zero_is_fine ? "0 or more" : "positive");
}

void require_length(const char* name, const std::optional<double>& value, const bool zero_is_fine = false)
{
  const bool holds = value && std::isfinite(*value) && (zero_is_fine ? *value >= 0 : *value > 0);
  require(name, value, holds, zero_is_fine ? "a finite number, 0 or more" : "a finite number above 0");
}

void check_values(const Options& o)
{
  require_length("--sigma", o.sigma, true);
  require_length("--absolute-sigma", o.absolute_sigma, true);
  require("--metric", o.metric, o.metric && *o.metric >= 1, "from 1 to inf");
  require("--metric", o.metric, !o.length, "left out with --length, which is 6D");
  require_length("--merge", o.merge);
  require_length("--tau", o.tau, true);
  require("--field", o.adaptive_sigma ? std::optional<std::string>(o.field) : std::nullopt, o.field.empty(),
          "left out with --sigma auto");
  require("--sharp", o.sharp, o.sharp && *o.sharp > 0 && *o.sharp < 180, "above 0 and below 180 degrees");
  require_length("--error", o.error);
  require_length("--absolute-error", o.absolute_error);
  require_length("--length", o.length);
  require("--aspect-ratio", o.aspect_ratio, o.aspect_ratio && *o.aspect_ratio >= 1.2, "1.2 or more");
  require_length("--shape-weight", o.shape_weight, true);
  require_count("--faces", o.faces);
  require_count("--vertices", o.vertices);
  require_count("--patches", o.patches);
  require_length("--overlap", o.overlap, true);
  require_length("--offset", o.offset);
  require_length("--shape", o.shape);
  require("--shape", o.shape, has_shape(o.kernel), "left out: the kernel has no shape parameter");
  require_length("--smoothing", o.smoothing, true);
  require_length("--trim", o.trim);
  require_count("--iterations", o.iterations, true);
  require_count("--relaxation-steps", o.relaxation_steps, true);
  require_length("--smoothing-ratio", o.smoothing_ratio, true);
  require("--smoothing-ratio", o.smoothing_ratio, o.smoothing_ratio && *o.smoothing_ratio <= 1, "1 or less");
  require_length("--collapse-ratio", o.collapse_ratio);
  require_length("--split-ratio", o.split_ratio);
  require_count("--threads", o.threads);
}

// words that a shell would not take as they are in quotes
std::string command_line(const int argc, char** argv)
{
  std::string result = "hde_remesh";
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const bool is_plain = !word.empty() && word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                                                  "0123456789_./,:=+-") == std::string::npos;
    result += ' ';
    if (is_plain)
      result += word;
    else
    {
      result += '\'';
      for (const char c : word)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
      result += '\'';
    }
  }
  return result;
}

} // namespace

bool is_function_asked_for(const Options& o)
{
  return o.kernel != "r3" || o.shape || o.patches || o.overlap || o.offset || o.smoothing || o.automatic_smoothing ||
         o.vertices_only || o.smooth_edges;
}

std::string version_text()
{
  std::string text = "hde_remesh " HDE_REMESH_VERSION ", CGAL " CGAL_VERSION_STR;
#ifdef CGAL_LINKED_WITH_TBB
  text += ", parallel";
#else
  text += ", sequential";
#endif
  return text;
}

std::optional<Options> read_command_line(const int argc, char** argv)
{
  Options o;
  o.command_line = command_line(argc, argv);
  CLI::App app(help_header(), "hde_remesh");
  app.footer(help_footer());
  app.set_version_flag("--version", version_text());
  app.get_formatter()->column_width(34);
  app.add_option("IN", o.input, "the mesh: triangles, manifold, with or without boundary; or points")
      ->required()
      ->type_name("");
  app.add_option("OUT", o.output, "where the new mesh is written")->required()->type_name("");
  auto* repair = app.add_flag("--repair", o.repair,
                              "mend IN first: merge equal points, close cracks, drop double faces and walls between solids,\n"
                              "orient the faces alike, double the points where sheets touch, divide polygons into triangles,\n"
                              "stitch edges, untangle faces that intersect");
  app.add_option("--merge", o.merge,
                 "make points of IN one that are no further apart, in the unit of the mesh, where this joins two boundary\n"
                 "edges. Without it, in STL files and with --repair: 4 units in the last place of the coordinates");
  add_size_options(app, o);
  add_embedding_options(app, o);
  app.get_option("--field")->excludes(repair)->excludes(app.get_option("--merge"));
  add_function_options(app, o);
  add_points_options(app, o);
  add_remeshing_options(app, o);
  add_report_options(app, o);
  app.add_option("--threads", o.threads, "use at most this number of threads (default: all); the result is the same");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success& request)
  {
    app.exit(request);
    return std::nullopt;
  }
  catch (const CLI::ParseError& error)
  {
    throw Failure(std::string(error.what()) + " (hde_remesh --help explains)", STATUS_USAGE);
  }
  check_values(o);
  return o;
}

} // namespace hde_remesh
