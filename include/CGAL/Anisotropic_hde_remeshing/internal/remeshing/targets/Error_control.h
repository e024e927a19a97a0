// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_ERROR_CONTROL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_ERROR_CONTROL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/size_limits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_flipper.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Error_target.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Target_length.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Leads the remeshing to an error. The number of faces follows the error of the mesh. In the end the faces that exceed the error
// are split.
template <typename ConcurrencyTag, typename Embedding, typename Projection, typename Guard, typename Operations,
          typename Projector>
class Error_control
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  typedef Error_target<ConcurrencyTag, Mesh, typename Projection::Function> Error_of_mesh;

  static constexpr int maximum_number_of_rounds = 16; // a bound only
  static constexpr double largest_deviation = 1.5;    // of a face's centroid during the remeshing, over the error
  static constexpr double largest_growth = 8;         // of the number of faces; it ends a hopeless refinement

public:
  // With an error of 0 there is nothing to control. `largest_number_of_faces` is the number that is allowed.
  Error_control(Mesh& mesh, const Embedding& embedding, const Projection& projection, Guard& guard, Operations& operations,
                Projector& projector, const double error, const double largest_number_of_faces, Interruption& interruption)
    : m_mesh(mesh),
      m_embedding(embedding),
      m_projection(projection),
      m_guard(guard),
      m_operations(operations),
      m_projector(projector),
      m_error(error),
      m_largest_number_of_faces(largest_number_of_faces),
      m_interruption(interruption)
  {
  }

  bool is_active() const { return m_error > 0; }

  // the bound on the distance in the end, and what decided on the number of faces
  double bound() const { return m_bound; }
  Target binding_target() const { return m_binding_target; }

  // aims at the number of faces that the error seems to ask for
  void start(Target_length& target) { limit_number_of_faces(error_of_mesh().first_number_of_faces(), target); }

  // aims at the number of faces that the error of the mesh asks for
  void approach(Target_length& target)
  {
    limit_number_of_faces(error_of_mesh().factor_of_number_of_faces() * double(m_mesh.number_of_faces()), target);
    target.template update<ConcurrencyTag>(m_mesh, m_embedding);
  }

  // nothing is known of a mesh whose remeshing was interrupted
  void give_up() { m_bound = is_active() ? (std::numeric_limits<double>::infinity)() : 0; }

  // measures the error of a mesh that is not refined
  void measure()
  {
    Error_of_mesh error = error_of_mesh();
    error.failing_faces();
    m_bound = m_interruption.is_requested() ? (std::numeric_limits<double>::infinity)() : error.largest_bound();
    m_binding_target = m_bound <= m_error ? Target::APPROXIMATION_ERROR : Target::NUMBER_OF_FACES;
  }

  // Splits edges of the faces that exceed the error, until no face does or the mesh has as many faces as allowed. Each round
  // halves edges and so quarters their errors. A measurement comes last.
  void refine()
  {
    const double largest_number_of_faces =
        (std::min)(m_largest_number_of_faces, largest_growth * double(m_mesh.number_of_faces()));
    Error_of_mesh error = error_of_mesh();
    for (int round = 0; !m_interruption.ask(); ++round)
    {
      std::vector<Edge_index> edges = edges_to_split(error.failing_faces());
      m_bound = error.largest_bound();
      const double room =
          (std::min)((largest_number_of_faces - double(m_mesh.number_of_faces())) / 2, // an edge splits two faces
                     room_for_splits(m_mesh.num_halfedges()));
      if (!edges.empty() && room < 1 && largest_number_of_faces == m_largest_number_of_faces)
        m_binding_target = Target::NUMBER_OF_FACES;
      if (edges.empty() || room < 1 || round == maximum_number_of_rounds)
        break;
      if (double(edges.size()) > room)
        edges.resize(std::size_t(room));
      split(edges);
    }
    if (m_interruption.is_requested()) // not all faces have been measured
      m_bound = (std::numeric_limits<double>::infinity)();
  }

private:
  Error_of_mesh error_of_mesh() const
  {
    return Error_of_mesh(m_mesh, m_projection.function(), m_projection.input(), m_error, m_interruption);
  }

  void limit_number_of_faces(const double wanted, Target_length& target)
  {
    m_binding_target = wanted < m_largest_number_of_faces ? Target::APPROXIMATION_ERROR : Target::NUMBER_OF_FACES;
    target.set_number_of_faces((std::max)((std::min)(wanted, m_largest_number_of_faces), 4.));
    // where the number binds, the error cannot be kept
    m_guard.set_largest_distance(wanted > m_largest_number_of_faces ? (std::numeric_limits<double>::infinity)()
                                                                    : largest_deviation * m_error);
  }

  // Splits the edges and puts the new vertices exactly on the surface. The other vertices do not move, because their faces have
  // passed.
  void split(const std::vector<Edge_index>& edges)
  {
    std::vector<char> is_old(vertex_capacity(m_mesh) + edges.size(), 0);
    for (const Vertex_index v : m_mesh.vertices())
      is_old[v] = 1;
    m_operations.split(edges);
    m_operations.flip(Flip_criterion::ANGLE);
    const auto is_new = [&](const Vertex_index v) { return !is_old[v]; };
    if (!m_projector.project_exactly(is_new, m_interruption)) // interrupted, but they are on the surface only roughly
    {
      Interruption never;
      m_projector.project_exactly(is_new, never);
    }
  }

  // The longest edge in the embedding of each face; the next one if that could not be split. Each edge comes once, in the order
  // of the mesh.
  std::vector<Edge_index> edges_to_split(const std::vector<typename Error_of_mesh::Failing_face>& faces) const
  {
    std::vector<Edge_index> edges;
    for (const auto& failing : faces)
    {
      std::array<std::pair<double, Edge_index>, 3> sides;
      std::size_t k = 0;
      for (const Halfedge_index h : m_mesh.halfedges_around_face(m_mesh.halfedge(failing.face)))
        sides[k++] = {-squared_length(m_mesh.edge(h), m_mesh, m_embedding), m_mesh.edge(h)};
      std::sort(sides.begin(), sides.end());
      edges.push_back(sides[std::size_t(failing.attempt % 3)].second);
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  Mesh& m_mesh;
  const Embedding& m_embedding;
  const Projection& m_projection;
  Guard& m_guard;
  Operations& m_operations;
  Projector& m_projector;
  const double m_error;
  const double m_largest_number_of_faces;
  Interruption& m_interruption;
  double m_bound = 0;
  Target m_binding_target = Target::NUMBER_OF_FACES;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_ERROR_CONTROL_H
