// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What is promised of a mesh that was remeshed with creases: these and its regions are as before, and so is all else that is
// promised of every mesh.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CREASE_CHECKS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CREASE_CHECKS_H

#include "creases.h"
#include "promises.h"
#include "remeshing_checks.h"

#include <CGAL/Anisotropic_hde_remeshing/Surface_regions.h>
#include <CGAL/Piecewise_rbf_implicit_function.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace crease_checks {

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
// that of the one call, which is thus compiled but once
typedef CGAL::Piecewise_rbf_implicit_function<CGAL::Simple_cartesian<double>, CGAL::Polyharmonic_rbf, Tag> Function;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Creases;
typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Regions;
typedef Mesh::Property_map<Mesh::Vertex_index, bool> Fixed;

// the maps of a mesh, which its copies have, too
inline Creases creases_of(Mesh& mesh) { return mesh.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first; }
inline Regions regions_of(Mesh& mesh) { return mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region", 0).first; }
inline Fixed fixed_of(Mesh& mesh) { return mesh.add_property_map<Mesh::Vertex_index, bool>("v:fixed", false).first; }

template <typename AnyFunction>
struct Remeshing
{
  Mesh before, after; // with their maps
  AnyFunction function;
  Hde::Remeshing_result result;
};

// the regions between sharp edges and those that are marked already
inline Function detect(Mesh& mesh, const double angle)
{
  const Creases creases = creases_of(mesh);
  Hde::detect_surface_regions(mesh, creases, regions_of(mesh), params::sharp_angle(angle).edge_is_constrained_map(creases));
  return Function(mesh, regions_of(mesh));
}

// how far the part of a polyline that an edge stands for may be from it, as a share of the diagonal
constexpr double largest_deviation = 5e-5;

// of the boundary, too
inline std::set<Mesh::Vertex_index> vertices_on_curves(Mesh& mesh)
{
  std::set<Mesh::Vertex_index> result;
  for (const Mesh::Edge_index e : mesh.edges())
    if (creases_of(mesh)[e] || mesh.is_border(e))
      result.insert({mesh.vertex(e, 0), mesh.vertex(e, 1)});
  return result;
}

// a piece, as a function of the points of the mesh
template <typename AnyFunction>
struct Piece
{
  typedef std::decay_t<decltype(std::declval<AnyFunction>().piece(0))> Function;
  const Function& function;

  Piece(const AnyFunction& f, const std::size_t region) : function(f.piece(region)) {}
  double operator()(const Point_3& p) const { return function(to_point(p)); }
  auto gradient(const Point_3& p) const { return function.gradient(to_point(p)); }

private:
  static auto to_point(const Point_3& p) { return typename Function::Point_3(p.x(), p.y(), p.z()); }
};

// of the vertices that are on no curve, nor fixed, from the zero sets of their own pieces
template <typename AnyFunction>
promises::Number_off_surface number_off_surface(Mesh& mesh, const AnyFunction& function, const double diagonal)
{
  const std::set<Mesh::Vertex_index> on_curves = vertices_on_curves(mesh);
  return promises::number_off_surface(
      mesh, diagonal, [&](const Mesh::Vertex_index v) { return on_curves.count(v) == 0 && !fixed_of(mesh)[v]; },
      [&](const Mesh::Vertex_index v) { return Piece<AnyFunction>(function, regions_of(mesh)[mesh.face(mesh.halfedge(v))]); });
}

// that vertices on curves between two regions, but those on the boundary, are where the pieces of both vanish
template <typename AnyFunction>
void check_creases_on_surface(Remeshing<AnyFunction>& r)
{
  const double distance = promises::largest_distance * bounding_box_diagonal(r.before);
  std::size_t number = 0, number_off = 0;
  for (const Mesh::Vertex_index v : vertices_on_curves(r.after))
    if (!r.after.is_border(v))
      for (const Mesh::Face_index f : r.after.faces_around_target(r.after.halfedge(v)))
      {
        ++number;
        number_off +=
            promises::is_within(distance, Piece<AnyFunction>(r.function, regions_of(r.after)[f]), r.after.point(v)) ? 0 : 1;
      }
  CHECK(number > 0);
  CHECK(number_off == 0);
}

// by region: its vertices
inline std::map<std::size_t, std::set<Mesh::Vertex_index>> vertices_of_regions(Mesh& mesh)
{
  std::map<std::size_t, std::set<Mesh::Vertex_index>> result;
  for (const Mesh::Face_index f : mesh.faces())
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      result[regions_of(mesh)[f]].insert(v);
  return result;
}

// by region: its Euler characteristic
inline std::map<std::size_t, std::ptrdiff_t> topology_of_regions(Mesh& mesh)
{
  const Regions regions = regions_of(mesh);
  std::map<std::size_t, std::ptrdiff_t> result;
  for (const auto& region : vertices_of_regions(mesh))
    result[region.first] = std::ptrdiff_t(region.second.size());
  for (const Mesh::Face_index f : mesh.faces())
    ++result[regions[f]];
  for (const Mesh::Edge_index e : mesh.edges())
  {
    std::set<std::size_t> sides;
    for (const Mesh::Halfedge_index h : {mesh.halfedge(e), mesh.opposite(mesh.halfedge(e))})
      if (!mesh.is_border(h))
        sides.insert(regions[mesh.face(h)]);
    for (const std::size_t region : sides)
      --result[region];
  }
  return result;
}

inline double length(const creases::Segments& segments)
{
  double sum = 0;
  for (const Kernel::Segment_3& s : segments)
    sum += std::sqrt(s.squared_length());
  return sum;
}

inline void check_curves(Mesh& mesh, const Hde::Feature_curves& curves)
{
  CHECK(curves.number_of_corners == creases::corners(mesh, creases_of(mesh)).size());
  const double sum = length(creases::segments(mesh, creases_of(mesh)));
  CHECK_CLOSE(curves.length, sum, 1e-10 * sum);
}

// `deviation` of the creases from those of the input, as a share of the diagonal; whether all vertices reach the surface
template <typename AnyFunction>
void check(const std::string& name, Remeshing<AnyFunction>& r, const double deviation = largest_deviation,
           const bool reaches_surface = true)
{
  const double diagonal = bounding_box_diagonal(r.before);
  const creases::Segments before = creases::segments(r.before, creases_of(r.before)),
                          after = creases::segments(r.after, creases_of(r.after));
  const double forth = creases::largest_distance(after, before) / diagonal,
               back = creases::largest_distance(before, after) / diagonal;
  const auto np = params::face_patch_map(regions_of(r.after));
  const std::size_t folds = Hde::measure_embedding(r.after, r.function, np).number_of_folded_faces;
  const promises::Number_off_surface off_surface = number_off_surface(r.after, r.function, diagonal);
  const std::string broken = promises::broken(r.before, r.after, off_surface, r.result, true);
  std::cout << name << ": " << r.after.number_of_faces() << " faces, " << r.result.number_of_regions << " regions, "
            << r.result.curves_before.number_of_curves << " curves, " << r.result.curves_before.number_of_corners
            << " corners, creases/D " << forth << " and " << back << ", vertices off the surface " << off_surface.least
            << ", folds " << folds << std::endl;
  if (!CHECK(broken.empty()))
    std::cerr << "  " << name << ": " << broken << std::endl;
  CHECK(!reaches_surface || off_surface.most == 0);
  CHECK(folds == 0);
  CHECK(forth <= deviation + 1e-12);
  CHECK(back <= deviation + 1e-12);
  CHECK(creases::number_of_missing_points(creases::corners(r.before, creases_of(r.before)), r.after) == 0);
  CHECK(r.result.number_of_regions == r.function.number_of_pieces());
  CHECK(topology_of_regions(r.before) == topology_of_regions(r.after));
  CHECK(r.result.curves_before.number_of_curves == r.result.curves_after.number_of_curves);
  check_curves(r.before, r.result.curves_before);
  check_curves(r.after, r.result.curves_after);
}

// pieces of a user's own: the cylinder of radius 1, and the planes z = -1 and z = 1
struct Can_function
{
  struct Piece
  {
    typedef Kernel::FT FT;
    typedef shapes::Point_3 Point;
    typedef shapes::Point_3 Point_3;
    typedef shapes::Vector_3 Vector_3;

    double side = 0; // of the plane; 0 is the cylinder

    FT operator()(const Point_3& p) const { return side == 0 ? std::hypot(p.x(), p.y()) - 1 : side * p.z() - 1; }
    Vector_3 gradient(const Point_3& p) const
    {
      return side == 0 ? Vector_3(p.x(), p.y(), 0) / std::hypot(p.x(), p.y()) : Vector_3(0, 0, side);
    }
  };

  std::size_t number_of_pieces() const { return 3; }
  const Piece& piece(const std::size_t i) const
  {
    static const Piece pieces[] = {Piece{0}, Piece{-1}, Piece{1}};
    return pieces[i];
  }
};

// a closed cylinder from z = -1 to 1 with the pieces of its faces
inline Mesh can(Mesh mesh)
{
  const Regions regions = regions_of(mesh);
  const Creases creases = creases_of(mesh);
  for (const Mesh::Face_index f : mesh.faces())
  {
    double z = 0;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      z += mesh.point(v).z() / 3;
    regions[f] = std::abs(z) < 1 - 1e-9 ? 0 : z < 0 ? 1 : 2;
  }
  for (const Mesh::Edge_index e : mesh.edges())
    creases[e] = regions[mesh.face(mesh.halfedge(e))] != regions[mesh.face(mesh.opposite(mesh.halfedge(e)))];
  return mesh;
}

inline Mesh can(const unsigned int segments, const unsigned int rows) { return can(capped_cylinder(segments, rows)); }

} // namespace crease_checks

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CREASE_CHECKS_H
