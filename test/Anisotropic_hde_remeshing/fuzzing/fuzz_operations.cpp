// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Random sequences of local operations on small meshes of bad geometry, closed and with boundary: after each, the mesh must be
// valid, of the same topology, finite, with no more folded edges and no new self-intersection. For libFuzzer.

#include "../shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Operation_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Mesh_reorderer.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_collapser.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_flipper.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_splitter.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Vertex_smoother.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_projection.h>

#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace {

namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
using internal::Vector;
typedef CGAL::Anisotropic_hde_remeshing::Normal_embedding Embedding;
typedef internal::Working_mesh<Embedding::Vertex_data> Mesh;
typedef CGAL::Sequential_tag Tag;

constexpr std::size_t largest_number_of_faces = 1500;
constexpr double expected_height = 0.1; // of edges; the meshes are of size 1 about
constexpr int largest_number_of_operations = 20;

// the bytes of the fuzzer, then zeros
class Input
{
public:
  Input(const std::uint8_t* data, const std::size_t size) : m_data(data), m_end(data + size) {}

  bool empty() const { return m_data == m_end; }
  unsigned byte() { return empty() ? 0 : *m_data++; }
  double from(const double low, const double high) { return low + (high - low) * byte() / 255; }

private:
  const std::uint8_t *m_data, *m_end;
};

// a sphere, or two planes: with gradients that jump between them
struct Surface : shapes::Sphere_function
{
  bool is_sphere = true;

  FT operator()(const Point_3& p) const { return is_sphere ? shapes::Sphere_function::operator()(p) : std::abs(p.z()) - 0.05; }
  Vector_3 gradient(const Point_3& p) const
  {
    return is_sphere ? shapes::Sphere_function::gradient(p) : Vector_3(0, 0, p.z() < 0 ? -1 : 1);
  }
};

shapes::Soup soup(Input& input, Surface& surface)
{
  const unsigned kind = input.byte() % 3;
  shapes::Soup soup = kind == 1 ? shapes::half_sphere_soup(3) : shapes::icosphere_soup(1);
  surface.is_sphere = kind != 2;
  const double noise = input.from(0, 0.5), thickness = surface.is_sphere ? 1 : 0.05;
  for (shapes::Point_3& p : soup.points)
  {
    const double x = noise * input.from(-1, 1), y = noise * input.from(-1, 1), z = noise * input.from(-1, 1);
    p = shapes::Point_3(p.x() + x, p.y() + y, thickness * (p.z() + z));
  }
  return soup;
}

class Session
{
  typedef internal::Surface_projection<Surface> Projection;
  typedef internal::Mesh_intersections<Mesh> Intersections;
  typedef internal::Operation_guard<Mesh, Surface> Guard;

public:
  Session(const shapes::Soup& soup, const Surface& surface, const double sigma)
    : m_embedding(sigma), m_input(points(soup), soup.triangles, 1.), m_projection(surface, m_input)
  {
    load(soup);
    m_guard.update_all<Tag>();
    m_guard.keep_landmarks(
        internal::Expected_heights{expected_height, std::vector<double>(internal::vertex_capacity(m_mesh), expected_height)},
        1);
    m_euler_characteristic = euler_characteristic();
    m_number_of_borders = number_of_borders();
    m_number_of_folds = number_of_folds();
    m_has_intersections = intersects_itself();
  }

  void operate(Input& input)
  {
    static const internal::Flip_criterion criteria[] = {internal::Flip_criterion::VALENCE, internal::Flip_criterion::ANGLE};
    const unsigned operation = input.byte() % 8;
    const double length = input.from(0.01, 2);
    switch (operation)
    {
    case 0:
      m_split(length, largest_number_of_faces / 4);
      break;
    case 1:
      m_split(std::vector<internal::Edge_index>{edge(input)});
      break;
    case 2:
      m_collapse(length, length * input.from(0.5, 4));
      break;
    case 3:
      m_collapse(length, 10, 1);
      break;
    case 4:
    case 5:
      m_flip(criteria[operation - 4]);
      break;
    case 6:
      m_smooth(input.from(0, 1), input.byte() % 2 == 0 ? internal::Smoothing_step::PREDICT : internal::Smoothing_step::PROJECT);
      break;
    default:
      m_guard.renumber_landmarks(internal::reorder_in_space<Tag>(m_mesh, m_never));
      m_guard.update_all<Tag>();
    }
    check(operation);
  }

  bool is_full() const { return m_mesh.number_of_faces() > largest_number_of_faces; }

private:
  static std::vector<Vector> points(const shapes::Soup& soup)
  {
    std::vector<Vector> result;
    for (const shapes::Point_3& p : soup.points)
      result.emplace_back(p.x(), p.y(), p.z());
    return result;
  }

  void load(const shapes::Soup& soup)
  {
    for (const Vector& p : points(soup))
    {
      Mesh::Vertex state;
      state.point = p;
      m_projection.update_normal(state, 0);
      m_mesh.add_vertex(state);
    }
    for (const auto& t : soup.triangles)
      m_mesh.add_face(internal::Vertex_index(unsigned(t[0])), internal::Vertex_index(unsigned(t[1])),
                      internal::Vertex_index(unsigned(t[2])));
    for (const internal::Halfedge_index h : m_mesh.halfedges())
      if (m_mesh.is_border(h))
        m_mesh.set_arc(m_mesh.opposite(h), internal::Curve_arc{internal::Curve_arc::unnamed, 0, 0});
    m_curves = internal::Curve_network(m_mesh);
  }

  internal::Edge_index edge(Input& input) const
  {
    const std::vector<internal::Edge_index> edges(m_mesh.edges().begin(), m_mesh.edges().end());
    const std::size_t i = 256 * input.byte() + input.byte();
    return edges[i % edges.size()];
  }

  long euler_characteristic() const
  {
    return long(m_mesh.number_of_vertices()) - long(m_mesh.number_of_edges()) + long(m_mesh.number_of_faces());
  }

  std::size_t number_of_borders() const
  {
    std::vector<char> is_visited(2 * internal::edge_capacity(m_mesh), 0);
    std::size_t number = 0;
    for (const internal::Halfedge_index start : m_mesh.halfedges())
      if (m_mesh.is_border(start) && !is_visited[start])
      {
        ++number;
        for (internal::Halfedge_index h = start; !is_visited[h]; h = m_mesh.next(h))
          is_visited[h] = 1;
      }
    return number;
  }

  std::size_t number_of_folds() const
  {
    std::size_t number = 0;
    for (const internal::Edge_index e : m_mesh.edges())
    {
      const internal::Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
      if (!m_mesh.is_border(h) && !m_mesh.is_border(g))
        number += internal::is_folded_edge(internal::face_normal(h, m_mesh), internal::face_normal(g, m_mesh));
    }
    return number;
  }

  // all pairs, without the tree that the operations have kept
  bool intersects_itself() const
  {
    std::vector<internal::Indexed_triangle> triangles;
    for (const internal::Face_index f : m_mesh.faces())
    {
      const internal::Triangle t(m_mesh.halfedge(f), m_mesh);
      triangles.emplace_back();
      std::size_t k = 0;
      for (const internal::Vertex_index v : {t.a, t.b, t.c})
      {
        triangles.back().vertices[k] = v;
        triangles.back().points[k++] = m_mesh.point(v).point;
      }
      for (std::size_t i = 0; i + 1 < triangles.size(); ++i)
        if (internal::do_triangles_intersect(triangles[i], triangles.back()))
          return true;
    }
    return false;
  }

  static void require(const bool condition, const char* what, const unsigned operation)
  {
    if (condition)
      return;
    std::cerr << "after operation " << operation << ": " << what << std::endl;
    std::abort();
  }

  void check(const unsigned operation) const
  {
    require(CGAL::is_valid_polygon_mesh(m_mesh.graph()), "the mesh is not valid", operation);
    require(CGAL::is_triangle_mesh(m_mesh.graph()), "not all faces are triangles", operation);
    require(euler_characteristic() == m_euler_characteristic, "the Euler characteristic has changed", operation);
    require(number_of_borders() == m_number_of_borders, "the number of boundaries has changed", operation);
    for (const internal::Vertex_index v : m_mesh.vertices())
      require(m_mesh.point(v).point.allFinite() && m_mesh.point(v).normal.allFinite(), "a vertex is not finite", operation);
    require(number_of_folds() <= m_number_of_folds, "there are more folded edges", operation);
    require(m_has_intersections || !intersects_itself(), "the mesh intersects itself", operation);
  }

  internal::Interruption m_never;
  Mesh m_mesh;
  const Embedding m_embedding;
  const internal::Input_surface m_input;
  const Projection m_projection;
  internal::Curve_network m_curves{m_mesh};
  Intersections m_intersections{m_mesh, internal::Obstacles(), true};
  Guard m_guard{m_mesh, m_projection.function(), m_intersections};
  const internal::Edge_splitter<Tag, Embedding, Projection, Guard> m_split{m_mesh,   m_embedding, m_projection,
                                                                           m_curves, m_guard,     m_never};
  const internal::Edge_collapser<Tag, Embedding, Guard> m_collapse{m_mesh, m_embedding, m_curves, m_guard, m_never};
  const internal::Edge_flipper<Tag, Embedding, Guard> m_flip{m_mesh, m_embedding, m_guard, m_never};
  internal::Vertex_smoother<Tag, Embedding, Projection, Guard> m_smooth{m_mesh,   m_embedding, m_projection,
                                                                        m_curves, m_guard,     m_never};
  long m_euler_characteristic = 0;
  std::size_t m_number_of_borders = 0, m_number_of_folds = 0;
  bool m_has_intersections = false;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  Input input(data, size);
  Surface surface;
  const double sigma = input.from(0, 2);
  const shapes::Soup start = soup(input, surface);
  Session session(start, surface, sigma);
  for (int i = 0; i < largest_number_of_operations && !input.empty() && !session.is_full(); ++i)
    session.operate(input);
  return 0;
}
