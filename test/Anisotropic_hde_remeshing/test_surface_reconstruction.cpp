// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// From points to a mesh in one call: the mesh is closed, near, looks outward, has all components, and nothing takes for ever.

#include "check.h"
#include "shapes.h"

#include <CGAL/rbf_surface_reconstruction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace shapes;
namespace AHR = CGAL::Anisotropic_hde_remeshing;
namespace params = AHR::parameters;

typedef std::vector<std::pair<Point_3, Vector_3>> Points;
typedef AHR::Reconstruction_result Result;

// points on a sphere; with a negative radius it looks inward
Points sphere(const std::size_t n, const Point_3& centre, const double radius)
{
  Points result;
  for (const Point_3& p : spiral_points(n))
    result.emplace_back(centre + std::abs(radius) * (p - CGAL::ORIGIN), radius * (p - CGAL::ORIGIN));
  return result;
}

Points operator+(Points a, const Points& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

double volume(const Mesh& mesh)
{
  double result = 0;
  for (const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    const Vector_3 p = mesh.point(mesh.source(h)) - CGAL::ORIGIN, q = mesh.point(mesh.target(h)) - CGAL::ORIGIN,
                   r = mesh.point(mesh.target(mesh.next(h))) - CGAL::ORIGIN;
    result += CGAL::cross_product(p, q) * r / 6;
  }
  return result;
}

double volume_of_ball(const double radius) { return 4 * pi / 3 * radius * radius * radius; }

bool is_good(const Mesh& mesh, const Result& result)
{
  return CHECK(CGAL::is_valid_polygon_mesh(mesh)) && CHECK(CGAL::is_closed(mesh)) && CHECK(CGAL::is_triangle_mesh(mesh)) &&
         CHECK(result.number_of_vertices == mesh.number_of_vertices()) &&
         CHECK(result.number_of_faces == mesh.number_of_faces());
}

bool are_equal(const Mesh& a, const Mesh& b)
{
  if (a.number_of_vertices() != b.number_of_vertices() || a.number_of_faces() != b.number_of_faces())
    return false;
  for (const Mesh::Vertex_index v : a.vertices())
    if (a.point(v) != b.point(v))
      return false;
  for (const Mesh::Face_index f : a.faces())
    if (a.target(a.halfedge(f)) != b.target(b.halfedge(f)) || a.source(a.halfedge(f)) != b.source(b.halfedge(f)))
      return false;
  return true;
}

void test_ellipsoid()
{
  const Ellipsoid_function f;
  Points points;
  for (const Point_3& p : spiral_points(3000))
  {
    const Point_3 q(f.a * p.x(), f.b * p.y(), f.c * p.z());
    points.emplace_back(q, f.gradient(q));
  }
  Mesh mesh;
  const Result result = CGAL::rbf_surface_reconstruction(points, mesh);
  is_good(mesh, result);
  double farthest = 0;
  for (const Point_3& p : mesh.points())
    farthest = (std::max)(farthest, std::abs(f(p)) / std::sqrt(f.gradient(p).squared_length()));
  std::cout << "ellipsoid: " << mesh.number_of_vertices() << " vertices, at most " << farthest << " off, volume "
            << volume(mesh) / volume_of_ball(1) << " of 10, " << result.number_of_evaluations << " evaluations" << std::endl;
  CHECK(result.number_of_points == points.size());
  CHECK(result.number_of_components == 1);
  CHECK(result.number_of_missed_places == 0);
  CHECK(result.number_of_closed_holes == 0);
  CHECK(!result.is_remeshed);
  CHECK(mesh.number_of_vertices() > points.size() / 2 && mesh.number_of_vertices() < 2 * points.size());
  CHECK(farthest < 5e-3);
  CHECK_CLOSE(volume(mesh) / volume_of_ball(1), 10, 0.1);
  CHECK(result.number_of_evaluations < 100 * mesh.number_of_vertices());
  // the same once more, wherever in memory the triangulation is
  const std::vector<std::vector<char>> memory(1000, std::vector<char>(1000));
  Mesh again;
  CGAL::rbf_surface_reconstruction(points, again);
  CHECK(are_equal(mesh, again));
  CHECK(result.function_seconds > 0 && result.meshing_seconds > 0 && result.remeshing_seconds == 0);
}

// All components are found: of any size, inside each other, of the size of a facet.
void test_components()
{
  const Points points =
      sphere(2000, Point_3(0, 0, 0), 1) + sphere(500, Point_3(0, 3, 0), 0.5) + sphere(60, Point_3(2, 0, 1), 0.1);
  Mesh mesh;
  Result result = CGAL::rbf_surface_reconstruction(points, mesh);
  is_good(mesh, result);
  CHECK(result.number_of_components == 3);
  CHECK(result.number_of_missed_places == 0);

  mesh.clear();
  result = CGAL::rbf_surface_reconstruction(sphere(2000, Point_3(0, 0, 0), 1) + sphere(500, Point_3(0, 0.1, 0), -0.5), mesh);
  is_good(mesh, result);
  CHECK(result.number_of_components == 2);
  CHECK_CLOSE(volume(mesh), volume_of_ball(1) - volume_of_ball(0.5), 0.05);

  mesh.clear();
  result = CGAL::rbf_surface_reconstruction(sphere(500, Point_3(0, 0, 0), 1) + sphere(200, Point_3(3, 0, 0), 0.2), mesh,
                                            params::facet_size(1.).facet_distance(1.));
  is_good(mesh, result);
  CHECK(result.number_of_components == 2);
  CHECK(mesh.number_of_vertices() < 100);
  CHECK(result.facet_size == 1 && result.facet_distance == 1);
}

// The mesh is remeshed if a number is asked for, and added to what the caller's has.
void test_number_of_faces()
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  for (const Result& result :
       {CGAL::rbf_surface_reconstruction(sphere(2000, Point_3(0, 0, 0), 1), mesh, params::number_of_target_faces(600)),
        CGAL::rbf_surface_reconstruction(sphere(2000, Point_3(3, 0, 0), 1), mesh, params::number_of_target_faces(600))})
  {
    CHECK(result.is_remeshed);
    CHECK(std::abs(double(result.number_of_faces) - 600) <= 6);
    CHECK(result.remeshing.number_of_faces == result.number_of_faces);
    CHECK(result.remeshing.number_of_unprojected_vertices == 0);
    CHECK(result.facet_size > 2 * result.spacing);
  }
  CHECK(CGAL::is_closed(mesh));
  CHECK(mesh.number_of_faces() > 1180 && mesh.number_of_faces() < 1220);
}

void test_flaws()
{
  Points points = sphere(2000, Point_3(0, 0, 0), 1);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.01, 0.01);
  for (std::pair<Point_3, Vector_3>& p : points)
    p.first = p.first + uniform(random) * p.second;
  for (std::size_t i = 0; i < points.size(); i += 100)
  {
    points[i] = {Point_3(CGAL::ORIGIN + 1.4 * (points[i].first - CGAL::ORIGIN)), -points[i].second};
    points[i + 50].second = -points[i + 50].second;
  }
  Mesh mesh;
  const Result result =
      CGAL::rbf_surface_reconstruction(points, mesh, params::detect_outliers(true).smoothing(AHR::AUTOMATIC_SMOOTHING));
  is_good(mesh, result);
  double farthest = 0;
  for (const Point_3& p : mesh.points())
    farthest = (std::max)(farthest, std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1));
  std::cout << "flaws: noise " << result.noise << ", vertices at most " << farthest << " off" << std::endl;
  CHECK(result.number_of_outliers == 20);
  CHECK(result.number_of_wrong_normals == 20);
  CHECK(result.number_of_components == 1);
  CHECK(result.noise > 0.004 && result.noise < 0.008); // the standard deviation is .0058
  CHECK(farthest < 0.01);
}

// half of a sphere is closed, or ends where the caller does not want that
void test_hole()
{
  Points points = sphere(2000, Point_3(0, 0, 0), 1);
  points.resize(1000);
  Mesh closed, open;
  const Result result = CGAL::rbf_surface_reconstruction(points, closed);
  is_good(closed, result);
  CHECK(result.number_of_closed_holes == 1);
  CHECK(result.number_of_components == 1);
  CHECK(CGAL::rbf_surface_reconstruction(points, open, params::close_holes(false)).number_of_closed_holes == 0);
  CHECK(CGAL::is_valid_polygon_mesh(open));
  CHECK(!CGAL::is_closed(open));
  CHECK(open.number_of_faces() > 1000);
}

template <typename NamedParameters>
std::string refusal(const NamedParameters& np)
{
  Mesh mesh;
  const std::string result =
      invalid_argument_message([&] { CGAL::rbf_surface_reconstruction(sphere(100, Point_3(0, 0, 0), 1), mesh, np); });
  CHECK(mesh.is_empty());
  return result;
}

void test_wrong_parameters()
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double size : {0., -1., nan, infinity})
  {
    CHECK(contains(refusal(params::facet_size(size).facet_distance(1.)), "facet_size is "));
    CHECK(contains(refusal(params::facet_size(1.).facet_distance(size)), "facet_distance is "));
  }
  CHECK(contains(refusal(params::facet_size(1e-9).facet_distance(1.)), "facet_size is 1e-9"));
  CHECK(contains(refusal(params::facet_size(1.).facet_distance(1e-12)), "facet_distance is 1e-12"));
  for (const double angle : {-1., 30.5, nan})
    CHECK(contains(refusal(params::facet_angle(angle)), "facet_angle is "));
  CHECK(contains(refusal(params::smoothing(-1.)), "smoothing is "));
  CHECK(contains(refusal(params::number_of_target_faces(0)), "number_of_target_faces is 0"));
  Mesh mesh;
  CHECK(contains(invalid_argument_message([&] { CGAL::rbf_surface_reconstruction(Points(), mesh); }), "no points"));
}

// Points that are no surface: the mesher would ask for ever.
void test_no_surface()
{
  Points points;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto triple = [&]
  {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    return Vector_3(x, y, z);
  };
  for (int i = 0; i < 3000; ++i)
  {
    const Point_3 p = CGAL::ORIGIN + triple();
    points.emplace_back(p, triple());
  }
  Mesh mesh;
  std::string message;
  try
  {
    CGAL::rbf_surface_reconstruction(points, mesh, params::facet_size(0.4).facet_distance(0.4));
  }
  catch (const std::runtime_error& error)
  {
    message = error.what();
  }
  std::cout << message << std::endl;
  CHECK(contains(message, "too rough"));
  CHECK(contains(message, "detect_outliers"));
  CHECK(mesh.is_empty());
}

struct Visitor_that_stops : AHR::Remeshing_visitor
{
  double last_share = 0;
  double stop = 2; // from this share on
  int calls_by_mesher = 0;

  void progress(const double share)
  {
    CHECK(share >= last_share && share <= 1);
    calls_by_mesher += share > 0.32 && share < 0.99 ? 1 : 0; // the function has the first .3
    last_share = share;
  }
  bool go_further() { return last_share < stop; }
};

void test_visitor()
{
  const Points points = sphere(2000, Point_3(0, 0, 0), 1);
  Visitor_that_stops visitor;
  Mesh mesh;
  CGAL::rbf_surface_reconstruction(points, mesh, params::visitor(std::ref(visitor)));
  CHECK(visitor.last_share == 1);
  CHECK(visitor.calls_by_mesher >= 3);
  const std::size_t number_of_faces = mesh.number_of_faces();
  for (const double share : {0.1, 0.3, 0.5})
  {
    visitor = Visitor_that_stops();
    visitor.stop = share;
    CHECK_THROWS(CGAL::rbf_surface_reconstruction(points, mesh, params::visitor(std::ref(visitor))), AHR::Interrupted);
    CHECK(mesh.number_of_faces() == number_of_faces);
  }
}

int main()
{
  test_ellipsoid();
  test_components();
  test_number_of_faces();
  test_flaws();
  test_hole();
  test_wrong_parameters();
  test_no_surface();
  test_visitor();
  return check_summary();
}
