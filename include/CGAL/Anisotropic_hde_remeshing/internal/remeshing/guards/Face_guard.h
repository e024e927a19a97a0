// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_FACE_GUARD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_FACE_GUARD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// How a face lies on the surface, and whether it is flat in space. A flat face is a cap, with an angle of nearly 180 degrees,
// or a sliver, with next to no height. The shape in the embedding does not matter.
struct Face_quality
{
  // least cosine between the normals of a face and of the surface at its vertices; below it the face is folded
  static constexpr double smallest_cosine = 0.2;
  // cosine of 175 degrees: a face with a larger angle in space is a cap
  static constexpr double smallest_angle_cosine = -0.9961946980917455;
  // of the height over the longest edge: below the first a face is a sliver, below the second it is degenerate
  static constexpr double sliver_height = 1e-4, degenerate_height = 1e-10;

  double cosine; // between the normal of the face and the sum of the normals of its vertices; -1 if it is degenerate
  double height; // over the longest edge if the face is a cap or a sliver, 0 if it is degenerate; 1 for all others
  bool is_cap;

  Face_quality(const Vertex_state& a, const Vertex_state& b, const Vertex_state& c)
  {
    const Vector ab = b.point - a.point, bc = c.point - b.point, ca = a.point - c.point;
    const Vector area = ca.cross(ab);
    const double squared_area = area.squaredNorm();
    const double aa = bc.squaredNorm(), bb = ca.squaredNorm(), cc = ab.squaredNorm();
    const double longest = (std::max)({aa, bb, cc});
    is_cap = has_large_angle(aa, bb, cc, longest);
    height = 1;
    if (is_cap || !(squared_area > sliver_height * sliver_height * longest * longest))
      height = std::sqrt(squared_area) / longest;
    if (!(height > degenerate_height)) // true for NaN, too
    {
      height = 0;
      cosine = -1;
      return;
    }
    const Vector normals = a.normal + b.normal + c.normal;
    cosine = area.dot(normals) / std::sqrt(squared_area * (std::max)(normals.squaredNorm(), 1e-300));
  }

  bool is_degenerate() const { return height == 0; }
  bool is_sliver() const { return height < sliver_height; }
  bool is_flat() const { return height < 1; }
  bool is_good() const { return cosine >= smallest_cosine && !is_flat(); }

  // takes the worse of both in each respect
  Face_quality& combine(const Face_quality& other)
  {
    cosine = (std::min)(cosine, other.cosine);
    height = (std::min)(height, other.height);
    is_cap = is_cap || other.is_cap;
    return *this;
  }

private:
  // the largest angle is opposite to the longest edge
  static bool has_large_angle(const double aa, const double bb, const double cc, const double longest)
  {
    const double product = aa == longest ? bb * cc : bb == longest ? aa * cc : aa * bb;
    const double cosine_times_lengths = 0.5 * (aa + bb + cc - 2 * longest);
    return cosine_times_lengths < 0 &&
           cosine_times_lengths * cosine_times_lengths > smallest_angle_cosine * smallest_angle_cosine * product;
  }
};

// Whether a face is worse than the other face whose place it takes. A degenerate face is never allowed. A fold and a flat face are
// allowed if the other face was no better. How a flat face lies counts for nothing: any fold may take its place.
inline bool is_folded_by(const Face_quality& after, const Face_quality& before)
{
  if (after.is_degenerate())
    return true;
  return after.cosine < Face_quality::smallest_cosine && after.cosine < (before.is_flat() ? -1 : before.cosine);
}

inline bool is_flattened_by(const Face_quality& after, const Face_quality& before)
{
  return after.is_flat() && after.height < before.height;
}

// the guard of the single faces of a change
template <typename Mesh>
class Face_guard
{
  typedef Local_change<Mesh> Change;
  typedef typename Change::New_face New_face;

public:
  explicit Face_guard(const Mesh& mesh) : m_mesh(mesh) {}

  // Along a facet that is long and exact, caps may be all that there is on the way to fewer faces.
  void allow_caps(const bool is_allowed) { m_allows_caps = is_allowed; }

  bool accepts(const Change& change) const
  {
    for (const New_face& face : change.new_faces())
    {
      const Face_quality after(*face.corners[0].state, *face.corners[1].state, *face.corners[2].state);
      if (!after.is_good() &&
          !(change.kind() == Change_kind::SUBDIVISION ? accepts_part(face, after) : accepts_other(face, after, change)))
        return false;
    }
    return true;
  }

private:
  bool accepts_other(const New_face& face, const Face_quality& after, const Change& change) const
  {
    const Face_quality before = face.old_face.is_valid() ? quality(face.old_face) : worst_quality(change.old_faces());
    return !is_folded_by(after, before) && ((m_allows_caps && !after.is_sliver()) || !is_flattened_by(after, before));
  }

  // A part of a face may be a cap if a flip can mend it. The halves of a needle are caps, and nothing but subdivisions leads
  // from a needle to good triangles. A part may not be a sliver or degenerate: there would be two such faces in place of one.
  bool accepts_part(const New_face& face, const Face_quality& after) const
  {
    if (after.is_sliver() || (after.is_cap && !is_flippable(face)))
      return false;
    return after.cosine >= Face_quality::smallest_cosine || after.cosine >= quality(face.old_face).cosine;
  }

  // whether the longest edge of a part of a face was an edge of the face and is on no curve
  bool is_flippable(const New_face& face) const
  {
    std::size_t longest = 0;
    double squared_length = -1;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double length = (face.corners[k].state->point - face.corners[(k + 1) % 3].state->point).squaredNorm();
      if (length > squared_length)
      {
        squared_length = length;
        longest = k;
      }
    }
    for (const Halfedge_index h : m_mesh.halfedges_around_face(m_mesh.halfedge(face.old_face)))
      if (m_mesh.source(h) == face.corners[longest].vertex && m_mesh.target(h) == face.corners[(longest + 1) % 3].vertex)
        return !m_mesh.is_on_curve(m_mesh.edge(h));
    return false;
  }

  template <typename Faces>
  Face_quality worst_quality(const Faces& faces) const
  {
    Face_quality result = quality(faces.front());
    for (const Face_index f : faces)
      result.combine(quality(f));
    return result;
  }

  Face_quality quality(const Face_index f) const
  {
    const Corners<Mesh> t(m_mesh.halfedge(f), m_mesh);
    return Face_quality(t.a, t.b, t.c);
  }

  const Mesh& m_mesh;
  bool m_allows_caps = false;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_FACE_GUARD_H
