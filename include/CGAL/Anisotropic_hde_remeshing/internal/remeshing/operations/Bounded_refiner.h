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

  static constexpr double smallest_share_of_corner = 0.6; // of the barycentric coordinates, so that it is pulled
  static constexpr double smallest_ratio_of_edges = 0.5;  // of an edge that is split to the longest of its faces
  static constexpr int last_round_to_contract = 8;

public:
  Bounded_refiner(const Mesh& mesh, const Input_surface& input, const Owners& owners, const Shape_price& price,
                  Sampled_operations<ConcurrencyTag, Mesh, Guard>& operations, Interruption& interruption)
    : m_mesh(mesh), m_input(input), m_owners(owners), m_price(price), m_operations(operations), m_interruption(interruption)
  {
  }

  // The farthest faces come first. Returns how many have been changed; the others are beside these, or nothing is accepted. To
  // begin with, corners are contracted, too. Later that would undo what splits have done.
  std::size_t operator()(std::vector<Failing_face> faces, const int round)
  {
    std::stable_sort(faces.begin(), faces.end(),
                     [](const Failing_face& f, const Failing_face& g) { return f.distance > g.distance; });
    const Contractions measured(m_mesh, m_owners, m_price);
    m_operations.begin();
    std::size_t number = 0;
    for (const Failing_face& f : faces)
    {
      if (m_interruption.poll())
        break;
      if (!m_mesh.is_removed(f.face) && !m_operations.has_taken(f.face))
      {
        const bool is_pulled = pull(f), is_contracted = !is_pulled && round < last_round_to_contract && contract(f, measured),
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
  // moves the corner that is nearest to the place by the way from the face to the place, or a part of it
  bool pull(const Failing_face& failing)
  {
    const Vertex_index v = near_corner(failing);
    if (v == Mesh::null_vertex() || m_mesh.point(v).is_on_curve || m_mesh.point(v).is_fixed)
      return false;
    Sampled_ring<ConcurrencyTag, Mesh> ring(m_mesh, m_owners, m_price);
    ring.add_vertex(v);
    const Vector from = m_mesh.point(v).point, way = failing.place - failing.point;
    double least = ring.cost();
    Vector best = from;
    for (const double part : {1., 0.75, 0.5, 0.25})
    {
      const double cost = ring.cost_at(from + part * way, least, (std::numeric_limits<double>::infinity)());
      if (cost < least && m_operations.accepts_move(v, from + part * way))
      {
        least = cost;
        best = from + part * way;
      }
    }
    if (best == from || !m_operations.take_ring(v))
      return false;
    m_operations.move(v, best);
    return true;
  }

  // contracts the edge at the corner that is nearest to the place for which that lowers the cost most
  bool contract(const Failing_face& failing, const Contractions& measured)
  {
    const Vertex_index v = near_corner(failing);
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

  Vertex_index near_corner(const Failing_face& failing) const
  {
    const Vector barycentric = m_owners.triangle(failing.face).closest(failing.point).barycentric;
    Vector::Index corner;
    if (barycentric.maxCoeff(&corner) < smallest_share_of_corner)
      return Mesh::null_vertex();
    const Triangle t(m_mesh.halfedge(failing.face), m_mesh);
    return corner == 0 ? t.a : corner == 1 ? t.b : t.c;
  }

  // Splits the edge that is nearest to the place, there if possible. Where that is a corner, the longest edge at it is split: with
  // shorter edges the corner can be pulled. A new vertex that must not move away from its edge may be pulled later.
  bool split(const Failing_face& failing)
  {
    const Vertex_index v = near_corner(failing);
    for (const Halfedge_index h : v == Mesh::null_vertex() ? sides_by_distance(failing) : edges_by_length(v))
    {
      const Edge_index e = m_mesh.edge(h);
      if (m_mesh.is_border(e) || m_mesh.is_on_curve(e) || is_short(h))
        continue;
      const Vector middle = internal::middle(h, m_mesh), on_input = m_input.closest(middle).point;
      for (const Vector& point : {v == Mesh::null_vertex() ? failing.place : on_input, on_input, middle})
        if (m_operations.accepts_split(h, point))
        {
          if (!m_operations.take_quad(e))
            return false;
          m_operations.split(h, point);
          return true;
        }
    }
    return false;
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

  // whether a split would make a needle
  bool is_short(const Halfedge_index h) const
  {
    const double limit = smallest_ratio_of_edges * smallest_ratio_of_edges;
    for (const Halfedge_index g : {h, m_mesh.opposite(h)})
      for (const Halfedge_index side : {m_mesh.next(g), m_mesh.prev(g)})
        if (squared_length(h, m_mesh) < limit * squared_length(side, m_mesh))
          return true;
    return false;
  }

  const Mesh& m_mesh;
  const Input_surface& m_input;
  const Owners& m_owners;
  const Shape_price& m_price;
  Sampled_operations<ConcurrencyTag, Mesh, Guard>& m_operations;
  Interruption& m_interruption;
  std::size_t m_number_of_collapses = 0, m_number_of_splits = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_BOUNDED_REFINER_H
