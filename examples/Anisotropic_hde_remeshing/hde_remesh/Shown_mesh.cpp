// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Shown_mesh.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_traits_3.h>
#else
#  include <CGAL/AABB_traits.h>
#endif

#include <numeric>

namespace hde_remesh {

namespace {

// a stop predicate of CGAL's, whose own have other names in other versions
class Few_edges
{
public:
  explicit Few_edges(const std::size_t number) : m_number(number) {}

  template <typename Cost, typename Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, const std::size_t current_number) const
  {
    return current_number <= m_number;
  }

private:
  std::size_t m_number;
};

std::vector<std::size_t> nearest_faces(const Mesh& simplified, const Mesh& mesh)
{
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  typedef CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>> Tree;
#else
  typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;
#endif
  std::vector<std::size_t> numbers(mesh.num_faces());
  std::size_t number = 0;
  for (const Mesh::Face_index f : mesh.faces())
    numbers[f] = number++;
  Tree tree(mesh.faces().begin(), mesh.faces().end(), mesh);
  tree.accelerate_distance_queries();
  std::vector<std::size_t> result;
  for (const Mesh::Face_index f : simplified.faces())
  {
    const Mesh::Halfedge_index h = simplified.halfedge(f);
    const Point_3 centroid = CGAL::centroid(simplified.point(simplified.source(h)), simplified.point(simplified.target(h)),
                                            simplified.point(simplified.target(simplified.next(h))));
    result.push_back(numbers[tree.closest_point_and_primitive(centroid).second]);
  }
  return result;
}

} // namespace

Shown_mesh shown_mesh(const Mesh& mesh, const std::size_t largest_number_of_faces)
{
  Shown_mesh result;
  result.number_of_faces = mesh.number_of_faces();
  if (result.number_of_faces <= largest_number_of_faces)
  {
    result.soup = soup_of_mesh(mesh);
    result.origins.resize(result.number_of_faces);
    std::iota(result.origins.begin(), result.origins.end(), std::size_t(0));
    return result;
  }
  Mesh simplified = mesh;
  CGAL::Surface_mesh_simplification::edge_collapse(simplified, Few_edges(largest_number_of_faces * 3 / 2));
  result.soup = soup_of_mesh(simplified);
  result.origins = nearest_faces(simplified, mesh);
  return result;
}

} // namespace hde_remesh
