// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Whether the smooth surface stays on the facets that it is built from:
//
//   benchmark_fidelity [--all] [--facets] [--truth] [--cad] [MESH...]
//
// does all three parts, or those named.
//
// --facets: the distances from the facets of MESH to the zero set of its function and back, over the diagonal of the bounding box:
// root mean square, 99.9%, largest; the share of the worst 1% of the area in the sum of squares; the time to build the function,
// over that without points on facets and edges; and how many points there are, over the number of vertices.
// --truth: MESH is reduced to a quarter and an eighth of its vertices, evenly by isotropic_remeshing, and adapted to the shape by
// edge collapse of Lindstrom and Turk, and of Garland and Heckbert. A function is built from that. Its zero set has some distance
// from MESH, and so have the reduced facets themselves. The ratio is below 1 if the function is nearer than they are.
// --cad: cylinders, tubes, cones and plates of few long triangles, made here. Distances are over the chord height of a side.
// --all has more numbers of sides and rings in --cad.

#include "fidelity/fidelity.h"

#include "Table.h"
#include "cad_shapes.h"
#include "seconds_of.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Surface_regions.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>
#include <CGAL/Piecewise_rbf_implicit_function.h>
#include <CGAL/Rbf_implicit_function.h>

#include "isotropic_remeshing.h" // includes graphs of Boost, after which its disjoint sets do not compile

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMS = CGAL::Surface_mesh_simplification;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> Function;
typedef CGAL::Piecewise_rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> Sharp_function;

const std::size_t number_of_samples = 60000;

// geometric mean and largest of ratios
class Ratios
{
public:
  void add(const double ratio)
  {
    m_sum += std::log(ratio);
    m_largest = (std::max)(m_largest, ratio);
    ++m_number;
  }
  double mean() const { return std::exp(m_sum / double(m_number)); }
  double largest() const { return m_largest; }

private:
  double m_sum = 0, m_largest = 0;
  std::size_t m_number = 0;
};

struct At_number_of_vertices
{
  std::size_t n;
  template <typename FT, typename Profile>
  bool operator()(const FT&, const Profile& profile, std::size_t, std::size_t) const
  {
    return profile.surface_mesh().number_of_vertices() <= n;
  }
};

Mesh reduced(const Mesh& mesh, const std::string& how, const std::size_t part)
{
  Mesh result = mesh;
  const At_number_of_vertices stop{mesh.number_of_vertices() / part};
  if (how == "even")
    result = isotropically_remeshed(mesh, length_of_edges(mesh, mesh.number_of_faces() / part));
  else if (how == "Lindstrom-Turk")
    SMS::edge_collapse(result, stop,
                       CGAL::parameters::get_cost(SMS::LindstromTurk_cost<Mesh>())
                           .get_placement(SMS::LindstromTurk_placement<Mesh>())
                           .filter(SMS::Bounded_normal_change_filter<>()));
  else
  {
    typedef SMS::GarlandHeckbert_plane_policies<Mesh, Kernel> Policies;
    const Policies policies(result);
    SMS::edge_collapse(result, stop,
                       CGAL::parameters::get_cost(policies.get_cost())
                           .get_placement(policies.get_placement())
                           .filter(SMS::Bounded_normal_change_filter<>()));
  }
  result.collect_garbage();
  return result;
}

struct Named_mesh
{
  std::string name;
  Mesh mesh;
};

void measure_facets(const std::vector<Named_mesh>& meshes)
{
  Table table("facets to zero set and back, over the diagonal");
  table.add("mesh", "vertices", "rms", "99.9%", "largest", "worst 1%", "lost", "back: rms", "99.9%", "largest", "points",
            "time", "seconds", "refined", "off facets", "on fallback");
  Ratios times;
  for (const Named_mesh& m : meshes)
  {
    std::unique_ptr<Function> f, of_vertices;
    const double seconds = seconds_of([&] { f = std::make_unique<Function>(m.mesh); });
    const double seconds_of_vertices = seconds_of(
        [&] { of_vertices = std::make_unique<Function>(m.mesh, params::points_on_facets(false).detect_edges(false)); });
    const fidelity::Walked_samples samples(m.mesh, *f, number_of_samples, CGAL::parameters::default_values());
    const fidelity::Summary there = fidelity::summarise(samples.distances),
                            back = fidelity::summarise(fidelity::Distance_to_mesh(m.mesh)(samples.feet));
    const double size = samples.size;
    times.add(seconds / seconds_of_vertices);
    table.add(m.name, m.mesh.number_of_vertices(), there.rms / size, there.of_999 / size, there.max / size,
              there.share_of_worst, there.lost, back.rms / size, back.of_999 / size, back.max / size,
              double(f->diagnostics().number_of_points) / double(of_vertices->diagnostics().number_of_points),
              seconds / seconds_of_vertices, seconds, f->diagnostics().number_of_refined_places,
              f->diagnostics().patches_off_facets, f->diagnostics().patches_on_fallback);
  }
  table.print();
  std::cout << "time, geometric mean " << times.mean() << ", worst " << times.largest() << std::endl;
}

void measure_truth(const std::vector<Named_mesh>& meshes)
{
  Table table("zero set of the reduced mesh to the whole one, over the distance of the reduced facets");
  table.add("mesh", "reduced by", "vertices", "ratio", "of vertices only", "facets: rms", "points");
  Ratios even, adapted, even_of_vertices, adapted_of_vertices;
  for (const Named_mesh& m : meshes)
  {
    const fidelity::Distance_to_mesh distance(m.mesh);
    for (const std::string how : {"even", "Lindstrom-Turk", "Garland-Heckbert"})
      for (const std::size_t part : {4, 8})
      {
        const Mesh mesh = reduced(m.mesh, how, part);
        const Function f(mesh), of_vertices(mesh, params::points_on_facets(false).detect_edges(false));
        const fidelity::Walked_samples samples(mesh, f, number_of_samples, CGAL::parameters::default_values()),
            samples_of_vertices(mesh, of_vertices, number_of_samples, CGAL::parameters::default_values());
        const double facets = fidelity::summarise(distance(samples.points)).rms;
        const double ratio = fidelity::summarise(distance(samples.feet)).rms / facets;
        const double ratio_of_vertices = fidelity::summarise(distance(samples_of_vertices.feet)).rms / facets;
        (how == "even" ? even : adapted).add(ratio);
        (how == "even" ? even_of_vertices : adapted_of_vertices).add(ratio_of_vertices);
        table.add(m.name, how, mesh.number_of_vertices(), ratio, ratio_of_vertices, facets / samples.size,
                  double(f.diagnostics().number_of_points) / double(of_vertices.diagnostics().number_of_points));
      }
  }
  table.print();
  std::cout << "even: geometric mean " << even.mean() << " (of vertices only " << even_of_vertices.mean() << "), worst "
            << even.largest() << " (" << even_of_vertices.largest() << ")\nadapted: geometric mean " << adapted.mean() << " ("
            << adapted_of_vertices.mean() << "), worst " << adapted.largest() << " (" << adapted_of_vertices.largest() << ")"
            << std::endl;
}

struct Cad_figures
{
  double max, back;
  std::size_t lost;
};

Cad_figures cad_figures(const Mesh& mesh, const fidelity::Walked_samples& samples, const double chord)
{
  const fidelity::Summary there = fidelity::summarise(samples.distances),
                          back = fidelity::summarise(fidelity::Distance_to_mesh(mesh)(samples.feet));
  return Cad_figures{there.max / chord, back.max / chord, there.lost};
}

void measure_cad(const bool is_whole)
{
  Table table("shapes of CAD programs: largest distance over the chord height of a side (radius is 1)");
  table.add("shape", "sides", "bands", "chord", "there", "back", "of vertices", "lost", "points", "sharp: there", "back");
  const std::vector<std::size_t> sides = is_whole ? std::vector<std::size_t>{12, 16, 24, 32, 48, 64, 96, 128, 180, 256, 360}
                                                  : std::vector<std::size_t>{12, 64, 360};
  const std::vector<std::size_t> bands = is_whole ? std::vector<std::size_t>{1, 2, 3, 4, 5} : std::vector<std::size_t>{1, 3};
  for (const std::string shape : {"open cylinder", "cone", "cylinder", "tube", "plate"})
    for (const std::size_t n : sides)
      for (const std::size_t k : bands)
      {
        if (shape == "plate" && k > 1)
          continue;
        const Mesh mesh = shape == "open cylinder" ? cad_shapes::cylinder(n, k, false)
                          : shape == "cone"        ? cad_shapes::cone(n, k)
                          : shape == "cylinder"    ? cad_shapes::cylinder(n, k, true)
                          : shape == "tube"        ? cad_shapes::tube(n, k)
                                                   : cad_shapes::plate(n / 4);
        const double chord = cad_shapes::chord_height(n);
        const Function f(mesh), of_vertices(mesh, params::points_on_facets(false).detect_edges(false));
        const auto defaults = CGAL::parameters::default_values();
        const Cad_figures with = cad_figures(mesh, fidelity::Walked_samples(mesh, f, 20000, defaults), chord),
                          without = cad_figures(mesh, fidelity::Walked_samples(mesh, of_vertices, 20000, defaults), chord);
        Mesh with_regions = mesh;
        const auto crease = with_regions.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first;
        const auto region = with_regions.add_property_map<Mesh::Face_index, std::size_t>("f:region", 0).first;
        Hde::detect_surface_regions(with_regions, crease, region, params::sharp_angle(50));
        const Sharp_function sharp(with_regions, region);
        const Cad_figures of_sharp = cad_figures(
            mesh, fidelity::Walked_samples(with_regions, sharp, 20000, CGAL::parameters::face_patch_map(region)), chord);
        table.add(shape, n, k, chord, with.max, with.back, without.max, with.lost,
                  double(f.diagnostics().number_of_points) / double(of_vertices.diagnostics().number_of_points), of_sharp.max,
                  of_sharp.back);
      }
  table.print();
}

int main(int argc, char** argv)
{
  try
  {
    std::set<std::string> options;
    std::vector<Named_mesh> meshes;
    for (int i = 1; i < argc; ++i)
    {
      const std::string argument = argv[i];
      if (argument == "--all" || argument == "--facets" || argument == "--truth" || argument == "--cad")
      {
        options.insert(argument);
        continue;
      }
      Named_mesh m;
      m.name = argument.substr(argument.find_last_of('/') + 1);
      if (!PMP::IO::read_polygon_mesh(argument, m.mesh))
        throw std::invalid_argument("cannot read " + argument);
      PMP::remove_isolated_vertices(m.mesh);
      m.mesh.collect_garbage();
      meshes.push_back(m);
    }
    const bool is_whole = options.erase("--all") > 0;
    const auto is_asked = [&](const char* option) { return options.empty() || options.count(option) > 0; };
    if (is_asked("--facets"))
      measure_facets(meshes);
    if (is_asked("--truth"))
      measure_truth(meshes);
    if (is_asked("--cad"))
      measure_cad(is_whole);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return 1;
  }
  return 0;
}
