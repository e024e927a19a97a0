// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_ERROR_FITTER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_ERROR_FITTER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sampled_ring.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Moves the vertices in space where the distances of the samples are least, by a step of Gauss and Newton: planes of the samples
// against points of the faces, and a small weight for the points themselves. Blocks of three rows for each vertex, solved by
// conjugate gradients.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Error_fitter
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;

  static constexpr double tangential_weight = 0.02;
  static constexpr double damping = 1e-3; // of the mean of the diagonal
  static constexpr double least_weight = 0.05, largest_weight = 200;
  static constexpr int maximum_number_of_steps = 12; // of conjugate gradients
  static constexpr double exactness = 3e-2;          // of the residual
  static constexpr double longest_step = 0.4;        // of the shortest edge at a vertex
  static constexpr int number_of_halvings = 4;
  static constexpr double smallest_cosine = 0.3, smallest_cosine_of_turn = 0.5;
  static constexpr double share_without_check = 0.5; // of the largest distance: below it nothing happens

  // What a face adds to the normal equations: the blocks of the pairs 00 11 22 01 12 20 of its corners, and the right side of each
  // corner, by columns. Of the symmetric blocks there are the entries xx yy zz xy yz zx.
  struct Face_system
  {
    Eigen::Matrix<double, 6, 6> blocks = Eigen::Matrix<double, 6, 6>::Zero();
    Matrix right = Matrix::Zero();

    Matrix block(const std::size_t k) const
    {
      const auto& b = blocks.col(Eigen::Index(k));
      Matrix m;
      m << b[0], b[3], b[5], b[3], b[1], b[4], b[5], b[4], b[2];
      return m;
    }
  };

public:
  Error_fitter(Mesh& mesh, const Guard& guard, const Owners& owners, const Shape_price& price, Interruption& interruption)
    : m_mesh(mesh), m_guard(guard), m_owners(owners), m_price(price), m_interruption(interruption)
  {
  }

  // one step; the samples must be up to date
  void operator()()
  {
    assemble();
    solve();
    move_vertices();
  }

private:
  bool is_free(const Vertex_index v) const { return !m_mesh.point(v).is_on_curve && !m_mesh.point(v).is_fixed; }

  void assemble()
  {
    m_systems.resize(face_capacity(m_mesh));
    parallel_for<ConcurrencyTag>(m_systems.size(),
                                 [&](const std::size_t i)
                                 {
                                   const Face_index f{std::uint32_t(i)};
                                   if (!m_mesh.is_removed(f))
                                     m_systems[i] = system(f);
                                 });
    // rows: the vertices, with their neighbours in the order around them
    const std::size_t n = vertex_capacity(m_mesh);
    m_first.assign(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i)
    {
      const Vertex_index v{std::uint32_t(i)};
      m_first[i + 1] = m_first[i] + (m_mesh.is_removed(v) || !is_free(v) ? 0 : m_mesh.degree(v));
    }
    m_neighbors.resize(m_first[n]);
    m_blocks.resize(m_first[n]);
    m_diagonal.assign(n, Matrix::Zero());
    m_right.assign(n, Vector::Zero());
    parallel_for<ConcurrencyTag>(n, [&](const std::size_t i) { assemble(i); });
    double trace = 0;
    std::size_t number = 0;
    for (std::size_t i = 0; i < n; ++i)
      if (m_first[i + 1] > m_first[i])
      {
        trace += m_diagonal[i].trace();
        number += 3;
      }
    for (std::size_t i = 0; i < n; ++i)
      m_diagonal[i].diagonal().array() += number > 0 && trace > 0 ? damping * trace / double(number) : 1.;
  }

  Face_system system(const Face_index f) const
  {
    Face_system s;
    const Space_triangle t = m_owners.triangle(f);
    m_owners.for_each(f,
                      [&](const std::uint32_t i)
                      {
                        const Reference_sample& sample = m_owners.sample(i);
                        const Closest_on_triangle c = t.closest(sample.point);
                        const Vector& b = c.barycentric;
                        add(sample.point - (b[0] * t.a + b[1] * t.b + b[2] * t.c), sample.normal.template cast<double>(),
                            sample.area * bounded_weight(c.squared_distance), b, s);
                      });
    add_points_of_face(f, t, s);
    return s;
  }

  // the other way: points of the face against the planes of the nearest samples
  void add_points_of_face(const Face_index f, const Space_triangle& t, Face_system& s) const
  {
    const double area = t.normal().norm() / (2 * m_owners.area_of_surface());
    for (std::size_t node = 0; node < Owners::number_of_nodes; ++node)
    {
      const std::uint32_t nearest = m_owners.nearest(f, node);
      if (Owners::is_none(nearest))
        continue;
      const Vector& b = Owners::node(node).barycentric;
      const Vector q = t.point(b);
      const Vector x = m_owners.reference_point(q, nearest), normal = m_owners.sample(nearest).normal.template cast<double>();
      add((x - q), normal, Owners::node(node).weight * area * bounded_weight((x - q).squaredNorm()), b, s);
    }
  }

  double bounded_weight(const double squared_distance) const
  {
    return (std::min)(largest_weight, (std::max)(least_weight, m_owners.weight(squared_distance)));
  }

  // `way` is that from the point of the face with barycentric coordinates b to the reference
  static void add(const Vector& way, const Vector& normal, const double weight, const Vector& b, Face_system& s)
  {
    Eigen::Matrix<double, 6, 1> block, pairs;
    block << normal.cwiseProduct(normal), normal[0] * normal[1], normal[1] * normal[2], normal[2] * normal[0];
    block.template head<3>().array() += tangential_weight;
    pairs << b.cwiseProduct(b), b[0] * b[1], b[1] * b[2], b[2] * b[0];
    s.blocks.noalias() += weight * block * pairs.transpose();
    s.right.noalias() += weight * (normal.dot(way) * normal + tangential_weight * way) * b.transpose();
  }

  void assemble(const std::size_t i)
  {
    if (m_first[i + 1] == m_first[i])
      return;
    const Vertex_index v{std::uint32_t(i)};
    std::size_t place = m_first[i];
    const std::size_t end = m_first[i + 1];
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      m_neighbors[place] = m_mesh.source(h);
      Matrix block = Matrix::Zero();
      // the edge has a face on each side
      for (const Halfedge_index side : {h, m_mesh.opposite(h)})
        if (!m_mesh.is_border(side))
          block += m_systems[m_mesh.face(side)].block(3 + index_of_source(side));
      m_blocks[place] = block;
      if (!m_mesh.is_border(h))
      {
        const std::size_t k = (index_of_source(h) + 1) % 3;
        m_diagonal[i] += m_systems[m_mesh.face(h)].block(k);
        m_right[i] += m_systems[m_mesh.face(h)].right.col(Eigen::Index(k));
      }
      ++place;
    }
    CGAL_assertion(place == end);
    (void)end;
  }

  // the number of the corner of its face at which a halfedge begins
  std::size_t index_of_source(const Halfedge_index h) const
  {
    const Halfedge_index first = m_mesh.halfedge(m_mesh.face(h));
    return h == first ? 0 : h == m_mesh.next(first) ? 1 : 2;
  }

  void multiply(const std::vector<Vector>& x, std::vector<Vector>& y) const
  {
    parallel_for<ConcurrencyTag>(x.size(),
                                 [&](const std::size_t i)
                                 {
                                   Vector sum = m_diagonal[i] * x[i];
                                   for (std::size_t k = m_first[i]; k < m_first[i + 1]; ++k)
                                     sum.noalias() += m_blocks[k] * x[m_neighbors[k]];
                                   y[i] = m_first[i + 1] > m_first[i] ? sum : Vector::Zero();
                                 });
  }

  static double dot(const std::vector<Vector>& x, const std::vector<Vector>& y)
  {
    return parallel_sum<ConcurrencyTag>(x.size(), [&](const std::size_t i) { return x[i].dot(y[i]); });
  }

  // conjugate gradients with the diagonal blocks as preconditioner
  void solve()
  {
    const std::size_t n = m_right.size();
    std::vector<Matrix> inverse(n);
    parallel_for<ConcurrencyTag>(n, [&](const std::size_t i) { inverse[i] = m_diagonal[i].inverse(); });
    m_steps.assign(n, Vector::Zero());
    std::vector<Vector> r = m_right, z(n, Vector::Zero()), p(n), q(n);
    const auto precondition = [&] { parallel_for<ConcurrencyTag>(n, [&](const std::size_t i) { z[i] = inverse[i] * r[i]; }); };
    precondition();
    p = z;
    double rz = dot(r, z);
    const double end = exactness * exactness * rz;
    for (int step = 0; step < maximum_number_of_steps && rz > end && rz > 0; ++step)
    {
      multiply(p, q);
      const double alpha = rz / dot(p, q);
      parallel_for<ConcurrencyTag>(n,
                                   [&](const std::size_t i)
                                   {
                                     m_steps[i] += alpha * p[i];
                                     r[i] -= alpha * q[i];
                                   });
      precondition();
      const double next = dot(r, z), beta = next / rz;
      rz = next;
      parallel_for<ConcurrencyTag>(n, [&](const std::size_t i) { p[i] = z[i] + beta * p[i]; });
    }
  }

  // Moves one vertex after the other. A step that the faces do not allow is halved.
  void move_vertices()
  {
    for (const Vertex_index v : m_mesh.vertices())
    {
      if (m_interruption.poll())
        return;
      Vector step = m_steps[v];
      if (!is_free(v) || !step.allFinite() || step.isZero())
        continue;
      const Vector old = m_mesh.point(v).point;
      double shortest = (std::numeric_limits<double>::max)();
      for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        shortest = (std::min)(shortest, (m_mesh.point(m_mesh.source(h)).point - old).norm());
      const double length = step.norm();
      if (length > longest_step * shortest)
        step *= longest_step * shortest / length;
      for (int k = 0; k < number_of_halvings; ++k, step /= 2)
        if (is_accepted(v, old + step))
        {
          m_mesh.point(v).point = old + step;
          m_guard.update_around(v);
          break;
        }
    }
  }

  bool is_accepted(const Vertex_index v, const Vector& point) const
  {
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      if (m_mesh.is_border(h))
        continue;
      const Triangle t(h, m_mesh);
      const Space_triangle before{m_mesh.point(t.a).point, m_mesh.point(v).point, m_mesh.point(t.c).point};
      const Space_triangle after{before.a, point, before.c};
      const Vector m = before.normal(), n = after.normal();
      const double length_m = m.norm(), length_n = n.norm();
      if (!(length_n > 0) || n.dot(m) < smallest_cosine_of_turn * length_m * length_n)
        return false;
      Vector normal = m_owners.normal(m_mesh.face(h));
      if (!(normal.norm() > 0))
        normal = m;
      normal.normalize();
      const double cosine = n.dot(normal) / length_n;
      if (cosine < smallest_cosine && cosine < m.dot(normal) / length_m)
        return false;
      const double ratio = after.ratio();
      if (ratio > m_price.free_ratio() && !may_have_ratio(ratio, before.ratio()))
        return false;
    }
    if (m_owners.bounds_distance() && !stays_within_distance(v, point))
      return false;
    m_moved = m_mesh.point(v);
    m_moved.point = point;
    return m_guard.accepts(change_of_move(m_mesh, v, m_moved));
  }

  bool may_have_ratio(const double ratio, const double before) const
  {
    return ratio <= before || ratio <= (std::min)(m_price.largest_ratio(), 1.1 * before);
  }

  // Around the vertex no distance may become larger than the largest that is allowed; if one is already, all must cost less.
  bool stays_within_distance(const Vertex_index v, const Vector& point) const
  {
    const double largest_square = m_owners.largest_square();
    double square = (m_mesh.point(v).point - point).squaredNorm();
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (!m_mesh.is_border(h))
        square = (std::max)(square, m_owners.squared_distance(m_mesh.face(h)));
    if (square < share_without_check * share_without_check * largest_square)
      return true;
    Sampled_ring<ConcurrencyTag, Mesh> ring(m_mesh, m_owners, m_price);
    ring.add_vertex(v);
    const double infinity = (std::numeric_limits<double>::infinity)();
    return ring.cost_at(point, infinity, largest_square) < infinity || ring.cost_at(point, ring.cost(), infinity) < ring.cost();
  }

  Mesh& m_mesh;
  const Guard& m_guard;
  const Owners& m_owners;
  const Shape_price& m_price;
  Interruption& m_interruption;
  std::vector<Face_system> m_systems; // by face
  std::vector<std::size_t> m_first;   // of the neighbours of a vertex; none if it is not free
  std::vector<Vertex_index> m_neighbors;
  std::vector<Matrix> m_blocks;   // of the neighbours
  std::vector<Matrix> m_diagonal; // by vertex
  std::vector<Vector> m_right, m_steps;
  mutable typename Mesh::Vertex m_moved; // the state that a change refers to
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_ERROR_FITTER_H
