// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_REGION_REMESHER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_REGION_REMESHER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Cell_functions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Mesh_of_piece.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_faces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/embedded_triangle.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Real_timer.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// what was done in a piece or region; sums over several
struct Region_report
{
  std::uint64_t number_of_faces_before = 0, number_of_faces = 0;
  std::uint64_t number_of_unprojected_vertices = 0, number_of_closest_points = 0;
  std::uint64_t number_of_self_intersections_before = 0, number_of_self_intersections = 0;
  std::uint64_t number_of_cells_built = 0;
  std::uint64_t number_of_thin_faces = 0; // that the last round left
  double function_seconds = 0, remeshing_seconds = 0;

  void add(const Region_report& r)
  {
    number_of_faces_before += r.number_of_faces_before;
    number_of_faces += r.number_of_faces;
    number_of_unprojected_vertices += r.number_of_unprojected_vertices;
    number_of_closest_points += r.number_of_closest_points;
    number_of_self_intersections_before += r.number_of_self_intersections_before;
    number_of_self_intersections += r.number_of_self_intersections;
    number_of_cells_built += r.number_of_cells_built;
    number_of_thin_faces += r.number_of_thin_faces;
    function_seconds += r.function_seconds;
    remeshing_seconds += r.remeshing_seconds;
  }
};

// remeshes faces between their seams on the function of the cells
template <typename ConcurrencyTag, typename Functions, typename NamedParameters>
class Region_remesher
{
public:
  Region_remesher(Functions& functions, const NamedParameters& np, const double sigma, const double length)
    : m_functions(functions), m_np(np), m_sigma(sigma), m_length(length)
  {
  }

  // New vertices get names of `maker`. Tells for each face whether it is thin in the embedding.
  Piece_faces operator()(const Piece_faces& faces, const std::uint32_t maker, Region_report& report,
                         std::vector<char>& is_thin) const
  {
    report.number_of_faces_before = faces.faces.size();
    if (!has_extent(faces))
    {
      report.number_of_faces = faces.faces.size();
      is_thin.assign(faces.faces.size(), 0);
      return faces;
    }
    const std::size_t built_before = m_functions.number_of_built();
    Real_timer timer;
    timer.start();
    const auto function = m_functions.near(boxes_about_faces(faces));
    report.function_seconds = timer.time();
    report.number_of_cells_built = m_functions.number_of_built() - built_before;
    timer.reset();
    Mesh_of_piece piece(faces);
    const Remeshing_result result = anisotropic_hde_remeshing<ConcurrencyTag>(
        piece.range(), piece.mesh(), function, parameters::begin_with(m_np).sigma(m_sigma).target_edge_length(m_length));
    report.number_of_unprojected_vertices = result.number_of_unprojected_vertices;
    report.number_of_closest_points = result.projections.closest_point;
    report.number_of_self_intersections_before = result.number_of_self_intersections_before;
    report.number_of_self_intersections = result.number_of_self_intersections;
    Piece_faces remeshed = piece.faces(maker);
    report.number_of_faces = remeshed.faces.size();
    is_thin = thin_faces(remeshed, function);
    report.remeshing_seconds = timer.time();
    return remeshed;
  }

private:
  // Remeshing without seams leaves hardly any face with a smaller angle, of many millions.
  static constexpr double least_angle = 30; // degrees

  std::vector<char> thin_faces(const Piece_faces& faces, const typename Functions::Function& function) const
  {
    std::vector<Vector> normals(faces.points.size());
    parallel_for<ConcurrencyTag>(
        faces.points.size(),
        [&](const std::size_t v)
        {
          const Vector gradient = gradient_of(function, faces.points[v]);
          normals[v] = gradient.norm() > 0 ? gradient.normalized() : Vector(Vector::Zero());
        },
        256);
    const double largest_cosine = std::cos(least_angle * CGAL_PI / 180);
    std::vector<char> result;
    for (const auto& face : faces.faces)
    {
      std::array<double, 3> squared{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::uint32_t v = face[k], w = face[(k + 1) % 3];
        squared[k] =
            (faces.points[w] - faces.points[v]).squaredNorm() + m_sigma * m_sigma * (normals[w] - normals[v]).squaredNorm();
      }
      result.push_back(Embedded_triangle::largest_cosine(squared[0], squared[1], squared[2]) > largest_cosine);
    }
    return result;
  }

  static bool has_extent(const Piece_faces& faces)
  {
    Space_box box;
    for (const Vector& p : faces.points)
      box.add(p);
    return !box.is_empty() && box.longest_side() > 0;
  }

  // Where the function may be asked: vertices leave a face by less than its size, or than the length that edges shall have. The box
  // about a whole band would have many more cells than the band.
  std::vector<Space_box> boxes_about_faces(const Piece_faces& faces) const
  {
    std::vector<Space_box> boxes;
    for (std::size_t f = 0; f < faces.faces.size(); ++f)
    {
      Space_box box;
      for (std::size_t k = 0; k < 3; ++k)
        box.add(faces.point(f, k));
      const Vector margin = Vector::Constant((std::max)(m_length, box.longest_side()));
      boxes.push_back(Space_box{box.low - margin, box.high + margin});
    }
    return boxes;
  }

  Functions& m_functions;
  const NamedParameters& m_np;
  const double m_sigma, m_length;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_REGION_REMESHER_H
