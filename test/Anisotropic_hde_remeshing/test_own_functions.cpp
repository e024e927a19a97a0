// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Functions of the user's: lambdas and others, with a gradient and without. And functions of the package that were moved from.

#include "remeshing_checks.h"

#include <CGAL/Anisotropic_hde_remeshing/Interpolated_vertex_field.h>
#include <CGAL/Anisotropic_hde_remeshing/make_implicit_function.h>
#include <CGAL/Piecewise_rbf_implicit_function.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

double ellipsoid_value(const Point_3& p) { return Ellipsoid_function()(p); }
double ellipsoid_value_without_exceptions(const Point_3& p) noexcept { return Ellipsoid_function()(p); }

struct With_call_operator
{
  double operator()(const Point_3& p) const noexcept { return ellipsoid_value(p); }
};

// the types are deduced, and the gradient is right
template <typename Function>
void check_ellipsoid(const Function& f, const double error)
{
  CHECK(Hde::internal::is_implicit_function<Function>);
  CHECK((std::is_same<typename Function::Point_3, Point_3>::value && std::is_same<typename Function::FT, Kernel::FT>::value));
  const Ellipsoid_function exact;
  for (const Point_3& p : {Point_3(1, 0, 0), Point_3(0, 2, 0), Point_3(0.3, -1.2, 3), Point_3(-0.1, 0.2, -4.9)})
  {
    CHECK(f(p) == exact(p));
    CHECK(std::sqrt((f.gradient(p) - exact.gradient(p)).squared_length()) <=
          error * std::sqrt(exact.gradient(p).squared_length()));
  }
}

void test_kinds_of_functions()
{
  const auto lambda = [](const Point_3& p) { return ellipsoid_value(p); };
  const auto generic = [](const auto& p) { return ellipsoid_value(p); };
  const auto by_value = [](const Point_3 p) { return float(ellipsoid_value(p)); };
  const auto gradient = [](const auto& p) { return Ellipsoid_function().gradient(p); };
  check_ellipsoid(Hde::make_implicit_function(lambda, 10), 1e-9);
  check_ellipsoid(Hde::make_implicit_function(lambda), 1e-8);
  check_ellipsoid(Hde::make_implicit_function<Kernel>(generic, 10), 1e-9);
  check_ellipsoid(Hde::make_implicit_function(&ellipsoid_value, 10), 1e-9);
  check_ellipsoid(Hde::make_implicit_function(ellipsoid_value, 10), 1e-9);
  check_ellipsoid(Hde::make_implicit_function(ellipsoid_value_without_exceptions, 10), 1e-9);
  check_ellipsoid(Hde::make_implicit_function(With_call_operator(), 10), 1e-9);
  check_ellipsoid(Hde::make_implicit_function(std::function<double(const Point_3&)>(lambda), 10), 1e-9);
  check_ellipsoid(Hde::make_implicit_function(lambda, gradient), 0);
  check_ellipsoid(Hde::make_implicit_function<Kernel>(generic, gradient), 0);
  CHECK((std::is_same<decltype(Hde::make_implicit_function(by_value))::FT, Kernel::FT>::value));
  for (const double bad : {0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK(contains(invalid_argument_message([&] { Hde::make_implicit_function(lambda, bad); }), "size"));

  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;
  const auto exact = Hde::make_implicit_function([](const Exact::Point_3& p) { return p.x() * p.y() - p.z(); });
  const Exact::Vector_3 g = exact.gradient(Exact::Point_3(2, 3, 1));
  CHECK_CLOSE(CGAL::to_double(g.x()), 3, 1e-9);
  CHECK_CLOSE(CGAL::to_double(g.y()), 2, 1e-9);
  CHECK_CLOSE(CGAL::to_double(g.z()), -1, 1e-9);
}

// The documented accuracy, whatever the unit: a product of a distance and of ripples of the size of details, far from the origin, too.
void test_accuracy()
{
  for (const double size : {1e-6, 1., 1e6})
    for (const double offset : {0., 1e3})
      for (const double detail : {1e-2, 1e-3})
      {
        const double c = offset * size, r = detail * size;
        const auto ripples = [=](const Point_3& p)
        { return std::sqrt(CGAL::squared_distance(p, Point_3(c, c, c))) * std::cos((p.x() - c) / r) / r - 0.9; };
        const auto f = Hde::make_implicit_function(ripples, size);
        double worst = 0;
        for (int k = 0; k < 50; ++k)
        {
          const double a = 0.7 * k, b = 1.3 * k;
          const Point_3 p(c + size / 2 * std::cos(a) * std::cos(b), c + size / 2 * std::sin(a) * std::cos(b),
                          c + size / 2 * std::sin(b));
          const Vector_3 d = p - Point_3(c, c, c);
          const double length = std::sqrt(d.squared_length());
          const Vector_3 exact = std::cos(d.x() / r) / r / length * d - Vector_3(length * std::sin(d.x() / r) / r / r, 0, 0);
          worst = (std::max)(worst, std::sqrt((f.gradient(p) - exact).squared_length() / exact.squared_length()));
        }
        std::cout << "size " << size << ", offset " << offset << ", detail " << detail << ": " << worst << std::endl;
        CHECK(worst < (offset == 0 ? 1 : 100) * (detail > 5e-3 ? 1e-9 : 5e-8));
      }
}

// as with the class, and by differences on the surface, too
void test_remeshing()
{
  const auto np = params::relative_sigma(0.05).number_of_target_faces(1500).number_of_iterations(5);
  const auto remeshed = [&](const auto& function)
  {
    Mesh mesh = ellipsoid(2);
    const Mesh input = mesh;
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, np);
    check_validity("ellipsoid", input, mesh, Ellipsoid_function());
    CHECK(result.number_of_unprojected_vertices == 0);
    return mesh;
  };
  const Mesh by_class = remeshed(Ellipsoid_function());
  const auto value = [](const Point_3& p) { return ellipsoid_value(p); };
  const auto gradient = [](const Point_3& p) { return Ellipsoid_function().gradient(p); };
  CHECK(digest(remeshed(Hde::make_implicit_function(value, gradient))) == digest(by_class));
  check_number_of_faces(remeshed(Hde::make_implicit_function(value, 11)), 1500);

  // a millionth of it, and far from the origin
  for (const std::pair<double, double>& place : {std::make_pair(1e-6, 0.), std::make_pair(1., 1e3)})
  {
    const double s = place.first;
    const Vector_3 shift(place.second, 0, 0);
    Mesh mesh = ellipsoid(2);
    for (const Mesh::Vertex_index v : mesh.vertices())
      mesh.point(v) = CGAL::ORIGIN + s * (mesh.point(v) - CGAL::ORIGIN) + shift;
    const auto moved = [=](const Point_3& p) { return ellipsoid_value(CGAL::ORIGIN + (p - CGAL::ORIGIN - shift) / s); };
    const Hde::Remeshing_result result =
        CGAL::anisotropic_hde_remeshing<Tag>(mesh, Hde::make_implicit_function(moved, 11 * s), np);
    CHECK(result.number_of_unprojected_vertices == 0);
    double largest = 0;
    for (const Mesh::Vertex_index v : mesh.vertices())
      largest = (std::max)(largest, std::abs(moved(mesh.point(v))));
    CHECK(largest < 1e-8);
  }
}

// a function that was moved from is as it was
void test_moved_functions()
{
  Mesh mesh = ellipsoid(2);
  const Point_3 p(0.2, 0.3, 0.1);
  typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> Rbf;
  Rbf rbf(mesh);
  const double value = rbf(p);
  Rbf other(std::move(rbf));
  CHECK(rbf(p) == value && other(p) == value);
  other = std::move(rbf);
  CHECK(rbf(p) == value && rbf.diagnostics().number_of_points >= mesh.number_of_vertices());

  auto regions = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region", 0).first;
  typedef CGAL::Piecewise_rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> Piecewise;
  Piecewise pieces(mesh, regions);
  const double value_of_piece = pieces.piece(0)(p);
  Piecewise other_pieces(std::move(pieces));
  CHECK(pieces.number_of_pieces() == 1 && pieces.piece(0)(p) == value_of_piece);
  Piecewise::Piece piece = pieces.piece(0);
  const Piecewise::Piece other_piece(std::move(piece));
  CHECK(piece(p) == value_of_piece && other_piece(p) == value_of_piece);

  auto numbers = mesh.add_property_map<Mesh::Vertex_index, double>("v:number", 2.).first;
  Hde::Interpolated_vertex_field field(mesh, numbers);
  const Hde::Interpolated_vertex_field other_field(std::move(field));
  CHECK_CLOSE(field(p), 2, 1e-12);
  CHECK_CLOSE(other_field(p), 2, 1e-12);
}

int main()
{
  test_kinds_of_functions();
  test_accuracy();
  test_remeshing();
  test_moved_functions();
  return check_summary();
}
