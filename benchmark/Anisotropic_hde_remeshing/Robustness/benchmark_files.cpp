// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Files as they come, remeshed by the program hde_remesh as their owners would:
//
//   benchmark_files [--all] [--only GROUP] PROGRAM FOLDER [MESH[:OPTIONS]...]
//
// Files of several groups are made in FOLDER: `cad`, `cracks`, `dialects`, `far`, `outlines`, `flaws`; --all has more of `cad`. MESH
// is a file, remeshed with OPTIONS, or with some that users try. A line for each run: the file, what was asked for and how many faces
// came; root mean square and largest distance from the result to the input and back, over the diagonal of the bounding box; the
// same, the larger of both ways, of CGAL's edge collapse by Lindstrom and Turk to the same number of vertices; boundary loops,
// components and pairs of faces that intersect, before and after; the share of the area that is turned over; seconds, and
// megabytes, where these are more than the benchmark's own; and the last of what was said. "!" marks what is beyond its limit:
// asked:      the number of faces is missed by more than 2%, or the error is not kept, and nothing is said
// distance:   it is more than that of the collapse and the height of an arc over a side. By an embedding without --sharp, creases
//             may be off by .01 of the diagonal, and by more if a line tells of them
// topology:   not that of what was meant
// turned:     any of the area looks against the nearest facets
// time:       more than 3 s, for at most 2,000 triangles and 1,000 asked for

#include "files/Program_run.h"
#include "files/file_cases.h"

#include "Table.h"
#include "mesh_quality.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace SMS = CGAL::Surface_mesh_simplification;

using file_cases::File_case;
using shapes::Mesh;
typedef nlohmann::json Json;
typedef CGAL::Parallel_if_available_tag Tag;

constexpr double largest_seconds = 3, largest_miss = 0.02;
constexpr double largest_rounding_of_creases = 0.01; // over the diagonal, with no word
constexpr unsigned int seconds_until_stopped = 300;

struct At_number_of_vertices
{
  std::size_t n;
  template <typename FT, typename Profile>
  bool operator()(const FT&, const Profile& profile, std::size_t, std::size_t) const
  {
    return profile.surface_mesh().number_of_vertices() <= n;
  }
};

// The collapse loses its digits far from the origin: it is done near there.
Mesh collapsed(Mesh mesh, const std::size_t number_of_vertices)
{
  const auto away = *mesh.points().begin() - CGAL::ORIGIN;
  for (const auto v : mesh.vertices())
    mesh.point(v) = mesh.point(v) - away;
  SMS::edge_collapse(mesh, At_number_of_vertices{number_of_vertices},
                     CGAL::parameters::get_cost(SMS::LindstromTurk_cost<Mesh>())
                         .get_placement(SMS::LindstromTurk_placement<Mesh>())
                         .filter(SMS::Bounded_normal_change_filter<>()));
  mesh.collect_garbage();
  for (const auto v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + away;
  return mesh;
}

// as a reader of another library sees it; none where it sees no mesh
std::optional<Mesh> read(const std::string& file)
{
  polygon_soups::Polygon_soup soup;
  try
  {
    if (!CGAL::IO::read_polygon_soup(file, soup.points, soup.polygons) || !polygon_soups::has_valid_indices(soup))
      return std::nullopt;
    return polygon_soups::mesh_of(polygon_soups::repaired(soup));
  }
  catch (const std::exception&)
  {
    return std::nullopt;
  }
}

// The largest height of an arc over a side, if the edges of the mesh that turn by less than 60 degrees stand for arcs. The sides of
// an arc are equal: of the two at an edge, the shorter one counts.
double arc_height(const Mesh& mesh)
{
  double result = 0;
  const auto altitude = [&](const Mesh::Halfedge_index h)
  {
    const auto a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h)), c = mesh.point(mesh.target(mesh.next(h)));
    return std::sqrt(CGAL::cross_product(b - a, c - a).squared_length() / CGAL::squared_distance(a, b));
  };
  for (const auto e : mesh.edges())
  {
    const auto h = mesh.halfedge(e), o = mesh.opposite(h);
    if (mesh.is_border(h) || mesh.is_border(o))
      continue;
    const double turn = 180 - std::abs(CGAL::approximate_dihedral_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                                        mesh.point(mesh.target(mesh.next(h))),
                                                                        mesh.point(mesh.target(mesh.next(o)))));
    if (turn < 60)
      result = (std::max)(result, (std::min)(altitude(h), altitude(o)) * turn * shapes::pi / 180 / 8);
  }
  return result;
}

// the share of the area of which the normal is against that of the nearest facet
double turned_share(const Mesh& input, const Mesh& mesh)
{
  using namespace CGAL::Anisotropic_hde_remeshing::internal;
  static constexpr std::size_t number_of_samples = 50000;
  static const double largest_cosine = -0.5; // edges may turn by right angles, and it is by chance which side is nearest
  const Measured_mesh reference = read_measured_mesh(input, CGAL::parameters::default_values()),
                      result = read_measured_mesh(mesh, CGAL::parameters::default_values());
  const Closest_facet closest(reference.points, reference.faces);
  const Area_sampler sampler(result, number_of_samples);
  std::size_t turned = 0;
  for (std::size_t i = 0; i < sampler.size(); ++i)
    turned +=
        result.normal(sampler.face(i)).stableNormalized().dot(reference.normal(closest(sampler(i)).facet).stableNormalized()) <
        largest_cosine;
  return double(turned) / double(sampler.size());
}

std::vector<std::string> words_of(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;)
    result.push_back(word);
  return result;
}

bool says(const Json& json, const std::string& part)
{
  for (const char* kind : {"warnings", "notes"})
    for (const auto& line : json[kind])
      if (line.get<std::string>().find(part) != std::string::npos)
        return true;
  return false;
}

std::string short_text(const std::string& line) { return line.size() <= 100 ? line : line.substr(0, 97) + "..."; }

std::string scientific(const double x)
{
  std::ostringstream stream;
  stream.precision(1);
  stream << std::scientific << x;
  return stream.str();
}

class Benchmark
{
public:
  Benchmark(const std::string& program, const std::string& folder) : m_program(program), m_folder(folder)
  {
    m_table.add("file", "options", "faces", "asked", "got", "rms, max out to in", "in to out", "collapse", "loops",
                "components", "pairs", "turned", "s", "MB", "said");
  }

  void run(const File_case& c)
  {
    const std::string input = c.write ? m_folder + "/" + c.file : c.file;
    if (c.write)
    {
      std::ofstream out(input, std::ios::binary);
      c.write(out);
      if (!out.flush())
        throw std::runtime_error("cannot write " + input);
    }
    const std::optional<Mesh> meant = c.write ? c.meant : read(input);
    for (const std::string& options : c.options)
      run(c, input, meant, options);
  }

  int summary()
  {
    m_table.print();
    std::cout << m_number_of_runs - m_number_beyond << " within, " << m_number_beyond << " beyond" << std::endl;
    return m_number_beyond == 0 ? 0 : 1;
  }

private:
  void run(const File_case& c, const std::string& input, const std::optional<Mesh>& meant, const std::string& options)
  {
    const std::string output = m_folder + "/result.off";
    std::vector<std::string> arguments = {m_program, input, output};
    for (const std::string& word : words_of(options))
      arguments.push_back(word);
    std::cerr << c.file << " " << options << std::endl;
    const Program_run run = run_program(arguments, m_folder, seconds_until_stopped);
    const std::string name = input.substr(input.find_last_of('/') + 1);
    ++m_number_of_runs;
    m_is_beyond = false;
    if (run.status == 0)
      add_row(c, name, meant, options, run, read(output));
    else
      m_table.add(name, options, "", "", mark("status " + std::to_string(run.status), c.write != nullptr), "", "", "", "", "",
                  "", "", run.seconds, run.megabytes, short_text(run.last_message));
    m_number_beyond += m_is_beyond;
  }

  void add_row(const File_case& c, const std::string& name, const std::optional<Mesh>& meant, const std::string& options,
               const Program_run& run, const std::optional<Mesh>& result)
  {
    const Json& json = run.json;
    const double d = json["diagonal"];
    const std::size_t faces = json["after"]["topology"]["faces"], before = json["before"]["topology"]["faces"];
    const auto pair_of = [&](const char* where)
    {
      return scientific(json["distance"][std::string("rms_") + where].get<double>() / d) + " " +
             scientific(json["distance"][std::string("max_") + where].get<double>() / d);
    };
    const auto both = [&](const char* group, const char* key)
    {
      const auto value = [&](const char* when) { return group ? json[when][group][key] : json[when][key]; };
      return value("before").dump() + " " + value("after").dump();
    };
    const bool is_topology_wrong = meant && c.write && !has_topology_of(*meant, json["after"]["topology"]);
    const double turned = meant && result ? turned_share(*meant, *result) : 0;
    const bool is_slow = run.seconds > largest_seconds && before <= 2000 && faces <= 1100;
    m_table.add(name, options, std::to_string(before), asked(json), mark(std::to_string(faces), is_missed(json)),
                pair_of("output_to_input"), pair_of("input_to_output"), collapse(c, json, meant, d),
                mark(both("topology", "boundary_loops"), is_topology_wrong), both("topology", "components"),
                both(nullptr, "self_intersections"), mark(text(turned), turned > 0), mark(text(run.seconds), is_slow),
                run.megabytes, said(json));
  }

  std::string mark(const std::string& cell, const bool is_beyond)
  {
    m_is_beyond = m_is_beyond || is_beyond;
    return is_beyond ? cell + " !" : cell;
  }

  static std::string asked(const Json& json)
  {
    std::string result = json.contains("target_faces") ? json["target_faces"].dump() : "";
    if (json.contains("error"))
      result += (result.empty() ? "" : " ") + scientific(json["error"].get<double>() / json["diagonal"].get<double>()) + " D";
    return result;
  }

  static bool is_missed(const Json& json)
  {
    if (json.contains("error"))
      return json["error_is_kept"].get<bool>() &&
             json["distance"]["max"].get<double>() > json["error"].get<double>() * (1 + 1e-9);
    if (!json.contains("target_faces"))
      return false;
    const double target = json["target_faces"], faces = json["after"]["topology"]["faces"];
    return std::abs(faces - target) > largest_miss * target && !says(json, "faces, not about");
  }

  static bool has_topology_of(const Mesh& meant, const Json& topology)
  {
    const Hde::Topology_measures m = Hde::measure_topology(meant);
    return topology["components"] == m.number_of_components && topology["boundary_loops"] == m.number_of_boundary_loops &&
           topology["euler_characteristic"] == m.euler_characteristic;
  }

  // root mean square and largest distance of the collapse, and whether that of the result is too large
  std::string collapse(const File_case& c, const Json& json, const std::optional<Mesh>& meant, const double d)
  {
    if (!meant || json.contains("error"))
      return "";
    const std::size_t n = json["after"]["topology"]["vertices"];
    double rms = 0, max = 0;
    if (n < meant->number_of_vertices())
    {
      const Hde::Distance_measures distance = Hde::measure_distance<Tag>(collapsed(*meant, n), *meant);
      rms = distance.rms();
      max = distance.max();
    }
    const double height = arc_height(*meant);
    const bool may_round_creases = json["scheme"] != "measured-error" && !json.contains("sharp");
    const double rounding = may_round_creases ? largest_rounding_of_creases : 1e-9;
    const bool is_told = may_round_creases && says(json, " D from OUT");
    const bool is_far = json["distance"]["rms"].get<double>() > rms + height + rounding * d ||
                        json["distance"]["max"].get<double>() > max + height + rounding * d;
    return mark(scientific(rms / d) + " " + scientific(max / d), is_far && c.is_cad && !is_told);
  }

  static std::string said(const Json& json)
  {
    std::string result;
    for (const char* kind : {"notes", "warnings"})
      for (const auto& line : json[kind])
        result = line.get<std::string>();
    const std::size_t number = json["notes"].size() + json["warnings"].size();
    return short_text((number > 1 ? "(" + std::to_string(number) + ") " : "") + result);
  }

  std::string m_program, m_folder;
  Table m_table{"hde_remesh on files as they come; distances over the diagonal"};
  int m_number_of_runs = 0, m_number_beyond = 0;
  bool m_is_beyond = false;
};

// FILE, or FILE:OPTIONS
File_case given(const std::string& argument)
{
  const std::size_t colon = argument.find(':');
  File_case result;
  result.file = argument.substr(0, colon);
  result.options = {"--faces 1000", "--sharp 30 --faces 1000", "--sharp 30 --faces 1000 --metric 2", "--error 1e-3"};
  if (colon != std::string::npos)
    result.options = {argument.substr(colon + 1)};
  result.is_cad = true;
  return result;
}

std::vector<std::pair<std::string, file_cases::Cases>> groups(const bool is_whole)
{
  return {{"cad", file_cases::cad(is_whole)},   {"cracks", file_cases::cracks()},
          {"dialects", file_cases::dialects()}, {"far", file_cases::far_from_the_origin()},
          {"outlines", file_cases::outlines()}, {"flaws", file_cases::flaws()}};
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    bool is_whole = false;
    std::string only;
    while (!arguments.empty() && arguments.front().rfind("--", 0) == 0)
    {
      if (arguments.front() == "--all")
        is_whole = true;
      else if (arguments.front() == "--only" && arguments.size() > 1)
      {
        only = arguments[1];
        arguments.erase(arguments.begin());
      }
      arguments.erase(arguments.begin());
    }
    if (arguments.size() < 2)
      throw std::invalid_argument("benchmark_files [--all] [--only GROUP] PROGRAM FOLDER [MESH[:OPTIONS]...]");
    Benchmark benchmark(arguments[0], arguments[1]);
    for (const auto& [name, cases] : groups(is_whole))
      if (only.empty() || only == name)
        for (const File_case& c : cases)
          benchmark.run(c);
    for (std::size_t i = 2; i < arguments.size(); ++i)
      benchmark.run(given(arguments[i]));
    return benchmark.summary();
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}
