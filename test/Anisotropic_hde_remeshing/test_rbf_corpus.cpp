// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Rbf_implicit_function on the meshes that come with CGAL: scans, CAD models, open, degenerate and self-intersecting ones.
// Whatever they are, it builds or refuses with a message, is finite, leads projections to the surface, and has the right sign.

#include "check.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_projection.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Random.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace shapes;

namespace internal = CGAL::Anisotropic_hde_remeshing::internal;

typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;

// a face as the checks need it
struct Face
{
  Point_3 corners[3];
  Point_3 centre;
  Vector_3 normal;        // of unit length, zero if the face is degenerate
  double edge_length = 0; // mean

  Face(const Mesh& mesh, const Mesh::Face_index f)
  {
    int k = 0;
    for (const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      corners[k++] = mesh.point(v);
    centre = CGAL::centroid(corners[0], corners[1], corners[2]);
    normal = CGAL::cross_product(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = std::sqrt(normal.squared_length());
    normal = length > 0 ? normal / length : Vector_3(0, 0, 0);
    for (k = 0; k < 3; ++k)
      edge_length += std::sqrt(CGAL::squared_distance(corners[k], corners[(k + 1) % 3])) / 3;
  }
};

// the faces of a mesh, and the closest of them to a point, without a sign
class Faces
{
public:
  explicit Faces(const Mesh& mesh)
  {
    for (const Mesh::Vertex_index v : mesh.vertices())
      m_points.push_back(internal::to_vector(mesh.point(v)));
    for (const Mesh::Face_index f : mesh.faces())
    {
      m_faces.emplace_back(mesh, f);
      const auto h = mesh.halfedge(f);
      m_facets.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
    }
  }

  std::size_t size() const { return m_faces.size(); }
  const Face& operator[](const std::size_t i) const { return m_faces[i]; }
  const std::vector<internal::Vector>& points() const { return m_points; }
  const std::vector<internal::Facet>& facets() const { return m_facets; }

  // the distance and the face
  std::pair<double, std::size_t> closest(const Point_3& p) const
  {
    const internal::Vector q = internal::to_vector(p);
    const internal::Closest_facet::Answer answer = m_closest_facet(q);
    return std::make_pair((answer.point - q).norm(), answer.facet);
  }

private:
  std::vector<internal::Vector> m_points;
  std::vector<internal::Facet> m_facets;
  std::vector<Face> m_faces;
  internal::Closest_facet m_closest_facet{m_points, m_facets};
};

// at most `n` numbers from 0 to `size`, evenly spread
std::vector<std::size_t> spread_indices(const std::size_t size, const std::size_t n)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < (std::min)(size, n); ++i)
    result.push_back(size <= n ? i : i * size / n);
  return result;
}

bool is_finite(const Function& f, const Point_3& p)
{
  const auto at_p = f.value_and_gradient(p);
  return std::isfinite(at_p.first) && std::isfinite(at_p.second.squared_length());
}

std::size_t number_of_values_not_finite(const Function& f, const Mesh& mesh, const Faces& faces)
{
  std::size_t result = 0;
  for (const std::size_t i : spread_indices(mesh.number_of_vertices(), 2000))
    result += is_finite(f, mesh.point(Mesh::Vertex_index(Mesh::size_type(i)))) ? 0 : 1;
  for (const std::size_t i : spread_indices(faces.size(), 2000))
    for (const double distance : {0., 0.3, -0.3, 3., -3., 1000.})
      result += is_finite(f, faces[i].centre + distance * faces[i].edge_length * faces[i].normal) ? 0 : 1;
  return result;
}

struct Projection_figures
{
  std::size_t number = 0, off_zero_set = 0, far_from_input = 0, by_closest_point = 0;
};

// projects the centres of faces as the remesher does, with a trust radius four times as large as its
Projection_figures project_centres(const Function& f, const Mesh& mesh, const Faces& faces)
{
  const double diagonal = bounding_box_diagonal(mesh);
  const internal::Input_surface input(faces.points(), faces.facets(), diagonal);
  const internal::Surface_projection<Function> projection(f, input);
  Projection_figures result;
  for (const std::size_t i : spread_indices(faces.size(), 2000))
  {
    internal::Vertex_state state;
    state.point = internal::to_vector(faces[i].centre);
    projection.project(state, 0, 2 * faces[i].edge_length);
    const Point_3 p(state.point[0], state.point[1], state.point[2]);
    const bool is_closest_point = projection.counters().closest_point > result.by_closest_point;
    ++result.number;
    result.by_closest_point += is_closest_point ? 1 : 0;
    result.off_zero_set += is_closest_point || std::abs(f(p)) <= 1e-8 * diagonal ? 0 : 1;
    result.far_from_input += faces.closest(p).first <= faces[i].edge_length ? 0 : 1;
  }
  return result;
}

// The share of wrong signs at random points that are h/4 to 2h from the surface, h the mean edge length of the closest face.
double share_of_wrong_signs(const Function& f, const Mesh& mesh, const Faces& faces, const std::size_t number)
{
  const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(mesh);
  const CGAL::Bounded_side negative =
      CGAL::Polygon_mesh_processing::is_outward_oriented(mesh) ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE;
  CGAL::Random random(23);
  std::size_t tested = 0, wrong = 0;
  while (tested < number)
  {
    const Face& face = faces[std::size_t(random.get_int(0, int(faces.size())))];
    const double u = std::sqrt(random.get_double()), v = random.get_double();
    const Point_3 q = CGAL::barycenter(face.corners[0], 1 - u, face.corners[1], u * (1 - v), face.corners[2], u * v);
    const Point_3 p = q + random.get_double(-2, 2) * face.edge_length * face.normal;
    const std::pair<double, std::size_t> closest = faces.closest(p);
    const double h = faces[closest.second].edge_length;
    if (closest.first < 0.25 * h || closest.first > 2 * h)
      continue;
    ++tested;
    wrong += (side(p) == negative) == (f(p) < 0) ? 0 : 1;
  }
  return double(wrong) / double(tested);
}

// the largest shares of wrong signs of meshes that are sampled as finely as their surface needs
const std::map<std::string, double> bounds_of_fine_meshes{
    {"armadillo", 1e-4}, {"bunny00", 1e-4}, {"camel", 2e-3}, {"elephant", 1e-4}};

// The others are parts of machines with few vertices and animals with thin sheets. A side of them is known where they bound a
// volume; the camel intersects itself at a few places.
void test_signs(const std::string& name, const Function& f, const Mesh& mesh, const Faces& faces)
{
  const auto bound = bounds_of_fine_meshes.find(name);
  const bool is_fine = bound != bounds_of_fine_meshes.end();
  CHECK(!is_fine || CGAL::is_closed(mesh));
  if (!CGAL::is_closed(mesh) || (!is_fine && (CGAL::Polygon_mesh_processing::does_self_intersect(mesh) ||
                                              !CGAL::Polygon_mesh_processing::does_bound_a_volume(mesh))))
    return;
  const double share = share_of_wrong_signs(f, mesh, faces, is_fine ? 40000 : 2000);
  std::cout << ", wrong signs " << share;
  CHECK(share <= (is_fine ? bound->second : 0.02));
}

void test_function(const std::string& name, const Function& f, const Mesh& mesh)
{
  const Faces faces(mesh);
  std::cout << name << ": patches " << f.diagnostics().number_of_patches << ", on fallback "
            << f.diagnostics().patches_on_fallback << ", repaired " << f.diagnostics().patches_repaired;
  CHECK(f.diagnostics().number_of_points - f.diagnostics().number_of_points_on_facets +
            f.diagnostics().number_of_duplicate_points + f.diagnostics().number_of_isolated_vertices ==
        mesh.number_of_vertices());
  CHECK(number_of_values_not_finite(f, mesh, faces) == 0);

  const Projection_figures figures = project_centres(f, mesh, faces);
  std::cout << "; of " << figures.number << " projections by closest point " << figures.by_closest_point << ", far from input "
            << figures.far_from_input << ", off the zero set " << figures.off_zero_set;
  CHECK(figures.far_from_input == 0);
  CHECK(100 * figures.by_closest_point <= 3 * figures.number);
  // where the input intersects itself, signs may change without a zero
  CHECK(figures.off_zero_set == 0 || CGAL::Polygon_mesh_processing::does_self_intersect(mesh));

  test_signs(name, f, mesh, faces);
  std::cout << std::endl;
}

void test_mesh(const std::string& name, const Mesh& mesh)
{
  std::unique_ptr<Function> f;
  const std::string message = invalid_argument_message([&] { f = std::make_unique<Function>(mesh); });
  if (f)
    return test_function(name, *f, mesh);
  std::cout << name << ": refused, " << message << std::endl;
  CHECK(!message.empty());
}

// oriented if need be; empty if it is no triangle mesh for this test
Mesh read_mesh(const std::filesystem::path& file, const std::size_t largest_number_of_vertices)
{
  Mesh mesh;
  if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file.string(), mesh) || !CGAL::is_triangle_mesh(mesh) ||
      mesh.number_of_vertices() > largest_number_of_vertices)
    mesh.clear();
  return mesh;
}

// test_rbf_corpus [LARGEST NUMBER OF VERTICES]: the few larger meshes take most of the time
int main(int argc, char* argv[])
{
  const std::size_t largest_number_of_vertices = argc > 1 ? std::stoul(argv[1]) : 8000;
  const std::filesystem::path folder = std::filesystem::path(CGAL::data_file_path("meshes/elephant.off")).parent_path();
  if (!CHECK(std::filesystem::exists(folder / "elephant.off")))
    return check_summary(); // not a pass, as nothing was tested
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".off")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::size_t number_of_meshes = 0;
  for (const std::filesystem::path& file : files)
  {
    const Mesh mesh = read_mesh(file, largest_number_of_vertices);
    if (mesh.number_of_faces() == 0)
      continue;
    ++number_of_meshes;
    test_mesh(file.stem().string(), mesh);
  }
  std::cout << number_of_meshes << " meshes of " << files.size() << " files" << std::endl;
  CHECK(2 * number_of_meshes > files.size());
  return check_summary();
}
