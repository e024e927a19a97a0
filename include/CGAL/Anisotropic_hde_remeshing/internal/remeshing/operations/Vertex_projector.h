// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_VERTEX_PROJECTOR_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_VERTEX_PROJECTOR_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_placement.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Simultaneous_moves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Vertex_fitter.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Moves all vertices at once: onto the surface, and off it again where that makes the faces fit the surface better. Moves that
// the guard does not accept are taken back.
template <typename ConcurrencyTag, typename Embedding, typename Projection, typename Guard>
class Vertex_projector
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  typedef typename Mesh::Vertex Vertex;
  typedef Simultaneous_moves<Mesh> Moves;

public:
  Vertex_projector(Mesh& mesh, const Embedding& embedding, const Projection& projection, const Curve_network& curves,
                   const Guard& guard)
    : m_mesh(mesh), m_embedding(embedding), m_projection(projection), m_placement(embedding, projection, curves), m_guard(guard)
  {
  }

  // Moves the vertices of the input onto the zero set. Fixed vertices and those on polylines stay. Vertices where the mesh
  // would fold stay for now, and have more attempts later.
  void project_input(Interruption& interruption)
  {
    Moves moves = exact_projections(all, interruption);
    m_guard.template revert_first<ConcurrencyTag>(moves, interruption);
    moves.template accept<ConcurrencyTag>(m_mesh);
    for (const Vertex_index v : m_mesh.vertices())
      if (!moves.is_moved(v))
      {
        m_placement.update(m_mesh.point(v), region(v), m_mesh.sides(v));
        if (is_free(v))
          m_mesh.point(v).set_predicted();
      }
  }

  // Projects all chosen vertices in the end. The last way of a vertex goes from a rough projection to the exact one. A vertex
  // stays if this way would fold a face or, where that counts, make a face intersect another one. Moves are taken back together with
  // those of neighbours, so who had to stay tries again. Returns false if it was interrupted and did
  // nothing.
  template <typename IsChosen>
  bool project_exactly(const IsChosen& is_chosen, Interruption& interruption)
  {
    std::vector<Vertex_index> left;
    if (!project_exactly_once(is_chosen, interruption, left))
      return false; // not all vertices have been projected, or checked
    try_again(left);
    m_unprojected.insert(m_unprojected.end(), left.begin(), left.end());
    std::sort(m_unprojected.begin(), m_unprojected.end());
    return true;
  }

  // projects those again that exact projections have left off the surface, as the faces around them may have changed
  void project_rest() { try_again(m_unprojected); }

  bool project_exactly(Interruption& interruption) { return project_exactly(all, interruption); }

  // how many vertices exact projections have left off the surface
  std::size_t number_of_unprojected_vertices() const { return m_unprojected.size(); }

  // after the mesh is as it was before
  void forget_unprojected() { m_unprojected.clear(); }

  // moves vertices off the surface again, by least squares
  void fit(Interruption& interruption)
  {
    const std::size_t n = vertex_capacity(m_mesh);
    std::vector<Vector> points(n, Vector::Zero()), normals(n, Vector::Zero());
    std::vector<char> is_fitted(n, 0);
    for (const Vertex_index v : m_mesh.vertices())
    {
      const Vertex& vertex = m_mesh.point(v);
      points[v] = vertex.point;
      normals[v] = m_projection.orientation(region(v)) * vertex.normal;
      is_fitted[v] = is_free(v);
    }
    std::vector<Facet> facets;
    std::vector<Region> regions;
    for (const Face_index f : m_mesh.faces())
    {
      const Triangle t(m_mesh.halfedge(f), m_mesh);
      facets.push_back(Facet{t.a, t.b, t.c});
      regions.push_back(m_mesh.region(m_mesh.halfedge(f)));
    }
    const Vertex_fitter<ConcurrencyTag, typename Projection::Function> fit(m_projection.function());
    fit(points, normals, is_fitted, facets, regions);
    Moves moves(m_mesh);
    moves.template propose<ConcurrencyTag>([&](const Vertex_index v) { return bool(is_fitted[v]); },
                                           [&](const Vertex_index v, Vertex& state, typename Mesh::Sides&)
                                           {
                                             state.point = points[v];
                                             return true;
                                           },
                                           interruption);
    m_guard.template revert<ConcurrencyTag>(moves, interruption);
    if (!interruption.is_requested())
      moves.template accept<ConcurrencyTag>(m_mesh);
  }

private:
  static bool all(Vertex_index) { return true; }

  // lists the chosen vertices that are still off the surface
  template <typename IsChosen>
  bool project_exactly_once(const IsChosen& is_chosen, Interruption& interruption, std::vector<Vertex_index>& left,
                            const double share_of_mean = 0)
  {
    Moves moves = exact_projections(is_chosen, interruption, share_of_mean);
    m_guard.template revert<ConcurrencyTag>(moves, interruption);
    if (interruption.is_requested())
      return false;
    moves.template accept<ConcurrencyTag>(m_mesh);
    m_guard.template update_landmarks<ConcurrencyTag>();
    left.clear();
    for (const Vertex_index v : m_mesh.vertices())
      if (is_chosen(v) && belongs_on_surface(v) && may_be_off_surface(v, moves) &&
          !m_projection.is_on_surface(m_mesh.point(v), region(v)))
        left.push_back(v);
    return true;
  }

  // Projects these few, which are sorted: from where they are, as their neighbours may have moved, and from ever further on the way to
  // the mean of their neighbours, as from there the last way may fold nothing.
  void try_again(std::vector<Vertex_index>& left)
  {
    for (const double share : {0., 0.1, 0.3, 1.})
    {
      if (left.empty())
        return;
      const std::vector<Vertex_index> due = left;
      Interruption never;
      project_exactly_once([&due](const Vertex_index v) { return std::binary_search(due.begin(), due.end(), v); }, never, left,
                           share);
    }
  }

  bool belongs_on_surface(const Vertex_index v) const { return is_free(v) || m_placement.is_on_projected_border(v, m_mesh); }

  bool may_be_off_surface(const Vertex_index v, const Moves& moves) const
  {
    return !moves.is_moved(v) || m_mesh.point(v).is_on_input || !is_free(v);
  }

  bool is_free(const Vertex_index v) const { return !m_mesh.point(v).is_on_curve && !m_mesh.point(v).is_fixed; }

  template <typename IsChosen>
  Moves exact_projections(const IsChosen& is_chosen, Interruption& interruption, const double share_of_mean = 0) const
  {
    Moves moves(m_mesh);
    moves.template propose<ConcurrencyTag>(
        is_chosen,
        [&](const Vertex_index v, Vertex& state, typename Mesh::Sides& sides)
        {
          if (is_free(v))
          {
            if (share_of_mean > 0)
              state.point += share_of_mean * (mean_of_neighbors(v) - state.point);
            m_projection.project(state, region(v), 0.5 * mean_edge_length(v));
            m_embedding.place(state);
          }
          else
          {
            if (m_placement.is_on_projected_border(v, m_mesh))
              state.point = m_placement.point_on_border(v, region(v), m_mesh);
            m_placement.update(state, region(v), sides);
          }
          return true;
        },
        interruption);
    return moves;
  }

  // the region of a vertex that is not on a crease
  Region region(const Vertex_index v) const { return m_mesh.region(m_mesh.halfedge(v)); }

  Vector mean_of_neighbors(const Vertex_index v) const
  {
    Vector sum = Vector::Zero();
    std::size_t degree = 0;
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      sum += m_mesh.point(m_mesh.source(h)).point;
      ++degree;
    }
    return sum / double(degree);
  }

  // the root mean square of the lengths in space
  double mean_edge_length(const Vertex_index v) const
  {
    double squared_sum = 0;
    std::size_t degree = 0;
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      squared_sum += (m_mesh.point(m_mesh.source(h)).point - m_mesh.point(v).point).squaredNorm();
      ++degree;
    }
    return std::sqrt(squared_sum / double(degree));
  }

  Mesh& m_mesh;
  const Embedding& m_embedding;
  const Projection& m_projection;
  const Curve_placement<Embedding, Projection> m_placement;
  const Guard& m_guard;
  std::vector<Vertex_index> m_unprojected; // those that exact projections have left off the surface
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_VERTEX_PROJECTOR_H
