// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_LANDMARK_GUARD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_LANDMARK_GUARD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/closest_on_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Simultaneous_moves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/expected_heights.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Nothing is lost: the vertices of the mesh as it was before the first operation are landmarks. Each belongs to a face nearby. No
// operation may take a landmark further from the faces around than the heights expected there explain, unless it was as far before.
// So no ear is cut off.
template <typename Mesh>
class Landmark_guard
{
  typedef Local_change<Mesh> Change;

  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  static constexpr int largest_number_of_steps = 64;
  static constexpr int largest_number_of_rounds = 20; // of moves that are taken back
  // Over the height that is expected of an edge there. The centroid of an equilateral face is 4/3 of it off, and some edges are
  // longer. After a contraction flips and moves follow.
  static constexpr double largest_ratio = 2, largest_ratio_of_contraction = 3;
  // A contraction in a regular mesh leaves the middle of six equilateral faces 4 times the height off.
  static constexpr double largest_ratio_in_regular_mesh = 5;
  // Over the root mean square of all heights: where the surface is flatter, this counts.
  static constexpr double largest_ratio_to_mean = 1.5;
  // Over the diagonal. Flat sides have no heights, but functions and points are rounded.
  static constexpr double largest_rounding = 1e-6;

  struct Landmark
  {
    Vector point;
    double height; // that is expected there, before it is scaled
    Face_index face;
    std::uint32_t next; // of the same face
    bool is_settled;    // whether the face will be the nearest one after the moves
  };

public:
  // The vertices that lie on the surface are the landmarks. `diagonal` is that of the mesh.
  Landmark_guard(const Mesh& mesh, const Expected_heights& heights, const double diagonal)
    : m_mesh(mesh), m_mean_height(heights.mean), m_rounding(largest_rounding * diagonal)
  {
    for (const Vertex_index v : mesh.vertices())
    {
      const Halfedge_index h = mesh.halfedge(v);
      if (!mesh.point(v).is_on_input && !mesh.point(v).is_predicted())
        m_landmarks.push_back(Landmark{mesh.point(v).point, heights.at_vertices[v],
                                       mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h), none, false});
    }
    link_all();
  }

  // the heights are the first ones times this factor
  void scale(const double factor) { m_scale = factor; }

  // whether contractions are needed where the mesh is regular
  void expect_regular_mesh(const bool is_expected) { m_is_regular = is_expected; }

  // a subdivision cuts nothing off
  bool accepts(const Change& change) const
  {
    if (change.kind() == Change_kind::SUBDIVISION)
      return true;
    const double ratio = ratio_of(change);
    for (const Face_index f : change.old_faces())
      for (std::uint32_t i = m_first[f]; i != none; i = m_landmarks[i].next)
        if (!stays_near(m_landmarks[i], largest_square(m_landmarks[i], ratio), change))
          return false;
    return true;
  }

  // hands the landmarks of faces that an operation has changed or removed over to those of them that are left
  template <typename Faces>
  void update(const Faces& faces)
  {
    m_first.resize(face_capacity(m_mesh), none);
    m_taken.clear();
    for (const Face_index f : faces)
    {
      for (std::uint32_t i = m_first[f]; i != none; i = m_landmarks[i].next)
        m_taken.push_back(i);
      m_first[f] = none;
    }
    for (const std::uint32_t i : m_taken)
    {
      double least = (std::numeric_limits<double>::infinity)();
      for (const Face_index f : faces)
        if (!m_mesh.is_removed(f))
        {
          const double square = closest(m_landmarks[i], f).squared_distance;
          if (!(square < least))
            continue;
          least = square;
          m_landmarks[i].face = f;
        }
      link(i);
    }
  }

  // Finds the nearest face of each landmark by walking from the one it belongs to. Is called after vertices have moved.
  template <typename ConcurrencyTag>
  void walk()
  {
    parallel_for<ConcurrencyTag>(m_landmarks.size(), [&](const std::size_t i) { walk(m_landmarks[i]); });
    link_all();
  }

  // is called after faces have got other numbers; `new_faces` has these by the old ones
  void renumber(const std::vector<Face_index>& new_faces)
  {
    for (Landmark& landmark : m_landmarks)
      landmark.face = new_faces[landmark.face];
    link_all();
  }

  // Takes moves back until no landmark is too far. Where one is, the corners of its face stay.
  template <typename ConcurrencyTag>
  void revert(Simultaneous_moves<Mesh>& moves, Interruption& interruption)
  {
    std::vector<Face_index> left = left_faces<ConcurrencyTag>(moves);
    for (int round = 0; round < largest_number_of_rounds && !left.empty() && !interruption.is_requested(); ++round)
      left = left_faces_around(moves.revert(std::move(left)), moves);
  }

private:
  double ratio_of(const Change& change) const
  {
    const bool is_contraction = change.new_faces().size() < change.old_faces().size();
    return !is_contraction ? largest_ratio : m_is_regular ? largest_ratio_in_regular_mesh : largest_ratio_of_contraction;
  }

  // of its distance
  double largest_square(const Landmark& landmark, const double ratio) const
  {
    const double largest = m_rounding + m_scale * (std::max)(ratio * landmark.height, largest_ratio_to_mean * m_mean_height);
    return largest * largest;
  }

  void link(const std::uint32_t i)
  {
    m_landmarks[i].next = m_first[m_landmarks[i].face];
    m_first[m_landmarks[i].face] = i;
  }

  void link_all()
  {
    m_first.assign(face_capacity(m_mesh), none);
    for (std::size_t i = m_landmarks.size(); i-- > 0;)
      link(std::uint32_t(i));
  }

  Closest_on_triangle closest(const Landmark& landmark, const Face_index f) const
  {
    const Triangle t(m_mesh.halfedge(f), m_mesh);
    return closest_on_triangle(landmark.point, m_mesh.point(t.a).point, m_mesh.point(t.b).point, m_mesh.point(t.c).point);
  }

  // after the moves
  Closest_on_triangle closest(const Landmark& landmark, const Face_index f, const Simultaneous_moves<Mesh>& moves) const
  {
    const Triangle t(m_mesh.halfedge(f), m_mesh);
    return closest_on_triangle(landmark.point, moves.state(t.a).point, moves.state(t.b).point, moves.state(t.c).point);
  }

  static bool is_inside(const Closest_on_triangle& closest) { return closest.barycentric.minCoeff() > 0; }

  // whether a landmark of an old face is near one of the new ones, or as near as it was
  bool stays_near(const Landmark& landmark, const double largest, const Change& change) const
  {
    double after = (std::numeric_limits<double>::infinity)();
    for (const auto& face : change.new_faces())
    {
      const auto& c = face.corners;
      after = (std::min)(
          after, closest_on_triangle(landmark.point, c[0].state->point, c[1].state->point, c[2].state->point).squared_distance);
      if (after <= largest)
        return true;
    }
    return after <= closest(landmark, landmark.face).squared_distance;
  }

  // From face to face as long as the distance becomes less. Inside of a face it is the least one nearby.
  void walk(Landmark& landmark) const
  {
    if (std::exchange(landmark.is_settled, false))
      return;
    Closest_on_triangle nearest = closest(landmark, landmark.face);
    for (int step = 0; step < largest_number_of_steps && !is_inside(nearest); ++step)
    {
      const Face_index from = landmark.face;
      for_each_face_around(from,
                           [&](const Face_index f)
                           {
                             const Closest_on_triangle other = closest(landmark, f);
                             if (!(other.squared_distance < nearest.squared_distance))
                               return;
                             nearest = other;
                             landmark.face = f;
                           });
      if (landmark.face == from)
        break;
    }
  }

  // visits the faces that share a vertex with f, those beyond its edges twice
  template <typename Visit>
  void for_each_face_around(const Face_index f, const Visit& visit) const
  {
    for (const Halfedge_index corner : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
      for (const Halfedge_index h : m_mesh.halfedges_around_target(corner))
        if (!m_mesh.is_border(h) && m_mesh.face(h) != f)
          visit(m_mesh.face(h));
  }

  // the faces of the landmarks that the moves leave too far behind
  template <typename ConcurrencyTag>
  std::vector<Face_index> left_faces(const Simultaneous_moves<Mesh>& moves)
  {
    std::vector<char> is_left(m_landmarks.size(), 0);
    parallel_for<ConcurrencyTag>(m_landmarks.size(),
                                 [&](const std::size_t i) { is_left[i] = is_left_behind(m_landmarks[i], moves); });
    std::vector<Face_index> result;
    for (std::size_t i = 0; i < is_left.size(); ++i)
      if (is_left[i])
        result.push_back(m_landmarks[i].face);
    return result;
  }

  // the same where these vertices have been taken back: their faces, and the faces around these
  std::vector<Face_index> left_faces_around(const std::vector<Vertex_index>& vertices, const Simultaneous_moves<Mesh>& moves)
  {
    std::vector<char> is_added(face_capacity(m_mesh), 0);
    std::vector<Face_index> faces;
    const auto add = [&](const Face_index f)
    {
      if (!std::exchange(is_added[f], 1))
        faces.push_back(f);
    };
    for (const Vertex_index v : vertices)
      for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        if (!m_mesh.is_border(h))
          add(m_mesh.face(h));
    for (std::size_t i = 0, n = faces.size(); i < n; ++i)
      for_each_face_around(faces[i], add);
    std::sort(faces.begin(), faces.end());
    std::vector<Face_index> result;
    for (const Face_index f : faces)
      for (std::uint32_t i = m_first[f]; i != none; i = m_landmarks[i].next)
        if (is_left_behind(m_landmarks[i], moves))
          result.push_back(f);
    return result;
  }

  bool is_left_behind(Landmark& landmark, const Simultaneous_moves<Mesh>& moves) const
  {
    const double largest = largest_square(landmark, largest_ratio);
    const Closest_on_triangle after = closest(landmark, landmark.face, moves);
    landmark.is_settled = is_inside(after);
    if (after.squared_distance <= largest)
      return false;
    double least = after.squared_distance;
    for_each_face_around(landmark.face,
                         [&](const Face_index f) { least = (std::min)(least, closest(landmark, f, moves).squared_distance); });
    return least > (std::max)(largest, closest(landmark, landmark.face).squared_distance);
  }

  const Mesh& m_mesh;
  std::vector<Landmark> m_landmarks;
  std::vector<std::uint32_t> m_first; // by face
  std::vector<std::uint32_t> m_taken; // of an update
  const double m_mean_height, m_rounding;
  double m_scale = 1;
  bool m_is_regular = false;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_LANDMARK_GUARD_H
