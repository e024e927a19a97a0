// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_VERTEX_SMOOTHER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_VERTEX_SMOOTHER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Tangent_frame.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_placement.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Simultaneous_moves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Shape_operator_estimate.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/embedded_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_projection.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

enum class Smoothing_step
{
  PREDICT, // small steps are not projected; the next smoothing makes up for that
  PROJECT
};

// Moves every vertex towards the centroid of its surroundings in the embedding. The weights are the areas of its faces there.
// All vertices move at once, so that the result does not depend on their order. Then the moves that the guard refuses are taken
// back.
template <typename ConcurrencyTag, typename Embedding, typename Projection, typename Guard>
class Vertex_smoother
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  typedef typename Mesh::Vertex Vertex;
  typedef typename Embedding::template Centroid<Vertex> Centroid;

  static constexpr double relaxation = 0.6;
  static constexpr double largest_step = 0.5; // in 3D, of the distance to the nearest neighbour
  static constexpr int number_of_attempts = 3;
  static constexpr double negligible_step = 1e-3; // of the same distance: a vertex that would move less stays
  // Of the same distance, and of the turn of the normal in radians. For shorter steps the curvature at hand tells where a step
  // leads.
  static constexpr double largest_predicted_step = 0.1;

public:
  Vertex_smoother(Mesh& mesh, const Embedding& embedding, const Projection& projection, const Curve_network& curves,
                  const Guard& guard, Interruption& interruption)
    : m_mesh(mesh),
      m_embedding(embedding),
      m_projection(projection),
      m_curves(curves),
      m_placement(embedding, projection, curves),
      m_guard(guard),
      m_interruption(interruption),
      m_moves(mesh)
  {
  }

  // One simultaneous step of the share `ratio` of the vertices, those with the smallest angles in the embedding. If another
  // smoothing follows at once, small steps are not projected (PREDICT, then PROJECT): the mesh is as good, and an evaluation
  // costs more.
  void operator()(const double ratio, const Smoothing_step kind)
  {
    m_moves.clear();
    std::vector<double> shifts(vertex_capacity(m_mesh), 0.);
    const std::vector<char> is_chosen = choose(ratio);
    m_moves.template propose<ConcurrencyTag>(
        [&](const Vertex_index v)
        { return (is_chosen.empty() || is_chosen[v] || is_due(v, kind)) && is_movable(m_mesh.point(v)); },
        [&](const Vertex_index v, Vertex& state, typename Mesh::Sides& sides)
        { return state.is_on_curve ? slide(v, state, sides, shifts[v]) : move(v, state, kind); },
        m_interruption);
    if (m_curves.bounds_deviation())
      m_moves.template revert_edges<ConcurrencyTag>(
          [&](const Edge_index e) { return m_mesh.is_on_curve(e) && !m_curves.accepts(moved_arc(e, shifts)); }, m_interruption);
    m_guard.template revert_losses<ConcurrencyTag>(m_moves, m_interruption);
    m_guard.template revert<ConcurrencyTag>(m_moves, m_interruption);
    if (m_interruption.ask())
      return; // not all vertices have been moved, or checked
    m_moves.template accept<ConcurrencyTag>(m_mesh);
    m_guard.template update_landmarks<ConcurrencyTag>();
    for (const Vertex_index v : m_mesh.vertices())
      if (m_moves.is_moved(v) && m_mesh.point(v).is_on_curve)
        shift_arcs(v, shifts[v]);
  }

private:
  bool is_movable(const Vertex& v) const { return !v.is_fixed && (!v.is_on_curve || m_curves.may_smooth()); }

  // whether the vertex is to be projected even if it would not move
  bool is_due(const Vertex_index v, const Smoothing_step kind) const
  {
    return kind == Smoothing_step::PROJECT && m_mesh.point(v).is_predicted();
  }

  // which vertices move; empty if all do
  std::vector<char> choose(const double ratio) const
  {
    std::vector<char> is_chosen;
    if (ratio >= 1)
      return is_chosen;
    std::vector<std::pair<double, Vertex_index>> vertices;
    for (const Vertex_index v : m_mesh.vertices())
      vertices.emplace_back(-largest_cosine_around(v), v);
    const std::size_t count = std::size_t(std::ceil(ratio * double(vertices.size())));
    std::nth_element(vertices.begin(), vertices.begin() + std::ptrdiff_t((std::min)(count, vertices.size() - 1)),
                     vertices.end());
    is_chosen.assign(vertex_capacity(m_mesh), 0);
    for (std::size_t i = 0; i < (std::min)(count, vertices.size()); ++i)
      is_chosen[vertices[i].second] = 1;
    return is_chosen;
  }

  double largest_cosine_around(const Vertex_index v) const
  {
    double largest = -1;
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      if (m_mesh.is_border(h))
        continue;
      const Corners<Mesh> t(h, m_mesh);
      largest = (std::max)(largest, Embedded_triangle::largest_cosine(m_embedding.squared_length(t.a, t.b),
                                                                      m_embedding.squared_length(t.b, t.c),
                                                                      m_embedding.squared_length(t.c, t.a)));
    }
    return largest;
  }

  // The arc of an edge on a curve, with both ends where they will be. `slide()` tests each end with the other one at rest.
  Curve_arc moved_arc(const Edge_index e, const std::vector<double>& shifts) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    const Vertex_index u = m_mesh.source(h), v = m_mesh.target(h);
    Curve_arc arc = m_mesh.arc(h);
    arc.source += m_moves.is_moved(u) ? shifts[u] : 0;
    arc.target += m_moves.is_moved(v) ? shifts[v] : 0;
    return arc;
  }

  void shift_arcs(const Vertex_index v, const double shift) const
  {
    const Halfedge_index in = curve_halfedge(v), out = Curve_network::next_on_curve(in, m_mesh);
    Curve_arc before = m_mesh.arc(in), behind = m_mesh.arc(out);
    before.target += shift;
    behind.source += shift;
    m_mesh.set_arc(in, before);
    m_mesh.set_arc(out, behind);
  }

  // a halfedge on the curve that ends at the vertex
  Halfedge_index curve_halfedge(const Vertex_index v) const
  {
    Halfedge_index in = m_mesh.halfedge(v);
    while (!m_mesh.is_on_curve(m_mesh.edge(in)))
      in = m_mesh.prev(m_mesh.opposite(in));
    return in;
  }

  // Moves a vertex along its curve, towards where its two edges on the curve have the same length in the embedding. `shift` is
  // positive in the direction of the halfedge that `curve_halfedge()` finds.
  bool slide(const Vertex_index v, Vertex& state, typename Mesh::Sides& sides, double& shift) const
  {
    const Halfedge_index in = curve_halfedge(v), out = Curve_network::next_on_curve(in, m_mesh);
    const double length_before = std::sqrt(squared_length(m_mesh.edge(in), m_mesh, m_embedding)),
                 length_behind = std::sqrt(squared_length(m_mesh.edge(out), m_mesh, m_embedding));
    const double share = (length_behind - length_before) / (length_behind + length_before);
    if (!(std::abs(share) > negligible_step))
      return false;
    const Curve_arc before = m_mesh.arc(in), behind = m_mesh.arc(out);
    const double way = share > 0 ? behind.target - behind.source : before.target - before.source;
    shift = 0.5 * relaxation * share * way;
    if (!m_curves.accepts(Curve_arc{before.curve, before.source, before.target + shift}) ||
        !m_curves.accepts(Curve_arc{before.curve, before.target + shift, before.target + (behind.target - behind.source)}))
      return false;
    state.point = m_placement.point(before.curve, before.target + shift, m_mesh.region(in), sides);
    m_placement.update(state, m_mesh.region(in), sides);
    return true;
  }

  bool move(const Vertex_index v, Vertex& state, const Smoothing_step kind) const
  {
    const Tangent_frame frame = tangent_frame(state.normal);
    Surroundings around(Centroid(m_embedding, state, frame));
    if (!gather(v, state, frame, around))
      return false;
    const Eigen::Matrix2d shape_operator = around.shape_operator();
    Eigen::Vector2d step = relaxation * around.centroid.tangential_step(shape_operator);
    const double length = step.norm(), radius = std::sqrt(around.squared_radius);
    if (!(length > negligible_step * radius || (is_due(v, kind) && std::isfinite(length))))
      return false;
    if (length > largest_step * radius)
      step *= largest_step * radius / length;
    if (kind == Smoothing_step::PREDICT && predict(step, frame, shape_operator, radius, state))
      return true;
    // Where the surface bends too much for the step, a shorter step may lead to the surface. A vertex stays if no step does.
    for (int attempt = 0; attempt < number_of_attempts; ++attempt, step *= 0.5)
    {
      Vertex moved = state;
      moved.point += on_paraboloid(step, frame, shape_operator, state.normal);
      if (!m_projection.find_roughly(moved, m_mesh.region(m_mesh.halfedge(v)), radius, 0.02 * radius))
        continue;
      m_embedding.place(moved);
      state = moved;
      return true;
    }
    return false;
  }

  // up to terms of third order the surface is its osculating paraboloid
  static Vector on_paraboloid(const Eigen::Vector2d& step, const Tangent_frame& frame, const Eigen::Matrix2d& shape_operator,
                              const Vector& normal)
  {
    return frame * step - 0.5 * step.dot(shape_operator * step) * normal;
  }

  bool predict(const Eigen::Vector2d& step, const Tangent_frame& frame, const Eigen::Matrix2d& shape_operator,
               const double radius, Vertex& state) const
  {
    const Eigen::Vector2d turn = shape_operator * step;
    if (!(step.norm() < largest_predicted_step * radius && turn.norm() < largest_predicted_step))
      return false;
    state.point += on_paraboloid(step, frame, shape_operator, state.normal);
    state.normal = (state.normal + frame * turn).normalized();
    state.set_predicted();
    m_embedding.place(state);
    return true;
  }

  // what a vertex sees of its neighbours
  struct Surroundings
  {
    explicit Surroundings(const Centroid& empty) : centroid(empty) {}

    Centroid centroid;
    Shape_operator_estimate shape_operator;
    double squared_radius = (std::numeric_limits<double>::max)(); // of the nearest neighbour
  };

  bool gather(const Vertex_index v, const Vertex& state, const Tangent_frame& frame, Surroundings& around) const
  {
    double weights = 0;
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      const Vertex &a = m_mesh.state(m_mesh.source(h), h), &b = m_mesh.state(m_mesh.target(m_mesh.next(h)), h);
      const Eigen::Vector2d edge = frame.transpose() * (a.point - state.point);
      around.shape_operator.add_neighbor(edge, frame.transpose() * (a.normal - state.normal));
      around.centroid.add_neighbor(edge, a);
      around.squared_radius = (std::min)(around.squared_radius, (a.point - state.point).squaredNorm());
      const double weight = Embedded_triangle::area(m_embedding.squared_length(state, a), m_embedding.squared_length(a, b),
                                                    m_embedding.squared_length(b, state));
      weights += weight;
      around.centroid.add_face(weight, a, b);
    }
    return weights > 0;
  }

  Mesh& m_mesh;
  const Embedding& m_embedding;
  const Projection& m_projection;
  const Curve_network& m_curves;
  const Curve_placement<Embedding, Projection> m_placement;
  const Guard& m_guard;
  Interruption& m_interruption;
  Simultaneous_moves<Mesh> m_moves;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_VERTEX_SMOOTHER_H
