// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_scheme.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Target_length.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/collapse_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/flip_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/smooth_vertices.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/split_edges.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the parameters of the iterations, checked
struct Remeshing_parameters
{
  Remeshing_scheme scheme = Remeshing_scheme::DEFAULT;
  unsigned int number_of_iterations = 10;
  unsigned int number_of_relaxation_steps = 3;
  double smoothing_ratio = 1;
  double collapse_ratio = 0.8;
  double split_ratio = 4. / 3;
};

// The second of the paper's two steps: makes the mesh uniform and isotropic in the embedding by local operations.
template <typename ConcurrencyTag, typename Embedding, typename Projection, typename Visitor>
class Remesher
{
  // Passes stop when nothing is left to do, which these only bound: a split halves an edge, a contraction shortens none.
  static constexpr int maximum_number_of_split_passes = 40;
  static constexpr int maximum_number_of_collapse_passes = 40;
  static constexpr int maximum_number_of_paper_rounds = 20;

public:
  Remesher(Working_mesh& mesh, const Embedding& embedding, const Projection& projection, const Boundary_curves& boundary,
           const Remeshing_parameters& parameters, Visitor& visitor, Remeshing_result& result)
    : m_mesh(mesh), m_embedding(embedding), m_projection(projection), m_parameters(parameters), m_visitor(visitor), m_result(result),
      m_split(mesh, embedding, projection, boundary), m_collapse(mesh, embedding), m_flip(mesh, embedding),
      m_smooth(mesh, embedding, projection, boundary)
  {
  }

  void run(Target_length target)
  {
    const unsigned int n = m_parameters.number_of_iterations;
    for (m_iteration = 0; m_iteration < n && go_further(); ++m_iteration)
    {
      if (m_parameters.scheme == Remeshing_scheme::PAPER)
        iterate_as_the_paper(target.length());
      else
        iterate(target);
      m_result.number_of_iterations = m_iteration + 1;
      if (true)
        target.correct(m_mesh, m_embedding);
      report(1);
    }
    m_result.target_edge_length = target.length();
    project_exactly();
    if (m_parameters.number_of_iterations > 0)
      m_result.number_of_flips += m_flip(Flip_criterion::ANGLE);
  }

  // all vertices inside the surface onto the zero set
  void project_exactly()
  {
    parallel_for<ConcurrencyTag>(vertex_capacity(m_mesh),
                                 [&](const std::size_t i)
                                 {
                                   const Vertex_index v(static_cast<Vertex_index::size_type>(i));
                                   if (!m_mesh.is_removed(v))
                                     project_vertex(m_projection, m_mesh, v);
                                 },
                                 64);
  }

  // a vertex of the boundary stays on its polyline
  static void project_vertex(const Projection& projection, Working_mesh& mesh, const Vertex_index v)
  {
    Vertex_state& state = mesh.point(v);
    if (state.is_on_boundary())
      return projection.update_normal(state);
    double squared_sum = 0;
    std::size_t degree = 0;
    for (const Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      squared_sum += (mesh.point(mesh.source(h)).point - state.point).squaredNorm();
      ++degree;
    }
    projection.project(state, 0.5 * std::sqrt(squared_sum / double(degree)));
  }

private:
  // the default scheme
  void iterate(const Target_length& target)
  {
    const unsigned int steps = getenv("ST")?atoi(getenv("ST")): m_parameters.number_of_relaxation_steps;
    const double de=getenv("DE")?atof(getenv("DE")):0; const int vi=(getenv("VI")?atoi(getenv("VI")):m_parameters.number_of_iterations/2);  const int ph=getenv("PH")?atoi(getenv("PH")):0;
    double f = 1; if(int(m_iteration)<vi) f = (m_iteration+ph)%2 ? 1+de : 1-de;
    const double l = target.length()/std::sqrt(f);
    split(l);
    report(0.2);
    collapse(l);
    if (m_iteration > 0) {
      const std::ptrdiff_t excess = std::ptrdiff_t(m_mesh.number_of_faces()) - std::ptrdiff_t(f*target.m_number_of_faces);
      if (excess > 1) m_result.number_of_collapses += m_collapse(l, m_parameters.split_ratio * l, std::size_t(excess / 2));
      else if (excess < -1) m_result.number_of_splits += m_split(l, std::size_t(-excess / 2));
    }
    report(0.3);
    const Flip_criterion criterion = m_iteration < (getenv("VI")?atoi(getenv("VI")):m_parameters.number_of_iterations/2) ? Flip_criterion::VALENCE : Flip_criterion::ANGLE;
    for (unsigned int step = 0; step < steps; ++step)
    {
      flip(criterion);
      smooth();
      report(0.3 + 0.7 * (step + 1) / (steps + 1));
    }
    flip(criterion);
  }

  // Algorithm 2 of the paper
  void iterate_as_the_paper(const double length)
  {
    bool is_any_contracted = true;
    for (int round = 0; is_any_contracted && round < maximum_number_of_paper_rounds && go_further(); ++round)
    {
      const std::size_t before = m_result.number_of_collapses;
      collapse(length);
      is_any_contracted = m_result.number_of_collapses > before;
      smooth();
      flip(Flip_criterion::ANGLE);
    }
    report(0.5);
    split(length);
    flip(Flip_criterion::ANGLE);
    smooth();
    flip(Flip_criterion::ANGLE);
  }

  void split(const double length)
  {
    for (int pass = 0; pass < maximum_number_of_split_passes && go_further(); ++pass)
    {
      const std::size_t count = m_split(m_parameters.split_ratio * length);
      m_result.number_of_splits += count;
      if (count == 0)
        break;
    }
  }

  void collapse(const double length)
  {
    for (int pass = 0; pass < maximum_number_of_collapse_passes && go_further(); ++pass)
    {
      const std::size_t count = m_collapse(m_parameters.collapse_ratio * length, m_parameters.split_ratio * length);
      m_result.number_of_collapses += count;
      if (count == 0)
        break;
    }
  }

  void flip(const Flip_criterion criterion)
  {
    if (go_further())
      m_result.number_of_flips += m_flip(criterion);
  }

  void smooth()
  {
    if (go_further())
      m_smooth(m_parameters.smoothing_ratio);
  }

  // After two thirds of the iterations the length is frozen: correcting it on a settled mesh does nothing.
  unsigned int last_correction() const { return (2 * m_parameters.number_of_iterations + 2) / 3; }

  // then the shortest or the longest edges make up for the difference, two faces an edge, and the smoothing spreads it
  void approach_number_of_faces(const Target_length& target)
  {
    const std::ptrdiff_t excess = target.excess(m_mesh.number_of_faces());
    if (excess > 1)
      m_result.number_of_collapses +=
          m_collapse(target.length(), m_parameters.split_ratio * target.length(), std::size_t(excess / 2));
    else if (excess < -1)
      m_result.number_of_splits += m_split(target.length(), std::size_t(-excess / 2));
  }

  bool go_further()
  {
    m_result.was_stopped = m_result.was_stopped || !m_visitor.go_further();
    return !m_result.was_stopped;
  }

  void report(const double share_of_iteration)
  {
    m_visitor.progress((m_iteration + share_of_iteration) / m_parameters.number_of_iterations);
  }

  Working_mesh& m_mesh;
  const Embedding& m_embedding;
  const Projection& m_projection;
  Remeshing_parameters m_parameters;
  Visitor& m_visitor;
  Remeshing_result& m_result;
  const Edge_splitter<ConcurrencyTag, Embedding, Projection> m_split;
  const Edge_collapser<Embedding> m_collapse;
  const Edge_flipper<Embedding> m_flip;
  const Vertex_smoother<ConcurrencyTag, Embedding, Projection> m_smooth;
  unsigned int m_iteration = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHER_H
