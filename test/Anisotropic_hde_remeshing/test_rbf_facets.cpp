// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The function stays on the facets that it is built from: points on facets, and the check of all facets.

#include "check.h"
#include "shapes.h"

#include <CGAL/Piecewise_rbf_implicit_function.h>
#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_check.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <utility>
#include <vector>

using namespace shapes;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
namespace SMS = CGAL::Surface_mesh_simplification;

typedef CGAL::Rbf_implicit_function<Kernel> Function;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Parallel_function;

// the side of a cylinder of radius 1 and height 4, with `bands` rows of long facets between straight rings
Mesh open_cylinder(const std::size_t sides, const std::size_t bands)
{
  Soup soup;
  for (std::size_t k = 0; k <= bands; ++k)
    for (std::size_t i = 0; i < sides; ++i)
    {
      const double angle = 2 * pi * double(i) / double(sides);
      soup.points.push_back(Point_3(std::cos(angle), std::sin(angle), 4. * double(k) / double(bands)));
    }
  for (std::size_t k = 0; k < bands; ++k)
    for (std::size_t i = 0; i < sides; ++i)
    {
      const std::size_t p = k * sides + i, q = k * sides + (i + 1) % sides;
      soup.triangles.push_back({p, q, q + sides});
      soup.triangles.push_back({p, q + sides, p + sides});
    }
  return to_mesh(soup);
}

struct At_number_of_vertices
{
  std::size_t n;
  template <typename FT, typename Profile>
  bool operator()(const FT&, const Profile& profile, std::size_t, std::size_t) const
  {
    return profile.surface_mesh().number_of_vertices() <= n;
  }
};

// reduced by edge collapse: facets are long where the surface is straight, and vertices are off it
Mesh adapted(Mesh mesh, const std::size_t n)
{
  SMS::edge_collapse(mesh, At_number_of_vertices{n},
                     CGAL::parameters::get_cost(SMS::LindstromTurk_cost<Mesh>())
                         .get_placement(SMS::LindstromTurk_placement<Mesh>())
                         .filter(SMS::Bounded_normal_change_filter<>()));
  mesh.collect_garbage();
  return mesh;
}

Mesh adapted_ellipsoid() { return adapted(ellipsoid(5), 400); }

// A fan of needles in a plane around a low tip, of which some have no area. The aspect ratio is 6,000.
Mesh needles()
{
  Soup soup;
  soup.points.push_back(Point_3(0, 0, 0.1));
  const std::size_t n = 2000;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * pi * double(i - i % 7 / 6) / double(n); // each seventh point is equal to the one before
    soup.points.push_back(Point_3(std::cos(angle), std::sin(angle), 0));
    soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return to_mesh(soup);
}

// a sphere of even triangles, of which the vertices are off it by up to a tenth of an edge
Mesh rough_sphere()
{
  Mesh mesh = icosphere(4);
  for (const Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + (1 + 0.007 * std::sin(1000. * double(std::size_t(v)))) * (mesh.point(v) - CGAL::ORIGIN);
  return mesh;
}

// points of all faces
std::vector<Point_3> points_of_faces(const Mesh& mesh)
{
  std::vector<Point_3> result;
  for (const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    for (const double u : {0.02, 0.2, 0.4, 0.6, 0.8, 0.98})
      for (const double v : {0., 0.1, 0.5, 0.9})
        result.push_back(CGAL::barycenter(mesh.point(mesh.source(h)), u, mesh.point(mesh.target(h)), (1 - u) * v,
                                          mesh.point(mesh.target(mesh.next(h))), (1 - u) * (1 - v)));
  }
  return result;
}

template <typename F>
double largest_distance(const F& f, const Mesh& mesh)
{
  double result = 0;
  for (const Point_3& p : points_of_faces(mesh))
  {
    const auto at_p = f.value_and_gradient(p);
    result = (std::max)(result, std::abs(at_p.first) / std::sqrt(at_p.second.squared_length()));
  }
  return result;
}

template <typename F, typename G>
bool are_equal(const F& f, const G& g, const std::vector<Point_3>& points)
{
  return std::all_of(points.begin(), points.end(),
                     [&](const Point_3& p) { return f.value_and_gradient(p) == g.value_and_gradient(p); });
}

// no more than twice the height of a side above its chord; through the vertices alone it is dented
void test_cylinders()
{
  for (const std::size_t sides : {12, 32, 64})
    for (const std::size_t bands : {1, 2, 5})
    {
      const Mesh mesh = open_cylinder(sides, bands);
      const double chord = 1 - std::cos(pi / double(sides));
      const Parallel_function f(mesh), of_vertices(mesh, params::points_on_facets(false).detect_edges(false));
      const double distance = largest_distance(f, mesh) / chord, of_vertices_only = largest_distance(of_vertices, mesh) / chord;
      std::cout << sides << " sides, " << bands << " bands: " << distance << " chord heights, of vertices only "
                << of_vertices_only << "; " << f.diagnostics().number_of_points_on_facets << " points on facets" << std::endl;
      CHECK(distance <= 2);
      CHECK(distance <= 1.05 * of_vertices_only);
      CHECK(bands > 1 || of_vertices_only > 5);
      CHECK(f.diagnostics().patches_on_fallback == 0);
      CHECK(of_vertices.diagnostics().number_of_points == mesh.number_of_vertices());
    }
}

// however long the facets are
void test_number_of_points()
{
  for (const std::size_t sides : {90, 360})
  {
    const Mesh mesh = open_cylinder(sides, 1);
    const Parallel_function f(mesh);
    std::cout << sides << " sides: " << f.diagnostics().number_of_points_on_facets << " points on facets" << std::endl;
    CHECK(f.diagnostics().number_of_points_on_facets > 0);
    CHECK(f.diagnostics().number_of_points_on_facets <= 4 * mesh.number_of_vertices());
    CHECK(largest_distance(f, mesh) <= 0.002);
  }
  const Mesh mesh = needles();
  const Parallel_function f(mesh);
  CHECK(f.diagnostics().number_of_points_on_facets <= 6 * mesh.number_of_vertices());
  for (const Point_3& p : points_of_faces(mesh))
    CHECK(std::isfinite(f(p)) && std::isfinite(f.gradient(p).squared_length()));
}

// The zero set is as near as promised at the middles of all edges and the centres of all facets. The spacings here are those of the
// vertices alone, which are not less than those that count.
void test_bound()
{
  const Mesh mesh = adapted_ellipsoid();
  const Parallel_function f(mesh);
  std::cout << "adapted ellipsoid: " << f.diagnostics().number_of_points_on_facets << " points on facets, "
            << f.diagnostics().number_of_refined_places << " of them where the surface was too far, "
            << f.diagnostics().patches_off_facets << " patches still are" << std::endl;
  CHECK(f.diagnostics().number_of_points_on_facets > 0);
  const auto spacing = [&](const Mesh::Vertex_index v)
  {
    double sum = 0;
    for (const Mesh::Vertex_index w : mesh.vertices_around_target(mesh.halfedge(v)))
      sum += std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
    return sum / double(mesh.degree(v));
  };
  const auto rise = [&](const Mesh::Halfedge_index h)
  {
    const Vector_3 way = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    double sum = 0;
    for (const Mesh::Vertex_index v : {mesh.source(h), mesh.target(h)})
    {
      const Vector_3 g = f.gradient(mesh.point(v));
      sum += std::abs(way * g) / std::sqrt(g.squared_length()) / 8;
    }
    return sum;
  };
  static const double tolerance = 1.1; // the gradient at a vertex is near to the normal
  for (const Mesh::Edge_index e : mesh.edges())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    const double size = (spacing(mesh.source(h)) + spacing(mesh.target(h))) / 2;
    const Point_3 middle = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    CHECK(std::abs(f(middle)) <= tolerance * 2 * (0.1 * size + rise(h)));
  }
  for (const Mesh::Face_index face : mesh.faces())
  {
    double size = 0, rises = 0;
    Vector_3 sum(0, 0, 0);
    for (const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(face)))
    {
      size += spacing(mesh.target(h)) / 3;
      rises += rise(h) * 4 / 9;
      sum = sum + (mesh.point(mesh.target(h)) - CGAL::ORIGIN) / 3;
    }
    CHECK(std::abs(f(CGAL::ORIGIN + sum)) <= tolerance * 2 * (0.1 * size + rises));
  }
}

// Of a real mesh no place is too far from the zero set, and many are without points and check. The bounds are those before points
// were added, which are not less.
void test_bound_of_animal()
{
  namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
  Mesh mesh;
  if (!CHECK(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(CGAL::data_file_path("meshes/camel.off"), mesh)))
    return;
  internal::Interruption interruption([] { return true; });
  const internal::Surface_sample sample =
      internal::sample_mesh(mesh, mesh.points(), CGAL::internal_np::Param_not_found(), interruption);
  const internal::Facet_edges edges(sample);
  const internal::Facet_check check(sample, edges);
  const auto too_far = [&](const Parallel_function& f)
  {
    std::size_t result = 0;
    for (std::size_t i = 0; i < check.size(); ++i)
    {
      const internal::Facet_check::Place place = check.place(i);
      const Eigen::Vector3d p = place.point / sample.normalization.scale + sample.normalization.centre;
      const double value = sample.normalization.scale * f(Point_3(p[0], p[1], p[2]));
      result += place.bound > 0 && !(std::abs(value) <= place.bound * (1 + 1e-9)) ? 1 : 0;
    }
    return result;
  };
  const Parallel_function f(mesh), of_vertices(mesh, params::points_on_facets(false).detect_edges(false));
  std::cout << "camel: of " << check.size() << " places too far " << too_far(f) << ", of vertices only " << too_far(of_vertices)
            << "; " << f.diagnostics().number_of_refined_places << " refined, " << f.diagnostics().patches_off_facets
            << " patches answered by facets" << std::endl;
  CHECK(too_far(f) == 0);
  CHECK(too_far(of_vertices) > 0);
  CHECK(f.diagnostics().number_of_refined_places > 0);
}

// the function is the same for any number of threads
void test_threads()
{
  const Mesh mesh = adapted_ellipsoid();
  CHECK(are_equal(Function(mesh), Parallel_function(mesh), points_of_faces(mesh)));
}

// Where all triangles are about alike nothing is added, and the function is that of the vertices, bit by bit. So it is with
// smoothing.
void test_even_meshes()
{
  for (const Mesh& mesh : {icosphere(3), torus(80, 20)})
  {
    const Parallel_function f(mesh), of_vertices(mesh, params::points_on_facets(false).detect_edges(false));
    CHECK(f.diagnostics().number_of_points_on_facets == 0);
    CHECK(are_equal(f, of_vertices, points_of_faces(mesh)));
  }
  const Mesh mesh = open_cylinder(32, 2);
  const Parallel_function f(mesh, params::smoothing(0.1)), of_vertices(mesh, params::smoothing(0.1).points_on_facets(false));
  CHECK(are_equal(f, of_vertices, points_of_faces(mesh)));
}

// Stretched triangles of an exact surface are no harm: the points on them are on the bend that the normals tell.
void test_stretched_triangles()
{
  const auto rms = [](const auto& f)
  {
    double sum = 0;
    for (const Point_3& q : spiral_points(5000))
    {
      const auto at_p = f.value_and_gradient(Point_3(q.x(), 2 * q.y(), 5 * q.z()));
      sum += at_p.first * at_p.first / at_p.second.squared_length() / 5000;
    }
    return std::sqrt(sum);
  };
  for (const unsigned int level : {3, 4})
  {
    const Mesh mesh = ellipsoid(level);
    const double with = rms(Parallel_function(mesh)),
                 without = rms(Parallel_function(mesh, params::points_on_facets(false).detect_edges(false)));
    std::cout << "ellipsoid, level " << level << ": " << with << ", of vertices only " << without << std::endl;
    CHECK(with <= 1.05 * without);
  }
}

// the nearest zero along the gradient, again and again
template <typename F>
Point_3 foot(const F& f, Point_3 p)
{
  for (int step = 0; step < 20; ++step)
  {
    const auto at_p = f.value_and_gradient(p);
    p = p - at_p.first / at_p.second.squared_length() * at_p.second;
  }
  return p;
}

// root mean square of the distances of points to facets
double rms_distance(const std::vector<Point_3>& points, const Mesh& mesh)
{
  namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
  const internal::Measured_mesh measured = internal::read_measured_mesh(mesh, CGAL::parameters::default_values());
  const internal::Closest_facet closest(measured.points, measured.faces);
  double sum = 0;
  for (const Point_3& p : points)
  {
    const internal::Vector x = internal::to_vector(p);
    sum += (closest(x).point - x).squaredNorm() / double(points.size());
  }
  return std::sqrt(sum);
}

// The surface of a reduced mesh is no further from the whole one than the reduced facets are. Through the vertices, which are
// off the surface, it is three to five times as far.
void test_adapted_meshes()
{
  Mesh lion;
  if (!CHECK(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(CGAL::data_file_path("meshes/lion-head.off"), lion)))
    return;
  for (const Mesh& whole : {bumpy_sphere(5), lion})
    for (const std::size_t part : {8, 16})
    {
      const Mesh mesh = adapted(whole, whole.number_of_vertices() / part);
      const Parallel_function f(mesh), of_vertices(mesh, params::points_on_facets(false).detect_edges(false));
      std::vector<Point_3> points, feet, feet_of_vertices;
      for (const Mesh::Face_index face : mesh.faces())
        for (const auto& [u, v] : {std::pair(1. / 3, 1. / 3), std::pair(0.6, 0.2), std::pair(0.2, 0.6), std::pair(0.2, 0.2)})
        {
          const Mesh::Halfedge_index h = mesh.halfedge(face);
          points.push_back(CGAL::barycenter(mesh.point(mesh.source(h)), u, mesh.point(mesh.target(h)), v,
                                            mesh.point(mesh.target(mesh.next(h))), 1 - u - v));
          feet.push_back(foot(f, points.back()));
          feet_of_vertices.push_back(foot(of_vertices, points.back()));
        }
      const double facets = rms_distance(points, whole), ratio = rms_distance(feet, whole) / facets,
                   ratio_of_vertices = rms_distance(feet_of_vertices, whole) / facets;
      std::cout << "reduced to " << mesh.number_of_vertices() << " vertices, " << f.diagnostics().number_of_replaced_vertices
                << " replaced: " << ratio << " of the distance of the facets, of vertices only " << ratio_of_vertices
                << std::endl;
      CHECK(ratio <= 1);
      CHECK(ratio_of_vertices >= 1.5);
      CHECK(f.diagnostics().number_of_replaced_vertices > 0.9 * double(mesh.number_of_vertices()));
      CHECK(of_vertices.diagnostics().number_of_replaced_vertices == 0);
    }
  // vertices of stretched and of rough meshes stay
  CHECK(Parallel_function(ellipsoid(3)).diagnostics().number_of_replaced_vertices == 0);
  CHECK(Parallel_function(rough_sphere()).diagnostics().number_of_replaced_vertices == 0);
}

// An edge of a cube is an edge, not a bend as wide as a facet: no normal says so, and the surface is nearer to both sides. That can
// be turned off, and normals of the caller are what he says.
void test_edges()
{
  const Mesh mesh = cube(6);
  const Parallel_function f(mesh), bent(mesh, params::detect_edges(false));
  const auto rms = [&](const auto& function)
  {
    double sum = 0;
    const std::vector<Point_3> points = points_of_faces(mesh);
    for (const Point_3& p : points)
      sum += function(p) * function(p) / double(points.size());
    return std::sqrt(sum);
  };
  std::cout << "cube: " << rms(f) << ", with bent edges " << rms(bent) << std::endl;
  CHECK(rms(f) < 0.7 * rms(bent));
  CHECK(f.diagnostics().number_of_points_on_edges == 12 * 5 + 8);
  CHECK(f.diagnostics().number_of_points_without_normal == 0);
  CHECK(f.diagnostics().patches_on_fallback == 0);
  CHECK(bent.diagnostics().number_of_points_on_edges == 0);
  Mesh with_normals = mesh;
  const auto normals = with_normals.add_property_map<Mesh::Vertex_index, Vector_3>("v:normal").first;
  for (const Mesh::Vertex_index v : mesh.vertices())
    normals[v] = bent.gradient(mesh.point(v));
  CHECK(Parallel_function(with_normals, params::vertex_normal_map(normals)).diagnostics().number_of_points_on_edges == 0);
  // the coarsest tube that is smooth, and the finest that is not
  CHECK(Parallel_function(open_cylinder(7, 4)).diagnostics().number_of_points_on_edges == 0);
  CHECK(Parallel_function(open_cylinder(6, 4)).diagnostics().number_of_points_on_edges > 0);
}

// the same for the regions of a piecewise function
void test_regions()
{
  const Mesh mesh = open_cylinder(32, 2);
  const CGAL::Piecewise_rbf_implicit_function<Kernel> f(mesh, CGAL::Constant_property_map<Mesh::Face_index, std::size_t>(0));
  CHECK(f.number_of_pieces() == 1);
  CHECK(largest_distance(f.piece(0), mesh) <= 2 * (1 - std::cos(pi / 32)));
}

int main()
{
  test_cylinders();
  test_number_of_points();
  test_bound();
  test_bound_of_animal();
  test_threads();
  test_even_meshes();
  test_stretched_triangles();
  test_adapted_meshes();
  test_edges();
  test_regions();
  return check_summary();
}
