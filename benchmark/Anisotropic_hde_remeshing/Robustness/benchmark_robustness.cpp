// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshes meshes of all kinds, with weights from none to enormous, to numbers of faces from four to twenty times as many, and
// holds each result against what the package promises: a valid mesh of the same topology, in time, or a documented refusal with
// the mesh as it was.
//
// benchmark_robustness [--quick] [--list] MESH...
//   MESH     a file, or the name of a generated mesh; --list lists these
//   --quick  the middle of the weights and numbers only
// A mesh that is none, for its orientation, say, is tried as it is and once more after CGAL's repair.

#include "awkward_shapes.h"
#include "remeshing_checks.h"

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Rbf_implicit_function<shapes::Kernel> Function;
typedef shapes::Mesh Mesh;

// time a case may take, in seconds: some, and so much a face of input and output
constexpr double seconds_for_any = 10, seconds_for_a_face = 1e-3;
constexpr double largest_number_of_faces = 400000; // larger results are left out, and counted
constexpr double largest_distance = 1e-8;          // to the zero set, of the diagonal

struct Polygon_soup
{
  std::vector<shapes::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
};

struct Counts
{
  int valid = 0, refused = 0, failed = 0, left_out = 0;
};

std::optional<Polygon_soup> read(const std::string& name)
{
  Polygon_soup soup;
  const auto generated = awkward_shapes::all();
  const auto found = generated.find(name);
  if (found == generated.end())
  {
    bool is_read = false;
    try
    {
      is_read = CGAL::IO::read_polygon_soup(name, soup.points, soup.polygons);
    }
    catch (const std::exception&)
    {
    }
    return is_read ? std::optional<Polygon_soup>(soup) : std::nullopt;
  }
  const shapes::Soup triangles = found->second();
  soup.points = triangles.points;
  for (const auto& t : triangles.triangles)
    soup.polygons.push_back({t[0], t[1], t[2]});
  return soup;
}

bool is_finite(const Polygon_soup& soup)
{
  for (const shapes::Point_3& p : soup.points)
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      return false;
  return true;
}

bool has_valid_indices(const Polygon_soup& soup)
{
  for (const auto& polygon : soup.polygons)
    for (const std::size_t i : polygon)
      if (i >= soup.points.size())
        return false;
  return true;
}

std::optional<Mesh> mesh_of(const Polygon_soup& soup)
{
  if (!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
    return std::nullopt;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  return mesh;
}

Polygon_soup repaired(Polygon_soup soup)
{
  PMP::repair_polygon_soup(soup.points, soup.polygons);
  PMP::orient_polygon_soup(soup.points, soup.polygons);
  return soup;
}

// in a unit of its own, in which the predicates of the kernel neither overflow nor vanish
Mesh in_unit(Mesh mesh, const double unit)
{
  for (const Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + (mesh.point(v) - CGAL::ORIGIN) / unit;
  return mesh;
}

// what the package promises, of the first thing that does not hold; empty if all does
std::string broken_promise(const Mesh& before, const Mesh& after, const Function& function, const Hde::Remeshing_result& result)
{
  if (!CGAL::is_valid_polygon_mesh(after))
    return "the mesh is not valid";
  if (!CGAL::is_triangle_mesh(after))
    return "not all faces are triangles";
  const Hde::Topology_measures old_topology = Hde::measure_topology(before), topology = Hde::measure_topology(after);
  if (topology.number_of_components != old_topology.number_of_components)
    return "the number of components changed";
  if (topology.number_of_boundary_loops != old_topology.number_of_boundary_loops)
    return "the number of boundaries changed";
  if (topology.euler_characteristic != old_topology.euler_characteristic)
    return "the Euler characteristic changed";
  for (const Mesh::Vertex_index v : after.vertices())
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(after.point(v)[i]))
        return "a coordinate is not finite";
  const double diagonal = shapes::bounding_box_diagonal(before), unit = std::exp2(std::round(std::log2(diagonal)));
  if (Hde::measure_shape(in_unit(after, unit)).number_of_degenerate_faces >
      Hde::measure_shape(in_unit(before, unit)).number_of_degenerate_faces)
    return "there are new degenerate faces";
  const std::size_t folds = Hde::measure_embedding(after, function).number_of_folded_faces;
  if (folds > Hde::measure_embedding(before, function).number_of_folded_faces)
    return std::to_string(folds) + " faces are folded";
  std::size_t number_off_surface = 0;
  for (const Mesh::Vertex_index v : after.vertices())
    if (!after.is_border(v))
    {
      const double slope = std::sqrt(function.gradient(after.point(v)).squared_length());
      number_off_surface += !(std::abs(function(after.point(v))) <= largest_distance * diagonal * slope);
    }
  if (number_off_surface > result.projections.closest_point)
    return std::to_string(number_off_surface) + " vertices off the surface, " +
           std::to_string(result.projections.closest_point) + " counted";
  return "";
}

class Cases
{
public:
  Cases(const std::string& name, const bool is_quick) : m_name(name), m_is_quick(is_quick) {}

  Counts operator()()
  {
    const std::optional<Polygon_soup> soup = read(m_name);
    if (!soup)
    {
      refuse("CGAL reads no mesh");
      return m_counts;
    }
    if (!has_valid_indices(*soup))
    {
      refuse("faces name vertices that do not exist");
      return m_counts;
    }
    if (const std::optional<Mesh> mesh = mesh_of(*soup))
      run(*mesh);
    else
    {
      refuse("no manifold mesh");
      if (is_finite(*soup))
        if (const std::optional<Mesh> mended = mesh_of(repaired(*soup)))
        {
          m_name += " (repaired)";
          run(*mended);
        }
    }
    return m_counts;
  }

private:
  void refuse(const std::string& reason)
  {
    ++m_counts.refused;
    ++m_reasons[reason];
  }

  void fail(const std::string& what)
  {
    ++m_counts.failed;
    std::cout << "FAILED " << m_name << m_parameters << ": " << what << std::endl;
  }

  void run(Mesh mesh)
  {
    PMP::triangulate_faces(mesh);
    mesh.collect_garbage();
    CGAL::Real_timer timer;
    timer.start();
    std::optional<Function> function;
    try
    {
      function.emplace(mesh);
    }
    catch (const std::invalid_argument& error)
    {
      refuse(error.what());
    }
    catch (const std::exception& error)
    {
      fail(error.what());
    }
    const double seconds = timer.time();
    check_time(seconds, double(mesh.number_of_faces()));
    const double n = double(mesh.number_of_faces()), d = n > 0 ? shapes::bounding_box_diagonal(mesh) : 1;
    const std::vector<double> sigmas = m_is_quick ? std::vector<double>{0, 0.05} : std::vector<double>{0, 0.01, 0.1, 1, 10};
    const std::vector<double> numbers =
        m_is_quick ? std::vector<double>{n / 2, 2 * n} : std::vector<double>{4, n / 10, n, 4 * n, 20 * n};
    for (const double sigma : sigmas)
      for (const double number : numbers)
        if (number > largest_number_of_faces)
          ++m_counts.left_out;
        else
          run(mesh, function, sigma * d, std::size_t(std::ceil(number)));
    print();
  }

  // one case; without a function the package builds it, or refuses to
  void run(const Mesh& input, const std::optional<Function>& function, const double sigma, const std::size_t number_of_faces)
  {
    std::ostringstream text;
    text << ", sigma " << sigma << ", " << input.number_of_faces() << " to " << number_of_faces << " faces";
    m_parameters = text.str();
    Mesh mesh = input;
    const auto np = CGAL::parameters::sigma(sigma).number_of_target_faces((std::max)(number_of_faces, std::size_t(1)));
    CGAL::Real_timer timer;
    timer.start();
    try
    {
      const Hde::Remeshing_result result = function ? CGAL::anisotropic_hde_remeshing<Tag>(mesh, *function, np)
                                                    : CGAL::anisotropic_hde_remeshing<Tag>(mesh, np);
      const double seconds = timer.time();
      const std::string problem = function ? broken_promise(input, mesh, *function, result) : "not refused";
      if (!problem.empty())
        fail(problem);
      else if (check_time(seconds, double(input.number_of_faces() + mesh.number_of_faces())))
        ++m_counts.valid;
    }
    catch (const std::invalid_argument& error)
    {
      if (remeshing_checks::digest(mesh) == remeshing_checks::digest(input))
        refuse(error.what());
      else
        fail(std::string("the mesh was changed before the refusal: ") + error.what());
    }
    catch (const std::exception& error)
    {
      fail(error.what());
    }
  }

  bool check_time(const double seconds, const double number_of_faces)
  {
    const bool is_in_time = seconds <= seconds_for_any + seconds_for_a_face * number_of_faces;
    if (!is_in_time)
      fail(std::to_string(seconds) + " s");
    return is_in_time;
  }

  void print() const
  {
    std::cout << m_name << ": " << m_counts.valid << " valid, " << m_counts.refused << " refused, " << m_counts.failed
              << " failed, " << m_counts.left_out << " left out" << std::endl;
  }

public:
  void print_reasons() const
  {
    for (const auto& [reason, number] : m_reasons)
      std::cout << "  " << m_name << ": refused " << number << " times: " << reason << std::endl;
  }

private:
  std::string m_name, m_parameters;
  bool m_is_quick;
  Counts m_counts;
  std::map<std::string, int> m_reasons;
};

} // namespace

int main(int argc, char* argv[])
{
  bool is_quick = false;
  Counts sum;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--quick")
      is_quick = true;
    else if (argument == "--list")
    {
      for (const auto& shape : awkward_shapes::all())
        std::cout << shape.first << "\n";
      return 0;
    }
    else
    {
      Cases cases(argument, is_quick);
      const Counts counts = cases();
      cases.print_reasons();
      sum.valid += counts.valid;
      sum.refused += counts.refused;
      sum.failed += counts.failed;
      sum.left_out += counts.left_out;
    }
  }
  std::cout << sum.valid + sum.refused << " passed, " << sum.failed << " failed (" << sum.valid << " valid, " << sum.refused
            << " refused, " << sum.left_out << " left out)" << std::endl;
  return sum.failed == 0 ? 0 : 1;
}
