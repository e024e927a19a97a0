// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Files as they come, each with the options that a user tries and the mesh that is meant.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FILE_CASES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FILE_CASES_H

#include "Table.h"
#include "awkward_shapes.h"
#include "cad_shapes.h"
#include "file_formats.h"
#include "flawed_shapes.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace file_cases {

using namespace file_formats;
using polygon_soups::to_polygons;
using shapes::Mesh;
using shapes::Soup;

typedef std::vector<std::string> Options; // each a list of options, separated by blanks

struct File_case
{
  std::string file;
  std::function<void(std::ostream&)> write; // none if the file is given
  Options options;
  std::optional<Mesh> meant; // what a reader should see
  bool is_cad = false;       // its time and its distances have a limit
};

typedef std::vector<File_case> Cases;

inline File_case off_case(const std::string& name, const Polygon_soup& soup, const Options& options,
                          const std::optional<Mesh>& meant = std::nullopt)
{
  return File_case{name + ".off", [soup](std::ostream& out) { write_off(out, soup); }, options, meant};
}

inline File_case off_case(const std::string& name, const Mesh& mesh, const Options& options)
{
  return off_case(name, soup_of(mesh), options, mesh);
}

// CAD programs: long, few and exact triangles, in binary STL
inline Cases cad(const bool is_whole)
{
  Cases cases;
  const Options options = {"--faces 1000",
                           "--sharp 40 --faces 1000",
                           "--sharp 40 --faces 1000 --metric 2",
                           "--sharp 40 --faces 1000 --sigma .02",
                           "--faces 1000 --metric 2",
                           "--faces 1000 --sigma .02",
                           "--sharp 40 --error 1e-3"};
  const auto add = [&](const std::string& shape, const std::size_t sides, const std::size_t bands, const Mesh& mesh)
  {
    const Polygon_soup soup = soup_of(mesh);
    cases.push_back(File_case{shape + "_" + std::to_string(sides) + "x" + std::to_string(bands) + ".stl",
                              [soup](std::ostream& out) { write_stl(out, soup, exact); }, options, mesh, true});
  };
  const std::vector<std::size_t> all_sides =
                                     is_whole ? std::vector<std::size_t>{12, 32, 90, 360} : std::vector<std::size_t>{12, 90},
                                 all_bands = is_whole ? std::vector<std::size_t>{1, 2, 5} : std::vector<std::size_t>{1, 3};
  for (const std::size_t n : all_sides)
    for (const std::size_t k : all_bands)
    {
      add("open_cylinder", n, k, cad_shapes::cylinder(n, k, false));
      add("cylinder", n, k, cad_shapes::cylinder(n, k, true));
      add("tube", n, k, cad_shapes::tube(n, k));
      add("cone", n, k, cad_shapes::cone_with_tip(n, k));
      add("open_elbow", n, k, cad_shapes::elbow(n, k, false));
      add("elbow", n, k, cad_shapes::elbow(n, k, true));
      add("fillets", n, k, cad_shapes::bar_with_fillets(n / 4, k));
      add("plate", n, k, cad_shapes::plate(n / 4, k));
    }
  return cases;
}

// Points that should be one differ by rounding.
inline Cases cracks()
{
  const Mesh sphere = shapes::icosphere(3), cube = shapes::cube(6);
  const Polygon_soup soup = soup_of(sphere), of_cube = soup_of(cube), torn = flawed_shapes::torn(soup, One_ulp());
  const Options options = {"--faces 300", "--faces 300 --repair"};
  return {
      {"one_ulp.stl", [soup](std::ostream& out) { write_stl(out, soup, One_ulp()); }, options, sphere},
      {"one_ulp_cube.stl",
       [of_cube](std::ostream& out) { write_stl(out, of_cube, One_ulp()); },
       {"--sharp 40 --faces 300"},
       cube},
      {"tiny_for_zero.stl", [soup](std::ostream& out) { write_stl_text(out, soup, Stl_words(), Tiny_for_zero()); }, options,
       sphere},
      {"one_ulp.off", [torn](std::ostream& out) { write_off(out, torn, "OFF\n# # 0\n", 9); }, {"--faces 300 --repair"}, sphere},
      off_case("split_vertices", flawed_shapes::torn(soup, exact), {"--faces 300 --repair"}, sphere)};
}

// the same sphere, as programs write it that keep to no specification
inline Cases dialects()
{
  const Mesh sphere = shapes::icosphere(2);
  const Polygon_soup soup = soup_of(sphere);
  Cases cases;
  const auto add = [&](const std::string& file, const std::function<void(std::ostream&)>& write) {
    cases.push_back(File_case{file, write, {"--faces 200"}, sphere});
  };
  const auto off = [&](const std::string& name, const std::string& header)
  { add(name + ".off", [=](std::ostream& out) { write_off(out, soup, header); }); };
  off("no_edge_count", "OFF\n# #\n");
  off("counts_behind_keyword", "OFF# # 0\n");
  off("byte_order_mark", "\xEF\xBB\xBFOFF\n# # 0\n");
  add("byte_order_mark.obj", [=](std::ostream& out) { write_obj(out << "\xEF\xBB\xBF", soup); });
  add("continued_lines.obj", [=](std::ostream& out) { write_obj(out, soup, " \\\n"); });
  add("lines_and_points.obj", [=](std::ostream& out) { write_obj(out, soup, " ", "l 1 2 3\np 1 2\n"); });
  add("short_indices.ply", [=](std::ostream& out) { write_ply(out, soup); });
  const auto stl = [&](const std::string& name, const Stl_words& words)
  { add(name + ".stl", [=](std::ostream& out) { write_stl_text(out, soup, words, exact); }); };
  stl("capitals", {"SOLID S", "FACET NORMAL 0 0 1", "OUTER LOOP", "VERTEX ", "ENDLOOP", "ENDFACET", "ENDSOLID S\n"});
  stl("two_words", {"solid s", "facet normal 0 0 1", "outer loop", "vertex ", "end loop", "end facet", "end solid s\n"});
  stl("no_endsolid", {"solid s", "facet normal 0 0 1", "outer loop", "vertex ", "endloop", "endfacet", ""});
  return cases;
}

inline Mesh moved(Mesh mesh, const double distance)
{
  for (const auto v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + shapes::Vector_3(distance, distance, distance);
  return mesh;
}

inline Cases far_from_the_origin()
{
  Cases cases;
  for (const double distance : {0., 1e3, 1e6})
    for (const bool is_torus : {true, false})
    {
      const Mesh mesh = moved(is_torus ? shapes::torus(64, 24) : shapes::ellipsoid(3), distance);
      cases.push_back(off_case(std::string(is_torus ? "torus" : "ellipsoid") + "_at_" + text(distance), mesh,
                               {"--error 1e-3", "--faces 600", "--faces 600 --sigma .02", "--faces 600 --metric 2"}));
    }
  Mesh mesh = shapes::torus(64, 24);
  for (const auto v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + 200 * (mesh.point(v) - CGAL::ORIGIN);
  mesh = moved(mesh, 5e5);
  const Polygon_soup soup = soup_of(mesh);
  cases.push_back(
      File_case{"torus_at_5e5.stl", [soup](std::ostream& out) { write_stl(out, soup, exact); }, {"--error 1e-3"}, mesh});
  return cases;
}

// Boundaries that are curved, or have corners.
inline Cases outlines()
{
  const Options options = {"--error 1e-3", "--faces 200", "--faces 200 --sigma .02", "--faces 200 --metric 2"};
  return {off_case("disk", flawed_shapes::disk(48, 8), options), off_case("octagon", flawed_shapes::disk(8, 8), options),
          off_case("wavy_bowl", flawed_shapes::wavy_bowl(72, 12), options)};
}

inline Cases flaws()
{
  const Mesh building = moved(shapes::l_block(1), 5e5);
  Cases cases = {
      off_case("cubes_with_wall", to_polygons(flawed_shapes::cubes_with_wall(4)), {"--repair --sharp 40 --faces 400"}),
      off_case("quadrangle", flawed_shapes::quadrangle_with_edge_for_diagonal(), {"--repair --sharp 40 --faces 200"}),
      off_case("flat_faces", soup_of(flawed_shapes::sphere_with_flat_faces()),
               {"--faces 600", "--faces 2000", "--error 1e-3", "--sharp 60 --faces 1000"}),
      off_case("t_junction", to_polygons(flawed_shapes::sphere_with_t_junction()), {"--faces 600"}),
      off_case("moebius", to_polygons(awkward_shapes::twisted_strip(60, 1)), {"--repair --faces 60"}),
      off_case("building", building, {"--faces 400", "--sharp 40 --faces 400"}),
      off_case("noise", flawed_shapes::noise(12), {"--repair --faces 100"}),
      off_case("thin_plate", shapes::to_mesh(awkward_shapes::plate(20, 5e-4)), {"--sharp 40 --faces 800", "--faces 800"}),
      off_case("hump", flawed_shapes::hump(45), {"--faces 2000", "--sigma .02 --faces 2000"})};
  const Polygon_soup voxels = soup_of(flawed_shapes::voxel_ball(8));
  cases.push_back(File_case{"voxels.stl",
                            [voxels](std::ostream& out) { write_stl(out, voxels, exact); },
                            {"--smoothing auto --faces 800 --sigma .02"},
                            std::nullopt});
  return cases;
}

} // namespace file_cases

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FILE_CASES_H
