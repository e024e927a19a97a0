// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "help.h"
#include "wrapped.h"

#include <CLI/CLI.hpp>

#include <set>
#include <string>
#include <vector>

namespace hde_remesh {

namespace {

constexpr std::size_t column_of_meanings = 24;

const char* const first_lines = "hde_remesh IN OUT [OPTIONS]\n";

std::string paragraph(const std::string& text) { return wrapped("", text, 0); }

std::string in_and_out()
{
  return wrapped("IN   ", "the mesh: triangles, manifold, with or without boundary; or points of a surface", 5) +
         wrapped("OUT  ", "where the new mesh is written", 5) +
         wrapped("D    ",
                 "in all that follows: the diagonal of the bounding box of IN. Lengths are in the unit of the mesh, but "
                 "--sigma and --error are fractions of D.",
                 5);
}

std::string formats()
{
  return paragraph("Files are OFF, OBJ, PLY or STL, by the extension of the name. Points may be XYZ, too, and OUT VTP.");
}

std::string exit_status()
{
  return paragraph("Exit status: 0 done; 1 the input, a value or the output cannot be used; 2 the command line cannot be "
                   "understood; 130 cancelled by Ctrl-C. Files are written whole or not at all.");
}

// the names of an option, and what stands for its value
std::string name_of(const CLI::Option& option)
{
  std::string result;
  for (const std::string& name : option.get_snames())
    result += "-" + name + ", ";
  for (const std::string& name : option.get_lnames())
    result += "--" + name + ", ";
  result.resize(result.size() - 2);
  return option.get_items_expected_max() > 0 ? result + " " + option.get_type_name() : result;
}

std::string line_of(const CLI::Option& option)
{
  std::string beginning = "  " + name_of(option);
  if (beginning.size() + 2 > column_of_meanings)
    return beginning + "\n" + wrapped(std::string(column_of_meanings, ' '), option.get_description(), column_of_meanings);
  beginning.resize(column_of_meanings, ' ');
  return wrapped(beginning, option.get_description(), column_of_meanings);
}

// A CLI::App gives no order of its groups but that of their first options.
std::string groups(const CLI::App& app)
{
  std::string result;
  std::set<std::string> done;
  for (const CLI::Option* first : app.get_options([](const CLI::Option* o) { return !o->get_positional(); }))
    if (const std::string group = first->get_group(); group != "Help" && done.insert(group).second)
    {
      result += "\n" + group + ":\n";
      for (const CLI::Option* option : app.get_options([&](const CLI::Option* o) { return o->get_group() == group; }))
        result += line_of(*option);
    }
  return result;
}

} // namespace

std::string usage()
{
  return "usage: hde_remesh IN OUT [OPTIONS]\n"
         "  hde_remesh bunny.off out.ply --faces 20000    the nearest mesh of 20,000 triangles\n"
         "  hde_remesh --help                             the most important options\n";
}

std::string short_help(const CLI::App& app)
{
  std::string result = first_lines;
  result += "\n";
  result +=
      paragraph("Makes a new triangle mesh of the surface that IN describes. Its triangles follow the curvature: they are "
                "short across a bend and long along it. If IN has points and no faces, a surface is made of them first.");
  result += "\n" + in_and_out() + "\n";
  for (const char* name :
       {"--faces", "--vertices", "--length", "--error", "--fit", "--aspect-ratio", "--sigma", "--sharp", "--smoothing",
        "--repair", "--trim", "--report", "--json", "--details", "--threads", "--quiet", "--version", "--help-all"})
    result += line_of(*app.get_option(name));
  result += "\nExamples:\n"
            "  hde_remesh bunny.off out.ply --faces 20000              the nearest mesh of so many triangles\n"
            "  hde_remesh bunny.off out.off --error .001               within a thousandth of D\n"
            "  hde_remesh part.stl out.stl --faces 5000 --sharp 30     edges and corners are kept\n"
            "  hde_remesh scan.xyz out.ply --faces 20000               from points\n\n";
  return result + formats() + exit_status();
}

std::string full_help(const CLI::App& app)
{
  std::string result = first_lines;
  result += "\n" + in_and_out() + "\n" + formats() + exit_status() + "\n";
  result +=
      paragraph("By measured error. If only a number of triangles is given, of at most 3/4 of those of IN, the distance to IN "
                "leads, measured both ways. So it does for --error alone, and for any number if more than 1/4 of the area "
                "of IN is in triangles 8 times as long as high, as CAD programs write them.");
  result += "\n";
  result +=
      paragraph("By an embedding. Otherwise the vertices of IN and their normals give a smooth function, whose zero set is "
                "the surface. New vertices are put on that surface, not on the flat triangles of IN. Lengths are "
                "measured in 6D: position and sigma times unit normal. An edge across a bend is longer there than one "
                "along it. Triangles of equal 6D edges are short across bends and long along them. A larger sigma "
                "makes them longer and thinner; with 0 their sides are equal everywhere.");
  result += "\n";
  result += paragraph(
      "Points. IN may be an OFF, OBJ or PLY file without faces, or an XYZ file: coordinates, then perhaps a normal or "
      "a colour, then any numbers. The surface is closed where points are missing. Noise is estimated, outliers "
      "are left out, and normals are estimated where there are none. Colours and other numbers go to OUT, a PLY "
      "or VTP file.");
  result += groups(app) + "\nHelp:\n";
  for (const char* name : {"--help", "--help-all", "--version"})
    result += line_of(*app.get_option(name));
  result += "\nExamples:\n"
            "  hde_remesh bunny.off out.off                                      as many triangles as before\n"
            "  hde_remesh bunny.off out.ply --faces 20000                        the nearest mesh of so many\n"
            "  hde_remesh bunny.off out.ply --faces 20000 --sigma .02            even triangles in 6D\n"
            "  hde_remesh bunny.off out.off --error .001                         within a thousandth of D\n"
            "  hde_remesh part.stl out.stl --sharp 30 --sigma .03                edges and corners are kept\n"
            "  hde_remesh part.stl out.stl --metric 2 --faces 5000 --fit         by the metric of the curvature\n"
            "  hde_remesh scan.obj out.off --length .5 --scheme paper            as in the paper\n"
            "  hde_remesh bunny.off out.vtp --arrays --report out.html           to look at\n"
            "  hde_remesh scan.xyz out.ply --faces 20000 --trim .5 --keep-largest\n\n";
  return result + paragraph("PLY and STL are written binary; STL keeps 7 digits only. Without exit status 0, files are as they "
                            "were, but where the message says so.");
}

} // namespace hde_remesh
