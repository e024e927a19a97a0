// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SPLIT_INPUT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SPLIT_INPUT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_subdivision.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Splits faces at the middles of their longest edges until there are so many. The surface stays as it is, and the new vertices count
// as those of the input.
template <typename Mesh>
class Face_splitter
{
  // A face comes first if it is long or large: by the length of its longest edge, times the ratio to the altitude over it. Halves of
  // a needle are needles, too, until it is split across: so a row of needles is split one after the other, and not half of each.
  struct Candidate
  {
    double key;
    Face_index face;
    Halfedge_index longest;

    // of equal ones the first
    bool operator<(const Candidate& other) const { return key < other.key || (key == other.key && other.face < face); }
  };
  // Splits make a face better only if its shortest edge, or the way from a corner to the middle of the longest edge, is not much
  // longer than the altitude. Others wait for their length.
  static constexpr double longest_way = 4; // in altitudes

public:
  explicit Face_splitter(Mesh& mesh) : m_mesh(mesh), m_subdivision(mesh, m_guard) {}

  void operator()(const double number_of_faces, Interruption& interruption)
  {
    for (const Face_index f : m_mesh.faces())
      add(f);
    while (!m_candidates.empty() && double(m_mesh.number_of_faces()) < number_of_faces && !interruption.poll())
    {
      const Candidate first = m_candidates.top();
      m_candidates.pop();
      if (first.key == candidate(first.face).key) // it was not split before
        split(first.longest);
    }
  }

private:
  Candidate candidate(const Face_index f) const
  {
    Candidate result{0, f, m_mesh.halfedge(f)};
    double longest = 0, shortest = (std::numeric_limits<double>::infinity)();
    for (const Halfedge_index h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
    {
      const double length = squared_length(h, m_mesh);
      shortest = (std::min)(shortest, length);
      if (!(length > longest))
        continue;
      longest = length;
      result.longest = h;
    }
    const Vector& opposite = m_mesh.point(m_mesh.target(m_mesh.next(result.longest))).point;
    const double way = std::sqrt((std::min)(shortest, (opposite - middle(result.longest, m_mesh)).squaredNorm())),
                 length = std::sqrt(longest), altitude = face_normal(m_mesh.halfedge(f), m_mesh).norm() / length;
    result.key = way < longest_way * altitude ? longest / altitude : length;
    return result;
  }

  void add(const Face_index f)
  {
    const Candidate c = candidate(f);
    if (m_mesh.arc(c.longest).curve != Curve_arc::untouchable)
      m_candidates.push(c);
  }

  void split(const Halfedge_index h)
  {
    typename Mesh::Vertex state;
    state.point = middle(h, m_mesh);
    state.input_vertex = std::uint32_t(m_mesh.num_vertices());
    const Vertex_index v = m_subdivision.split(h, state, typename Mesh::Sides());
    for (const Halfedge_index around : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (!m_mesh.is_border(around))
        add(m_mesh.face(around));
  }

  // nothing has to be told of a split
  struct No_guard
  {
    void update_around(Vertex_index) const {}
  };

  Mesh& m_mesh;
  const No_guard m_guard{};
  const Edge_subdivision<Mesh, No_guard> m_subdivision;
  std::priority_queue<Candidate> m_candidates;
};

template <typename Mesh>
void split_faces(Mesh& mesh, const double number_of_faces, Interruption& interruption)
{
  Face_splitter<Mesh> splitter(mesh);
  splitter(number_of_faces, interruption);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SPLIT_INPUT_H
