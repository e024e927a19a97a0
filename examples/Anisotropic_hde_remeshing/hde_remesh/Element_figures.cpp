// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Element_figures.h"
#include "measure.h"

#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Zero_set_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

typedef CGAL::Parallel_if_available_tag Tag;

Hde::internal::Vector to_vector(const Point_3& p) { return Hde::internal::Vector(p.x(), p.y(), p.z()); }

// the least angle of a triangle with sides of these squared lengths, opposite to the shortest one
double smallest_angle(std::array<double, 3> squared_lengths)
{
  std::sort(squared_lengths.begin(), squared_lengths.end());
  const auto [a, b, c] = squared_lengths;
  if (!(a > 0))
    return 0;
  const double cosine = (b + c - a) / (2 * std::sqrt(b) * std::sqrt(c));
  return std::acos((std::max)(-1., (std::min)(1., cosine))) * 180 / CGAL_PI;
}

// The zero set of a function. A face sees its vertices with the piece of its region.
class Zero_set
{
public:
  Zero_set(const Mesh& mesh, const Function_view& function)
    : m_mesh(mesh), m_function(function), m_region(creases_of(mesh).region), m_size(diagonal(mesh))
  {
  }

  // a vertex on a crease has one value only here: that of one of its regions
  double distance(const Mesh::Vertex_index v) const { return distance(piece(m_mesh.halfedge(v)), m_mesh.point(v)); }

  double distance(const Mesh::Halfedge_index h, const Point_3& centroid) const
  {
    const Function_view::Piece& function = piece(h);
    const Point_3& v = m_mesh.point(m_mesh.target(h));
    return Hde::internal::zero_set_distance(function, m_size)(to_vector(centroid), to_vector(v), distance(function, v));
  }

  // whether the face of h sees the same normal at v as v has itself
  bool is_normal_of_vertex(const Mesh::Halfedge_index h, const Mesh::Vertex_index v) const
  {
    return &piece(h) == &piece(m_mesh.halfedge(v));
  }

  Vector_3 normal(const Mesh::Halfedge_index h, const Mesh::Vertex_index v) const
  {
    const Vector_3 gradient = piece(h).gradient(m_mesh.point(v));
    const double slope = std::sqrt(gradient.squared_length());
    return slope > 0 ? gradient / slope : Vector_3(0, 0, 0);
  }

private:
  // of the face of h, or of that beyond it on the boundary
  const Function_view::Piece& piece(const Mesh::Halfedge_index h) const
  {
    return m_function.piece(m_region[m_mesh.face(m_mesh.is_border(h) ? m_mesh.opposite(h) : h)]);
  }

  double distance(const Function_view::Piece& function, const Point_3& p) const
  {
    return Hde::internal::zero_set_distance(function, m_size)(to_vector(p));
  }

  const Mesh& m_mesh;
  const Function_view& m_function;
  Mesh::Property_map<Mesh::Face_index, std::size_t> m_region;
  double m_size;
};

// The facets of the other mesh. The normals are those of the mesh itself.
class Facets
{
public:
  Facets(const Mesh& mesh, const Mesh& other) : m_mesh(mesh), m_distance(other, CGAL::parameters::default_values()) {}

  double distance(const Mesh::Vertex_index v) const { return m_distance(to_vector(m_mesh.point(v))); }
  double distance(const Mesh::Halfedge_index, const Point_3& centroid) const { return m_distance(to_vector(centroid)); }
  bool is_normal_of_vertex(const Mesh::Halfedge_index, const Mesh::Vertex_index) const { return true; }
  Vector_3 normal(const Mesh::Halfedge_index, const Mesh::Vertex_index v) const
  {
    return CGAL::Polygon_mesh_processing::compute_vertex_normal(v, m_mesh);
  }

private:
  const Mesh& m_mesh;
  Hde::internal::Distance_to_mesh<Mesh, CGAL::parameters::Default_named_parameters> m_distance;
};

// the steps of `figures_of_elements()`
template <typename Surface>
class Element_measurement
{
public:
  Element_measurement(const Mesh& mesh, const Surface& surface, const double sigma)
    : m_mesh(mesh), m_surface(surface), m_sigma(sigma)
  {
  }

  Element_figures measure()
  {
    measure_vertices();
    measure_edges();
    measure_faces();
    return std::move(m_figures);
  }

private:
  void measure_vertices()
  {
    const std::vector<Mesh::Vertex_index> vertices(m_mesh.vertices().begin(), m_mesh.vertices().end());
    m_numbers.resize(m_mesh.num_vertices()); // removed ones included
    m_figures.normals.resize(vertices.size());
    m_figures.vertex_distances.resize(vertices.size());
    Hde::internal::parallel_for<Tag>(vertices.size(),
                                     [&](const std::size_t i)
                                     {
                                       const Mesh::Vertex_index v = vertices[i];
                                       m_numbers[v] = i;
                                       m_figures.normals[i] = m_surface.normal(m_mesh.halfedge(v), v);
                                       m_figures.vertex_distances[i] = m_surface.distance(v);
                                     });
  }

  Vector_3 normal(const Mesh::Halfedge_index h, const Mesh::Vertex_index v) const
  {
    return m_surface.is_normal_of_vertex(h, v) ? m_figures.normals[m_numbers[v]] : m_surface.normal(h, v);
  }

  // with the normals that the face of h sees
  double squared_length(const Mesh::Halfedge_index h) const
  {
    const Mesh::Vertex_index a = m_mesh.source(h), b = m_mesh.target(h);
    const double in_space = CGAL::squared_distance(m_mesh.point(a), m_mesh.point(b));
    return m_sigma > 0 ? in_space + m_sigma * m_sigma * (normal(h, a) - normal(h, b)).squared_length() : in_space;
  }

  void measure_edges()
  {
    const std::vector<Mesh::Edge_index> edges(m_mesh.edges().begin(), m_mesh.edges().end());
    m_figures.edge_lengths.resize(edges.size());
    Hde::internal::parallel_for<Tag>(edges.size(),
                                     [&](const std::size_t i)
                                     {
                                       const Mesh::Halfedge_index h = m_mesh.halfedge(edges[i]);
                                       m_figures.edge_lengths[i] =
                                           std::sqrt((std::max)(squared_length(h), squared_length(m_mesh.opposite(h))));
                                     });
  }

  void measure_faces()
  {
    const std::vector<Mesh::Face_index> faces(m_mesh.faces().begin(), m_mesh.faces().end());
    for (std::vector<double>* values : {&m_figures.aspect_ratios, &m_figures.smallest_angles, &m_figures.face_distances})
      values->resize(faces.size());
    Hde::internal::parallel_for<Tag>(
        faces.size(),
        [&](const std::size_t i)
        {
          const Mesh::Halfedge_index h = m_mesh.halfedge(faces[i]), g = m_mesh.next(h), k = m_mesh.next(g);
          const Point_3 &a = m_mesh.point(m_mesh.target(h)), &b = m_mesh.point(m_mesh.target(g)),
                        &c = m_mesh.point(m_mesh.target(k));
          m_figures.aspect_ratios[i] = Hde::aspect_ratio(a, b, c);
          m_figures.smallest_angles[i] = smallest_angle({squared_length(h), squared_length(g), squared_length(k)});
          m_figures.face_distances[i] = m_surface.distance(h, CGAL::centroid(a, b, c));
        });
  }

  const Mesh& m_mesh;
  const Surface& m_surface;
  double m_sigma;
  std::vector<std::size_t> m_numbers; // of the vertices
  Element_figures m_figures;
};

} // namespace

Element_figures figures_of_elements(const Mesh& mesh, const Function_view& function, const double sigma, const Mesh& other)
{
  if (function.has_values())
    return Element_measurement(mesh, Zero_set(mesh, function), sigma).measure();
  Element_figures figures = Element_measurement(mesh, Facets(mesh, other), 0).measure();
  figures.is_by_function = false;
  return figures;
}

void add_arrays(const Element_figures& figures, Soup& soup)
{
  Array x{"nx", {}}, y{"ny", {}}, z{"nz", {}};
  for (const Vector_3& normal : figures.normals)
  {
    x.values.push_back(normal.x());
    y.values.push_back(normal.y());
    z.values.push_back(normal.z());
  }
  soup.vertex_arrays = {x, y, z, {"distance", figures.vertex_distances}};
  soup.face_arrays = {{"aspect_ratio", figures.aspect_ratios},
                      {figures.is_by_function ? "smallest_angle_6d" : "smallest_angle", figures.smallest_angles},
                      {"distance", figures.face_distances}};
}

} // namespace hde_remesh
