// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_ERROR_TARGET_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_ERROR_TARGET_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Shape_operator_estimate.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Deviation_bound.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Tells how many faces it takes to keep the distance between the faces and the surface below an error, and which faces exceed
// the error. Boundaries and constrained curves lie as far off the surface as the input does. So a face that touches one may
// exceed the error by the distance of its vertices there.
template <typename ConcurrencyTag, typename Mesh, typename Function>
class Error_target
{
  // The number of faces is about this multiple of the asymptotic bound for the largest distance.
  static constexpr double first_ratio_to_bound = 1.4;
  // While the mesh is remeshed, all faces but this share are to stay below the error. The rest is refined in the end.
  static constexpr double share_refined_in_the_end = 0.04;
  static constexpr double largest_factor = 2;
  // A face is small up to this size: the sum of two of its edges, about twice its longest edge, over the error. If the distance
  // of a small face still exceeds the error, the face does not lie along the surface that the function has: to split it does
  // not help.
  static constexpr double smallest_face = 4;

public:
  Error_target(const Mesh& mesh, const Function& function, const Input_surface& input, const double error,
               Interruption& interruption)
    : m_mesh(mesh), m_to_input{input}, m_error(error), m_interruption(interruption)
  {
    for (std::size_t i = 0; i < number_of_pieces(function); ++i)
      m_bounds.emplace_back(piece(function, Region(i)), m_to_input);
  }
  Error_target(const Error_target&) = delete;

  // The asymptotic bound: the integral of g |K|^(1/2) over the surface, divided by the error. K is the Gauss curvature. See
  // Approximation_bounds.
  double first_number_of_faces() const
  {
    static constexpr double g = 0.3849002;
    double integral = 0;
    for (const Vertex_index v : m_mesh.vertices())
    {
      // adds a third of each face around the vertex; each region at the vertex has its own curvature
      Region last = 0;
      double curvature = 0;
      bool is_first = true;
      for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      {
        if (m_mesh.is_border(h))
          continue;
        if (is_first || m_mesh.region(h) != last)
          curvature = std::sqrt(std::abs(shape_operator_at(h, m_mesh).determinant()));
        is_first = false;
        last = m_mesh.region(h);
        const Triangle t(h, m_mesh);
        integral += (point(t.b) - point(t.a)).cross(point(t.c) - point(t.a)).norm() / 6 * g * curvature;
      }
    }
    return first_ratio_to_bound * integral / m_error;
  }

  // by what factor the number of faces is to change: the error of a face is proportional to its area
  double factor_of_number_of_faces() const
  {
    const std::vector<Face_index> faces(m_mesh.faces().begin(), m_mesh.faces().end());
    std::vector<double> errors(faces.size(), 0.);
    parallel_for<ConcurrencyTag>(
        faces.size(),
        [&](const std::size_t i)
        {
          const Triangle t(m_mesh.halfedge(faces[i]), m_mesh);
          if (!is_on_curve(t))
            errors[i] = bound_in_region(faces[i]).estimate(point(t.a), point(t.b), point(t.c));
        },
        16, m_interruption);
    const std::size_t rank = std::size_t((1 - share_refined_in_the_end) * double(errors.size() - 1));
    std::nth_element(errors.begin(), errors.begin() + std::ptrdiff_t(rank), errors.end());
    return (std::min)((std::max)(errors[rank] / m_error, 1 / largest_factor), largest_factor);
  }

  // A face whose bound is above the error. `attempt` tells which of its edges is to be split: each time the next one, if the
  // last one was not split.
  struct Failing_face
  {
    Face_index face;
    int attempt;
  };

  // A face that has passed is not looked at again. So vertices must not move between two calls.
  std::vector<Failing_face> failing_faces()
  {
    m_records.resize(face_capacity(m_mesh));
    parallel_for<ConcurrencyTag>(
        m_records.size(),
        [&](const std::size_t i)
        {
          const Face_index f(static_cast<Face_index::size_type>(i));
          if (!m_mesh.is_removed(f))
            look_at(f);
        },
        4, m_interruption);
    std::vector<Failing_face> failing;
    m_largest_bound = 0;
    for (const Face_index f : m_mesh.faces())
    {
      const Record& record = m_records[f];
      if (record.attempts > 0)
        failing.push_back(Failing_face{f, record.attempts - 1});
      m_largest_bound = (std::max)(m_largest_bound, record.bound);
    }
    return failing;
  }

  // the largest bound that `failing_faces()` found, over all faces but those on curves
  double largest_bound() const { return m_largest_bound; }

private:
  // where the function leads nowhere, the input is the surface, as for the projection
  struct Distance_to_input
  {
    const Input_surface& input;
    double operator()(const Vector& p) const { return input.empty() ? 0. : (input.closest(p).point - p).norm(); }
  };
  typedef Deviation_bound<Piece_of<Function>, Distance_to_input> Bound;

  struct Record
  {
    std::array<Vertex_index, 3> vertices; // of the face when it was looked at
    double bound = 0;                     // 0 on curves
    int attempts = 0;                     // how often it has failed with these vertices; 0: it has passed, or is hopeless
  };

  const Bound& bound_in_region(const Face_index f) const { return m_bounds[m_mesh.region(m_mesh.halfedge(f))]; }

  const Vector& point(const Vertex_index v) const { return m_mesh.point(v).point; }

  bool is_on_curve(const Triangle& t) const
  {
    return m_mesh.point(t.a).is_on_curve || m_mesh.point(t.b).is_on_curve || m_mesh.point(t.c).is_on_curve;
  }

  void look_at(const Face_index f)
  {
    const Triangle t(m_mesh.halfedge(f), m_mesh);
    std::array<Vertex_index, 3> vertices{t.a, t.b, t.c};
    std::sort(vertices.begin(), vertices.end());
    Record& record = m_records[f];
    if (record.vertices == vertices)
    {
      record.attempts += record.attempts > 0 ? 1 : 0;
      return;
    }
    const double reach = (point(t.a) - point(t.b)).norm() + (point(t.b) - point(t.c)).norm();
    const Bound& bound_of = bound_in_region(f);
    double allowed = m_error;
    for (const Vertex_index v : vertices)
      if (m_mesh.point(v).is_on_curve)
        allowed = (std::max)(allowed, m_error + bound_of.distance(point(v), reach));
    const double bound = bound_of(point(t.a), point(t.b), point(t.c), allowed);
    const bool is_hopeless = reach <= smallest_face * m_error;
    record = Record{vertices, is_on_curve(t) ? 0. : bound, bound <= allowed || is_hopeless ? 0 : 1};
  }

  const Mesh& m_mesh;
  const Distance_to_input m_to_input;
  std::vector<Bound> m_bounds; // by region
  const double m_error;
  Interruption& m_interruption;
  std::vector<Record> m_records; // by face
  double m_largest_bound = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_ERROR_TARGET_H
