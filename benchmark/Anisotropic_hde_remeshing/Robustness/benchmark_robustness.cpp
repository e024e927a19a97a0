// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshes meshes of all kinds, with weights from none to enormous, to numbers of faces from four to twenty times as many, and
// holds each result against what the package promises: a valid mesh of the same topology that intersects itself no more than before,
// in time, or a documented refusal with the mesh as it was.
//
// benchmark_robustness [--quick] [--list] MESH...
//   MESH     a file, or the name of a generated mesh; --list lists these
//   --quick  the middle of the weights and numbers only
// A mesh that is none, for its orientation, say, is tried as it is and once more after CGAL's repair.

#include "awkward_shapes.h"
#include "polygon_soups.h"
#include "promises.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
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

using polygon_soups::Polygon_soup;
typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Rbf_implicit_function<shapes::Kernel, CGAL::Polyharmonic_rbf, Tag> Function;
typedef shapes::Mesh Mesh;

// time a case may take, in seconds: some, and so much a face of input and output
constexpr double seconds_for_any = 10, seconds_for_a_face = 1e-3;
constexpr double largest_number_of_faces = 400000; // larger results are left out, and counted

struct Counts
{
  int valid = 0, refused = 0, failed = 0, left_out = 0;
};

std::optional<Polygon_soup> read(const std::string& name)
{
  const auto generated = awkward_shapes::all();
  const auto found = generated.find(name);
  if (found != generated.end())
    return polygon_soups::to_polygons(found->second());
  Polygon_soup soup;
  try
  {
    if (CGAL::IO::read_polygon_soup(name, soup.points, soup.polygons))
      return soup;
  }
  catch (const std::exception&)
  {
  }
  return std::nullopt;
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
    if (!polygon_soups::has_valid_indices(*soup))
    {
      refuse("faces name vertices that do not exist");
      return m_counts;
    }
    if (const std::optional<Mesh> mesh = polygon_soups::mesh_of(*soup))
      run(*mesh);
    else
    {
      refuse("no manifold mesh");
      if (polygon_soups::has_finite_points(*soup))
        if (const std::optional<Mesh> mended = polygon_soups::mesh_of(polygon_soups::repaired(*soup)))
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

  void run(const Mesh& mesh)
  {
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
    check_time(timer.time(), double(mesh.number_of_faces()));
    const double n = double(mesh.number_of_faces()),
                 d = n > 0 && promises::has_finite_points(mesh) ? promises::diagonal(mesh) : 1;
    const std::vector<double> sigmas = m_is_quick ? std::vector<double>{0, 0.05} : std::vector<double>{0, 0.01, 0.1, 1, 10};
    const std::vector<double> numbers =
        m_is_quick ? std::vector<double>{n / 2, 2 * n} : std::vector<double>{4, n / 10, n, 4 * n, 20 * n};
    for (const double sigma : sigmas)
      for (const double number : numbers)
        run(mesh, function, sigma * d, number);
    print();
  }

  void run(const Mesh& input, const std::optional<Function>& function, const double sigma, const double number_of_faces)
  {
    if (number_of_faces > largest_number_of_faces)
    {
      ++m_counts.left_out;
      return;
    }
    const std::size_t n = (std::max)(std::size_t(std::ceil(number_of_faces)), std::size_t(1));
    std::ostringstream text;
    text << ", sigma " << sigma << ", " << input.number_of_faces() << " to " << n << " faces";
    m_parameters = text.str();
    const promises::Outcome outcome = promises::outcome<Tag>(input, function, sigma, n, true);
    if (outcome.kind == promises::Kind::REFUSED)
      refuse(outcome.text);
    else if (outcome.kind == promises::Kind::BROKEN)
      fail(outcome.text);
    else if (check_time(outcome.seconds, double(input.number_of_faces() + outcome.number_of_faces)))
      ++m_counts.valid;
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
