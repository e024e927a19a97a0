// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_PSEUDONORMAL_DISTANCE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_PSEUDONORMAL_DISTANCE_H

#include "common.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>

#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// The exact distance to a triangle mesh, with the sign of the side of the pseudonormal at the closest point: that of the
// face, or the sum of those of the faces at the edge, or at the vertex their sum weighted by angle. Written apart from the
// one of the function that it judges; only the search of the closest face is the same.
class Pseudonormal_distance
{
  static constexpr double on_edge = 1e-7; // of a barycentric coordinate

public:
  struct Answer
  {
    std::size_t face = 0;
    double distance = 0;         // negative inside
    bool is_on_boundary = false; // the closest point; then the sign says nothing
  };

  explicit Pseudonormal_distance(const Mesh& mesh) : m_mesh(mesh), m_closest_facet(m_points, m_facets)
  {
    for (const Mesh::Vertex_index v : mesh.vertices())
      m_points.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    for (const Mesh::Face_index f : mesh.faces())
    {
      const Mesh::Halfedge_index h = mesh.halfedge(f);
      m_halfedges.push_back({h, mesh.next(h), mesh.prev(h)});
      m_facets.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
      const Vector_3 area = area_vector(m_facets.size() - 1);
      const double length = std::sqrt(area.squared_length());
      m_normals.push_back(length > 0 ? area / length : Vector_3(0, 0, 0));
    }
  }

  Answer operator()(const Point_3& p) const
  {
    const Hde::internal::Closest_facet::Answer closest = m_closest_facet({p.x(), p.y(), p.z()});
    const std::array<Mesh::Halfedge_index, 3>& h = m_halfedges[closest.facet];
    std::vector<int> zeros; // the opposite corners of the edges that the point is on
    for (int k = 0; k < 3; ++k)
      if (closest.barycentric[k] < on_edge)
        zeros.push_back(k);
    Answer answer;
    answer.face = closest.facet;
    Vector_3 normal = m_normals[closest.facet];
    if (zeros.size() == 1)
    {
      const Mesh::Halfedge_index across = m_mesh.opposite(h[std::size_t(zeros[0] + 1) % 3]);
      answer.is_on_boundary = m_mesh.is_border(across);
      if (!answer.is_on_boundary)
        normal = normal + normal_of(across);
    }
    else if (zeros.size() == 2)
    {
      const Mesh::Vertex_index v = m_mesh.source(h[std::size_t(3 - zeros[0] - zeros[1])]);
      answer.is_on_boundary = m_mesh.is_border(v);
      normal = normal_of(v);
    }
    const Vector_3 out = p - Point_3(closest.point.x(), closest.point.y(), closest.point.z());
    answer.distance = std::sqrt(out.squared_length()) * (out * normal < 0 ? -1 : 1);
    return answer;
  }

  const Vector_3& normal(const std::size_t face) const { return m_normals[face]; }

  double edge_length(const std::size_t face) const // the mean
  {
    double sum = 0;
    for (const Mesh::Halfedge_index h : m_halfedges[face])
      sum += std::sqrt(CGAL::squared_distance(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h))));
    return sum / 3;
  }

  // with the barycentric coordinates 1 - u - v, u and v
  Point_3 point(const std::size_t face, const double u, const double v) const
  {
    return corner(face, 0) + u * (corner(face, 1) - corner(face, 0)) + v * (corner(face, 2) - corner(face, 0));
  }

  std::vector<double> areas() const
  {
    std::vector<double> result;
    for (std::size_t face = 0; face < m_facets.size(); ++face)
      result.push_back(0.5 * std::sqrt(area_vector(face).squared_length()));
    return result;
  }

private:
  const Point_3& corner(const std::size_t face, const std::size_t k) const
  {
    return m_mesh.point(m_mesh.source(m_halfedges[face][k]));
  }

  Vector_3 area_vector(const std::size_t face) const
  {
    return CGAL::cross_product(corner(face, 1) - corner(face, 0), corner(face, 2) - corner(face, 0));
  }

  // of its face
  const Vector_3& normal_of(const Mesh::Halfedge_index h) const { return m_normals[m_mesh.face(h)]; }

  Vector_3 normal_of(const Mesh::Vertex_index v) const
  {
    Vector_3 sum(0, 0, 0);
    for (const Mesh::Halfedge_index h : CGAL::halfedges_around_target(v, m_mesh))
    {
      if (m_mesh.is_border(h))
        continue;
      const Vector_3 in = m_mesh.point(m_mesh.source(h)) - m_mesh.point(v),
                     out = m_mesh.point(m_mesh.target(m_mesh.next(h))) - m_mesh.point(v);
      sum = sum + std::atan2(std::sqrt(CGAL::cross_product(in, out).squared_length()), in * out) * normal_of(h);
    }
    return sum;
  }

  const Mesh& m_mesh; // without removed elements: the indices count from 0
  std::vector<Hde::internal::Vector> m_points;
  std::vector<Hde::internal::Facet> m_facets;
  std::vector<std::array<Mesh::Halfedge_index, 3>> m_halfedges; // of a face, from its corners
  std::vector<Vector_3> m_normals;
  Hde::internal::Closest_facet m_closest_facet;
};

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_PSEUDONORMAL_DISTANCE_H
