// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Element_figures.h"
#include "measure.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Zero_set_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hde_remesh {

namespace {

Hde::internal::Vector to_vector(const Point_3& p) { return Hde::internal::Vector(p.x(), p.y(), p.z()); }

// of a vertex
double distance(const Function_view::Piece& function, const Point_3& p, const double size)
{
  return Hde::internal::zero_set_distance(function, size)(to_vector(p));
}

// of the centroid of a face with the vertex v
double distance(const Function_view::Piece& function, const Point_3& p, const Point_3& v, const double size)
{
  return Hde::internal::zero_set_distance(function, size)(to_vector(p), to_vector(v), distance(function, v, size));
}

Vector_3 unit_normal(const Function_view::Piece& function, const Point_3& p)
{
  const Vector_3 gradient = function.gradient(p);
  const double slope = std::sqrt(gradient.squared_length());
  return slope > 0 ? gradient / slope : Vector_3(0, 0, 0);
}

// the least angle of a triangle with sides of these squared lengths, opposite to the shortest one
double smallest_angle(std::array<double, 3> squared_lengths)
{
  std::sort(squared_lengths.begin(), squared_lengths.end());
  const auto [a, b, c] = squared_lengths;
  if (!(a > 0))
    return 0;
  const double cosine = (b + c - a) / (2 * std::sqrt(b) * std::sqrt(c));
  return std::acos((std::max)(-1., (std::min)(1., cosine))) * 180 / CGAL_PI;
}

} // namespace

Element_figures figures_of_elements(const Mesh& mesh, const Function_view& function, const double sigma)
{
  Element_figures figures;
  const Creases creases = creases_of(mesh);
  const double size = diagonal(mesh);
  // of the face of h, or of that beyond it on the boundary
  const auto piece = [&](const Mesh::Halfedge_index h) -> const Function_view::Piece&
  { return function.piece(creases.region[mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h)]); };
  std::vector<std::size_t> numbers(mesh.num_vertices()); // removed ones included
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    numbers[v] = figures.normals.size();
    // a vertex on a crease has one value only here: that of one of its regions
    const Function_view::Piece& at_vertex = piece(mesh.halfedge(v));
    figures.normals.push_back(unit_normal(at_vertex, mesh.point(v)));
    figures.vertex_distances.push_back(distance(at_vertex, mesh.point(v), size));
  }
  const auto normal = [&](const Mesh::Vertex_index v, const Mesh::Halfedge_index h)
  { return &piece(h) == &piece(mesh.halfedge(v)) ? figures.normals[numbers[v]] : unit_normal(piece(h), mesh.point(v)); };
  const auto squared_length = [&](const Mesh::Halfedge_index h)
  {
    const Mesh::Vertex_index a = mesh.source(h), b = mesh.target(h);
    return CGAL::squared_distance(mesh.point(a), mesh.point(b)) +
           sigma * sigma * (normal(a, h) - normal(b, h)).squared_length();
  };
  for (const Mesh::Edge_index e : mesh.edges())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    figures.edge_lengths.push_back(std::sqrt((std::max)(squared_length(h), squared_length(mesh.opposite(h)))));
  }
  for (const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f), g = mesh.next(h), k = mesh.next(g);
    const Point_3 &a = mesh.point(mesh.target(h)), &b = mesh.point(mesh.target(g)), &c = mesh.point(mesh.target(k));
    figures.aspect_ratios.push_back(Hde::aspect_ratio(a, b, c));
    figures.smallest_angles.push_back(smallest_angle({squared_length(h), squared_length(g), squared_length(k)}));
    figures.face_distances.push_back(distance(piece(h), CGAL::centroid(a, b, c), a, size));
  }
  return figures;
}

void add_arrays(const Element_figures& figures, Soup& soup)
{
  Array x{"nx", {}}, y{"ny", {}}, z{"nz", {}};
  for (const Vector_3& normal : figures.normals)
  {
    x.values.push_back(normal.x());
    y.values.push_back(normal.y());
    z.values.push_back(normal.z());
  }
  soup.vertex_arrays = {x, y, z, {"distance", figures.vertex_distances}};
  soup.face_arrays = {{"aspect_ratio", figures.aspect_ratios},
                      {"smallest_angle_6d", figures.smallest_angles},
                      {"distance", figures.face_distances}};
}

} // namespace hde_remesh
