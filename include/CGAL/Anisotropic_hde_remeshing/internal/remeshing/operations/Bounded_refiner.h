// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_BOUNDED_REFINER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_BOUNDED_REFINER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Space_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Measured_contractions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Sampled_operations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sampled_ring.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Two_sided_check.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Brings faces that are too far from the input nearer: a corner is pulled to the place where the distance is largest, if that
// helps; or it is contracted away; or the face is split by a vertex there.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Bounded_refiner
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;
  typedef Measured_contractions<ConcurrencyTag, Mesh> Contractions;
  typedef typename Two_sided_check<ConcurrencyTag, Mesh>::Failing_face Failing_face;

  static constexpr double share_of_corner = 0.6, share_of_corner_to_split = 0.9; // of the barycentric coordinates
  static constexpr double smallest_ratio_of_edges = 0.5;      // of an edge that is split to the longest of its faces
  static constexpr double smallest_part_of_edge = 0.2;        // that a split leaves
  static constexpr double smallest_part_of_way = 0.03;        // by which a corner is pulled
  static constexpr double smallest_progress = 0.99;           // a pull makes the largest distance at least so much smaller
  static constexpr unsigned char largest_number_of_pulls = 4; // of a vertex, before it goes to the place
  static constexpr int rounds_of_pulls = 6; // after so many, what has been flipped and split since may let vertices go further
  static constexpr int first_rounds_to_contract = 8, round_to_contract = 3; // after these, one of so many

public:
  Bounded_refiner(const Mesh& mesh, const Input_surface& input, const Owners& owners, const Shape_price& price,
                  Sampled_operations<ConcurrencyTag, Mesh, Guard>& operations, Interruption& interruption)
    : m_mesh(mesh), m_input(input), m_owners(owners), m_price(price), m_operations(operations), m_interruption(interruption)
  {
  }

  // The farthest faces come first. Returns how many have been changed; the others are beside these, or nothing is accepted. To
  // begin with, corners are contracted, too. Later that would mostly undo what splits have done.
  std::size_t operator()(std::vector<Failing_face> faces, const int round)
  {
    std::stable_sort(faces.begin(), faces.end(),
                     [](const Failing_face& f, const Failing_face& g) { return f.distance > g.distance; });
    const Contractions measured(m_mesh, m_owners, m_price);
    for (const Failing_face& f : faces)
      m_places.push_back(f.place);
    if (round % rounds_of_pulls == rounds_of_pulls - 1)
      m_number_of_pulls.clear();
    m_number_of_pulls.resize(vertex_capacity(m_mesh), 0);
    m_operations.begin();
    std::size_t number = 0;
    for (const Failing_face& f : faces)
    {
      if (m_interruption.poll())
        break;
      if (!m_mesh.is_removed(f.face) && !m_operations.has_taken(f.face))
      {
        const bool is_pulled = pull(f), is_contracted = !is_pulled && may_contract(round) && contract(f, measured),
                   is_split = !is_pulled && !is_contracted && split(f);
        m_number_of_collapses += is_contracted;
        m_number_of_splits += is_split;
        number += is_pulled || is_contracted || is_split;
      }
    }
    return number;
  }

  // in all rounds
  std::size_t number_of_collapses() const { return m_number_of_collapses; }
  std::size_t number_of_splits() const { return m_number_of_splits; }

private:
  static bool may_contract(const int round) { return round < first_rounds_to_contract || round % round_to_contract == 0; }

  // Moves the corner that is nearest to the place by a part of the way from the face to the place.
  bool pull(const Failing_face& failing)
  {
    const Vertex_index v = near_corner(failing, share_of_corner);
    if (v == Mesh::null_vertex() || m_mesh.point(v).is_on_curve || m_mesh.point(v).is_fixed ||
        m_number_of_pulls[v] == 2 * largest_number_of_pulls)
      return false;
    const Vector from = m_mesh.point(v).point, way = failing.place - failing.point;
    const Vector to = m_number_of_pulls[v] < largest_number_of_pulls
                          ? place_of_least_distance(v, way, failing)
                          : nearest_allowed(v, m_number_of_pulls[v] % 2 == 0 ? m_input.closest(from).point : failing.place);
    if (to == from || !m_operations.take_ring(v))
      return false;
    m_operations.move(v, to);
    ++m_number_of_pulls[v];
    return true;
  }

  // by that part of the way for which the largest distance around the vertex is least
  Vector place_of_least_distance(const Vertex_index v, const Vector& way, const Failing_face& failing) const
  {
    const Local_distance distance(*this, v, failing);
    const Vector from = m_mesh.point(v).point;
    Vector to = from;
    double least = smallest_progress * smallest_progress * distance.largest_square_at(from);
    for (double part = 1; part >= smallest_part_of_way; part = part > 0.5 ? part - 0.25 : part / 2)
    {
      const Vector point = from + part * way;
      const double square = distance.largest_square_at(point);
      if (square < least && m_operations.accepts_move(v, point))
      {
        least = square;
        to = point;
      }
    }
    return to;
  }

  // as far to a place as a vertex may go
  Vector nearest_allowed(const Vertex_index v, const Vector& place) const
  {
    const Vector from = m_mesh.point(v).point;
    for (double part = 1; part >= smallest_part_of_way; part = part > 0.5 ? part - 0.25 : part / 2)
      if (m_operations.accepts_move(v, from + part * (place - from)))
        return from + part * (place - from);
    return from;
  }

  // The largest distance, both ways, around a vertex wherever it is: of the samples and the places that have failed before from the
  // faces, and of the nodes of these and the failing point from the facets of the input.
  class Local_distance
  {
  public:
    // Samples that are further than the largest distance that is known belong to other faces.
    Local_distance(const Bounded_refiner& refiner, const Vertex_index v, const Failing_face& failing)
      : m_refiner(refiner), m_ring(refiner.m_mesh, refiner.m_owners, refiner.m_price)
    {
      m_ring.add_vertex(v);
      const Vector from = refiner.m_mesh.point(v).point;
      const Vector barycentric = failing.triangle.closest(failing.point).barycentric;
      const std::array<Vector, 3> corners{failing.triangle.a, failing.triangle.b, failing.triangle.c};
      for (int k = 0; k < 3; ++k)
        if (corners[std::size_t(k)] == from)
          m_share = barycentric[k];
      m_rest = failing.point - m_share * from;
      const auto add = [&](const Vector& p)
      {
        if (m_ring.squared_distance_at(from, p) <= failing.distance * failing.distance)
          m_points.push_back(p);
      };
      for (const std::uint32_t i : m_ring.samples())
        add(refiner.m_owners.sample(i).point);
      for (const Vector& place : refiner.m_places)
        add(place);
    }

    double largest_square_at(const Vector& point) const
    {
      if (!m_ring.allows(point))
        return (std::numeric_limits<double>::infinity)();
      double largest = squared_distance_to_input(m_rest + m_share * point);
      for (const Vector& p : m_points)
        largest = (std::max)(largest, m_ring.squared_distance_at(point, p));
      m_ring.for_each_face(point,
                           [&](const Space_triangle& t)
                           {
                             for (std::size_t k = 0; k < Owners::number_of_nodes; ++k)
                               largest = (std::max)(largest, squared_distance_to_input(t.point(Owners::node(k).barycentric)));
                           });
      return largest;
    }

  private:
    double squared_distance_to_input(const Vector& q) const { return (m_refiner.m_input.closest(q).point - q).squaredNorm(); }

    const Bounded_refiner& m_refiner;
    Vector m_rest; // the failing point is this plus a share of the vertex
    double m_share = 0;
    Sampled_ring<ConcurrencyTag, Mesh> m_ring;
    std::vector<Vector> m_points;
  };

  // contracts the edge at the corner that is nearest to the place for which that lowers the cost most
  bool contract(const Failing_face& failing, const Contractions& measured)
  {
    const Vertex_index v = near_corner(failing, share_of_corner);
    if (v == Mesh::null_vertex())
      return false;
    std::vector<Edge_index> edges;
    for (const Halfedge_index in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (measured.is_candidate(m_mesh.edge(in)))
        edges.push_back(m_mesh.edge(in));
    std::vector<Measured_contraction> contractions =
        measured.measure(edges, 0, edges.size(), 0, (std::numeric_limits<double>::infinity)(), m_interruption);
    std::sort(contractions.begin(), contractions.end());
    for (const Measured_contraction& c : contractions)
      if (m_operations.accepts(c))
      {
        if (!m_operations.take_ring(c.halfedge))
          return false;
        m_operations.contract(c);
        return true;
      }
    return false;
  }

  // the corner at which the barycentric coordinates of the point have a share; none if it is further inside
  Vertex_index near_corner(const Failing_face& failing, const double share) const
  {
    const Vector barycentric = m_owners.triangle(failing.face).closest(failing.point).barycentric;
    Vector::Index corner;
    if (barycentric.maxCoeff(&corner) < share)
      return Mesh::null_vertex();
    const Triangle t(m_mesh.halfedge(failing.face), m_mesh);
    return corner == 0 ? t.a : corner == 1 ? t.b : t.c;
  }

  // Splits the edge that is nearest to the place, there if possible. At a corner the longest edge is split: with shorter edges the
  // corner can be pulled. A new vertex that must not move away from its edge may be pulled later.
  bool split(const Failing_face& failing)
  {
    const Vertex_index v = near_corner(failing, share_of_corner_to_split);
    for (const bool may_be_short : {false, true})
      for (const Halfedge_index h : v == Mesh::null_vertex() ? sides_by_distance(failing) : edges_by_length(v))
      {
        const Edge_index e = m_mesh.edge(h);
        if (m_mesh.is_border(e) || m_mesh.is_on_curve(e) || makes_needles(h, may_be_short))
          continue;
        const Vector on_edge = v == Mesh::null_vertex() ? near_point(h, failing.point) : middle(h, m_mesh),
                     on_input = m_input.closest(on_edge).point;
        for (const Vector& point : {v == Mesh::null_vertex() ? failing.place : on_input, on_input, on_edge})
          if (point == on_edge || m_operations.accepts_split(h, point)) // on the edge all faces stay as they are
          {
            if (!m_operations.take_quad(e))
              return false;
            m_operations.split(h, point);
            return true;
          }
      }
    return false;
  }

  // the point of an edge that is nearest to a point, but not too near to its ends
  Vector near_point(const Halfedge_index h, const Vector& p) const
  {
    const Vector &a = m_mesh.point(m_mesh.source(h)).point, &b = m_mesh.point(m_mesh.target(h)).point;
    const double squared_length = (b - a).squaredNorm();
    const double t = squared_length > 0 ? (p - a).dot(b - a) / squared_length : 0.5;
    return a + (std::min)((std::max)(t, smallest_part_of_edge), 1 - smallest_part_of_edge) * (b - a);
  }

  std::vector<Halfedge_index> sides_by_distance(const Failing_face& failing) const
  {
    const Vector barycentric = m_owners.triangle(failing.face).closest(failing.point).barycentric;
    const Halfedge_index h = m_mesh.halfedge(failing.face);
    return sorted({{barycentric[2], h}, {barycentric[0], m_mesh.next(h)}, {barycentric[1], m_mesh.prev(h)}});
  }

  std::vector<Halfedge_index> edges_by_length(const Vertex_index v) const
  {
    std::vector<std::pair<double, Halfedge_index>> edges;
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      edges.emplace_back(-squared_length(h, m_mesh), h);
    return sorted(std::move(edges));
  }

  static std::vector<Halfedge_index> sorted(std::vector<std::pair<double, Halfedge_index>> edges)
  {
    std::sort(edges.begin(), edges.end());
    std::vector<Halfedge_index> result;
    for (const auto& edge : edges)
      result.push_back(edge.second);
    return result;
  }

  // whether an edge is short beside the others of its faces; or if that may be, whether a split would make needles of these
  bool makes_needles(const Halfedge_index h, const bool may_be_short) const
  {
    const double limit = smallest_ratio_of_edges * smallest_ratio_of_edges;
    for (const Halfedge_index g : {h, m_mesh.opposite(h)})
      for (const Halfedge_index side : {m_mesh.next(g), m_mesh.prev(g)})
        if (squared_length(h, m_mesh) < limit * squared_length(side, m_mesh) &&
            (!may_be_short || 2 * m_owners.triangle(m_mesh.face(g)).ratio() > m_price.largest_ratio()))
          return true;
    return false;
  }

  const Mesh& m_mesh;
  const Input_surface& m_input;
  const Owners& m_owners;
  const Shape_price& m_price;
  Sampled_operations<ConcurrencyTag, Mesh, Guard>& m_operations;
  Interruption& m_interruption;
  std::vector<Vector> m_places;                 // on the input that have failed
  std::vector<unsigned char> m_number_of_pulls; // by vertex
  std::size_t m_number_of_collapses = 0, m_number_of_splits = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_BOUNDED_REFINER_H
