// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_TWO_SIDED_CHECK_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_TWO_SIDED_CHECK_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Distance_check.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Space_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Whether the mesh and the input stay within a distance of each other, for certain: all of their facets, both ways.
template <typename ConcurrencyTag, typename Mesh>
class Two_sided_check
{
public:
  // a face that is too far from the input, or the input from it: where on the face, and the place on the input
  struct Failing_face
  {
    Face_index face;
    Space_triangle triangle;
    double distance;
    Vector point, place;
  };

  Two_sided_check(const Mesh& mesh, const Input_surface& input, Interruption& interruption)
    : m_mesh(mesh), m_input(input), m_interruption(interruption)
  {
  }

  // Returns the faces that fail, each once, in the order of the mesh. What has passed before is not looked at again as long as the
  // faces that it depends on are the same. So all calls must have the same limit.
  std::vector<Failing_face> operator()(const double limit)
  {
    m_failing.clear();
    load_mesh();
    const Closest_facet search_in_mesh(m_points, m_facets);
    if (m_input.empty() || search_in_mesh.empty())
      return m_failing;
    const Distance_check to_input(m_input.points(), m_input.facets(), m_input.closest_facet());
    std::vector<Record> from_mesh(m_facets.size());
    for (std::size_t i = 0; i < m_facets.size(); ++i)
      if (!m_is_changed[m_faces[i]])
        from_mesh[i] = m_from_mesh[m_faces[i]];
    check(to_input, m_points, m_facets, limit, from_mesh,
          [&](const std::size_t i, const Distance_check::Place& place) {
            return Failing_face{m_faces[i], triangle(i), place.distance, place.point, m_input.closest(place.point).point};
          });
    m_from_mesh.assign(face_capacity(m_mesh), Record());
    for (std::size_t i = 0; i < m_facets.size(); ++i)
      m_from_mesh[m_faces[i]] = from_mesh[i];
    m_from_input.resize(m_input.facets().size());
    for (Record& record : m_from_input)
      for (const Face_index f : record.faces)
        record.is_within = record.is_within && !m_is_changed[f];
    const Distance_check to_mesh(m_points, m_facets, search_in_mesh);
    check(to_mesh, m_input.points(), m_input.facets(), limit, m_from_input,
          [&](std::size_t, const Distance_check::Place& place)
          {
            const Space_triangle t = triangle(place.facet);
            return Failing_face{m_faces[place.facet], t, place.distance, t.point(t.closest(place.point).barycentric),
                                place.point};
          });
    m_bound = 0;
    for (const Record& record : from_mesh)
      m_bound = (std::max)(m_bound, record.bound);
    for (const Record& record : m_from_input)
      m_bound = (std::max)(m_bound, record.bound);
    if (m_interruption.is_requested())
      m_bound = (std::numeric_limits<double>::infinity)();
    keep_farthest_of_each_face();
    return m_failing;
  }

  // No distance is above: at most the limit if no face failed.
  double bound() const { return m_bound; }

private:
  // what is known of a facet
  struct Record
  {
    bool is_within = false;
    double bound = 0;
    boost::container::small_vector<Face_index, 4> faces; // of the mesh, if it depends on others than the facet itself
  };

  void load_mesh()
  {
    m_points.assign(vertex_capacity(m_mesh), Vector::Zero());
    for (const Vertex_index v : m_mesh.vertices())
      m_points[v] = m_mesh.point(v).point;
    m_facets.clear();
    m_faces.clear();
    m_corners.resize(face_capacity(m_mesh));
    m_is_changed.assign(face_capacity(m_mesh), 1);
    for (const Face_index f : m_mesh.faces())
    {
      const Triangle t(m_mesh.halfedge(f), m_mesh);
      m_facets.push_back(Facet{t.a, t.b, t.c});
      m_faces.push_back(f);
      const std::array<Vector, 3> corners{m_points[t.a], m_points[t.b], m_points[t.c]};
      m_is_changed[f] = m_from_mesh.empty() || corners != m_corners[f];
      m_corners[f] = corners;
    }
    m_from_mesh.resize(face_capacity(m_mesh));
  }

  Space_triangle triangle(const std::size_t i) const
  {
    const Facet& facet = m_facets[i];
    return Space_triangle{m_points[facet[0]], m_points[facet[1]], m_points[facet[2]]};
  }

  // looks at the facets of which it is not known that they are within the limit
  template <typename FailingFace>
  void check(const Distance_check& within, const std::vector<Vector>& points, const std::vector<Facet>& facets,
             const double limit, std::vector<Record>& records, const FailingFace& failing_face)
  {
    std::vector<std::size_t> open;
    std::vector<char> is_needed(points.size(), 0);
    for (std::size_t i = 0; i < facets.size(); ++i)
      if (!records[i].is_within)
      {
        open.push_back(i);
        for (const std::size_t v : facets[i])
          is_needed[v] = 1;
      }
    std::vector<Distance_check::Place> places(points.size());
    parallel_for<ConcurrencyTag>(
        points.size(),
        [&](const std::size_t i)
        {
          if (is_needed[i])
            places[i] = within.look_at(points[i]);
        },
        64, m_interruption);
    if (m_interruption.is_requested())
      return;
    std::vector<Distance_check::Answer> answers(open.size());
    parallel_for<ConcurrencyTag>(
        open.size(),
        [&](const std::size_t k)
        {
          const Facet& facet = facets[open[k]];
          answers[k] = within({places[facet[0]], places[facet[1]], places[facet[2]]}, limit);
        },
        16, m_interruption);
    if (m_interruption.is_requested())
      return;
    for (std::size_t k = 0; k < open.size(); ++k)
    {
      const Distance_check::Answer& answer = answers[k];
      Record& record = records[open[k]];
      record = Record{answer.is_within, answer.bound, {}};
      if (!answer.is_within)
        m_failing.push_back(failing_face(open[k], answer.farthest));
      else if (&records == &m_from_input)
        for (const std::size_t i : answer.facets)
          record.faces.push_back(m_faces[i]);
    }
  }

  void keep_farthest_of_each_face()
  {
    std::stable_sort(m_failing.begin(), m_failing.end(),
                     [](const Failing_face& f, const Failing_face& g)
                     { return f.face < g.face || (f.face == g.face && f.distance > g.distance); });
    m_failing.erase(std::unique(m_failing.begin(), m_failing.end(),
                                [](const Failing_face& f, const Failing_face& g) { return f.face == g.face; }),
                    m_failing.end());
  }

  const Mesh& m_mesh;
  const Input_surface& m_input;
  Interruption& m_interruption;
  std::vector<Vector> m_points; // of the mesh
  std::vector<Facet> m_facets;
  std::vector<Face_index> m_faces;               // of the facets
  std::vector<std::array<Vector, 3>> m_corners;  // by face, when it was last looked at
  std::vector<char> m_is_changed;                // since then
  std::vector<Record> m_from_mesh, m_from_input; // by face of the mesh, and by facet of the input
  std::vector<Failing_face> m_failing;
  double m_bound = 0;
};

// a bound on all distances between the mesh and the input, at most half as large again as they are; at least `limit`
template <typename ConcurrencyTag, typename Mesh>
double bound_on_distance(const Mesh& mesh, const Input_surface& input, double limit, Interruption& interruption)
{
  for (;; limit *= 1.5)
  {
    Two_sided_check<ConcurrencyTag, Mesh> check(mesh, input, interruption);
    const bool is_within = check(limit).empty();
    if (is_within || !std::isfinite(check.bound()))
      return check.bound();
  }
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_TWO_SIDED_CHECK_H
