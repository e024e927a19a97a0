// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_QUALITY_MEASURES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_QUALITY_MEASURES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Measures.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/folded_edge.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

namespace internal {

// the connected components of the vertices over the edges, by merging sets
inline std::size_t number_of_components(const Measured_mesh& mesh)
{
  std::vector<std::size_t> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&parent](std::size_t v)
  {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  std::size_t number = parent.size();
  for (const std::pair<std::size_t, std::size_t>& edge : mesh.edges)
  {
    const std::size_t a = root(edge.first), b = root(edge.second);
    if (a == b)
      continue;
    parent[(std::max)(a, b)] = (std::min)(a, b);
    --number;
  }
  return number;
}

// the number of edges over which faces lie on each other
inline std::size_t number_of_folded_edges(const Measured_mesh& mesh)
{
  struct Side
  {
    std::size_t low, high, face;
    bool operator<(const Side& other) const { return std::tie(low, high, face) < std::tie(other.low, other.high, other.face); }
  };
  std::vector<Side> sides;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::pair<std::size_t, std::size_t> ends = std::minmax({mesh.faces[f][k], mesh.faces[f][(k + 1) % 3]});
      sides.push_back(Side{ends.first, ends.second, f});
    }
  std::sort(sides.begin(), sides.end());
  const double unit = mesh.diagonal(); // in this unit, products neither overflow nor vanish
  if (!(unit > 0))
    return 0;
  std::size_t number = 0;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i - 1].low == sides[i].low && sides[i - 1].high == sides[i].high)
      number += is_folded_edge(mesh.normal_in_unit(sides[i - 1].face, unit), mesh.normal_in_unit(sides[i].face, unit)) ? 1 : 0;
  return number;
}

// a measured mesh with the unit normals of its vertices: lengths and angles in the embedding
struct Embedded_mesh
{
  const Measured_mesh& mesh;
  std::vector<Vector> normals;
  double sigma;

  double squared_length(const std::size_t a, const std::size_t b) const
  {
    return (mesh.points[a] - mesh.points[b]).squaredNorm() + sigma * sigma * (normals[a] - normals[b]).squaredNorm();
  }

  bool is_folded(const std::size_t f) const
  {
    const std::array<std::size_t, 3>& v = mesh.faces[f];
    return !mesh.is_degenerate[f] && !(mesh.normal(f).dot(normals[v[0]] + normals[v[1]] + normals[v[2]]) > 0);
  }
};

template <typename ConcurrencyTag, typename Function>
std::vector<Vector> unit_normals(const Measured_mesh& mesh, const Function& f)
{
  std::vector<Vector> normals(mesh.points.size());
  parallel_for<ConcurrencyTag>(normals.size(),
                               [&](const std::size_t v)
                               {
                                 const auto& piece_at = piece(f, mesh.point_regions[v]);
                                 normals[v] = gradient_of(piece_at, mesh.points[v]).stableNormalized();
                               });
  return normals;
}

inline void measure_edges(const Embedded_mesh& embedded, Embedding_measures& measures)
{
  std::vector<double> lengths;
  double sum_of_logarithms = 0;
  for (const std::pair<std::size_t, std::size_t>& edge : embedded.mesh.edges)
  {
    lengths.push_back(std::sqrt(embedded.squared_length(edge.first, edge.second)));
    // a single edge of no length would make the mean vanish
    sum_of_logarithms += std::log((std::max)(lengths.back(), (std::numeric_limits<double>::min)()));
  }
  if (lengths.empty())
    return;
  const double number = static_cast<double>(lengths.size());
  measures.edge_length_mean = std::exp(sum_of_logarithms / number);
  if (!(measures.target_edge_length > 0))
    measures.target_edge_length = measures.edge_length_mean;
  const auto share_within = [&](const double low, const double high)
  {
    const double l = measures.target_edge_length;
    return static_cast<double>(std::count_if(lengths.begin(), lengths.end(),
                                             [&](const double length) { return length >= low * l && length <= high * l; })) /
           number;
  };
  measures.share_within_half = share_within(0.5, 1.5);
  measures.share_within_sqrt_2 = share_within(0.7, 1.41);
}

inline void measure_faces(const Embedded_mesh& embedded, Embedding_measures& measures)
{
  const std::vector<std::array<std::size_t, 3>>& faces = embedded.mesh.faces;
  double sum = 0, least = faces.empty() ? 0 : 180;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const std::array<std::size_t, 3>& v = faces[f];
    const double angle = minimum_angle(embedded.squared_length(v[0], v[1]), embedded.squared_length(v[1], v[2]),
                                       embedded.squared_length(v[2], v[0]));
    sum += angle;
    least = (std::min)(least, angle);
    if (embedded.is_folded(f))
      ++measures.number_of_folded_faces;
  }
  measures.minimum_angle_mean = faces.empty() ? 0 : sum / static_cast<double>(faces.size());
  measures.minimum_angle_least = least;
}

} // namespace internal

/// \ingroup PkgAnisotropicHdeRemeshingMeasures
///
/// the aspect ratio \f$ q_T \f$ of the triangle of three points, infinite if they are collinear.
/// \tparam Point_3 a point type of a CGAL kernel
template <typename Point_3>
double aspect_ratio(const Point_3& p, const Point_3& q, const Point_3& r)
{
  typedef typename Kernel_traits<Point_3>::Kernel Kernel;
  if (typename Kernel::Collinear_3()(p, q, r))
    return std::numeric_limits<double>::infinity();
  const auto convert = [](const Point_3& s) { return internal::Vector(to_double(s.x()), to_double(s.y()), to_double(s.z())); };
  return internal::aspect_ratio(convert(p), convert(q), convert(r));
}

/*!
\ingroup PkgAnisotropicHdeRemeshingMeasures

\brief counts the elements of a triangle mesh, its components and boundary loops.

\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of named parameters

\param tmesh a triangle mesh
\param np optional named parameters: `vertex_point_map` and `geom_traits`

\throw std::invalid_argument if a face of `tmesh` is not a triangle, or a coordinate is not finite
*/
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
Topology_measures measure_topology(const TriangleMesh& tmesh, const NamedParameters& np = parameters::default_values())
{
  if constexpr (!internal::accepts_measurement<TriangleMesh, NamedParameters>())
    return Topology_measures();
  else
  {
    const internal::Measured_mesh mesh = internal::read_measured_mesh(tmesh, np);
    Topology_measures measures;
    measures.number_of_vertices = mesh.points.size();
    measures.number_of_isolated_vertices = mesh.number_of_isolated_vertices;
    measures.number_of_edges = mesh.edges.size();
    measures.number_of_faces = mesh.faces.size();
    measures.number_of_boundary_edges = mesh.number_of_boundary_edges;
    measures.number_of_boundary_loops = mesh.number_of_boundary_loops;
    measures.number_of_components = internal::number_of_components(mesh);
    measures.euler_characteristic =
        static_cast<std::ptrdiff_t>(mesh.points.size() + mesh.faces.size()) - static_cast<std::ptrdiff_t>(mesh.edges.size());
    std::size_t number_of_valence_6 = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (!mesh.is_on_boundary[v])
      {
        ++measures.number_of_interior_vertices;
        number_of_valence_6 += mesh.valences[v] == 6 ? 1 : 0;
      }
    if (measures.number_of_interior_vertices > 0)
      measures.valence_6_share =
          static_cast<double>(number_of_valence_6) / static_cast<double>(measures.number_of_interior_vertices);
    return measures;
  }
}

/*!
\ingroup PkgAnisotropicHdeRemeshingMeasures

\brief measures the aspect ratios of the faces of a triangle mesh, and counts its folded edges.

\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of named parameters

\param tmesh a triangle mesh
\param np optional named parameters: `vertex_point_map` and `geom_traits`

\throw std::invalid_argument if a face of `tmesh` is not a triangle, or a coordinate is not finite
*/
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
Shape_measures measure_shape(const TriangleMesh& tmesh, const NamedParameters& np = parameters::default_values())
{
  if constexpr (!internal::accepts_measurement<TriangleMesh, NamedParameters>())
    return Shape_measures();
  else
  {
    const internal::Measured_mesh mesh = internal::read_measured_mesh(tmesh, np);
    Shape_measures measures;
    measures.number_of_folded_edges = internal::number_of_folded_edges(mesh);
    std::vector<double> ratios(mesh.faces.size(), std::numeric_limits<double>::infinity());
    double sum = 0;
    for (std::size_t f = 0; f < ratios.size(); ++f)
    {
      const std::array<std::size_t, 3>& v = mesh.faces[f];
      if (!mesh.is_degenerate[f])
        ratios[f] = internal::aspect_ratio(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]);
      if (std::isfinite(ratios[f]))
        sum += ratios[f];
      else
        ++measures.number_of_degenerate_faces;
    }
    if (ratios.empty())
      return measures;
    const std::size_t number_of_finite = ratios.size() - measures.number_of_degenerate_faces;
    std::sort(ratios.begin(), ratios.end());
    measures.aspect_ratio_mean = number_of_finite > 0 ? sum / static_cast<double>(number_of_finite) : ratios.back();
    measures.aspect_ratio_p99 = ratios[(ratios.size() * 99) / 100];
    measures.aspect_ratio_max = ratios.back();
    return measures;
  }
}

/*!
\ingroup PkgAnisotropicHdeRemeshingMeasures

\brief measures a triangle mesh in the six-dimensional embedding by the unit normals of an implicit function.

A face counts as folded if it is not degenerate and its normal has no positive scalar product with the sum of the unit
gradients at its three vertices.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: how the gradients are computed
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam Function a model of `ImplicitFunctionWithGradient`, or of `PiecewiseImplicitFunction`, which needs `face_patch_map`
\tparam NamedParameters a sequence of named parameters

\param tmesh a triangle mesh
\param f the implicit function. Its gradient points to the side that the faces look to.
\param np optional named parameters: `vertex_point_map`, `geom_traits`, `sigma` (the weight of the normals, in the unit
of the mesh; by default 0.01 of the diagonal of its bounding box) and `target_edge_length` (the length `l` that the
shares of edges refer to; by default, and if it is 0, the geometric mean of the 6D lengths)

\throw std::invalid_argument if `sigma` or `target_edge_length` is negative or not finite
\throw std::invalid_argument if a face of `tmesh` is not a triangle, or a coordinate is not finite
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Function,
          typename NamedParameters = parameters::Default_named_parameters>
Embedding_measures measure_embedding(const TriangleMesh& tmesh, const Function& f,
                                     const NamedParameters& np = parameters::default_values())
{
  if constexpr (!internal::accepts_measurement<TriangleMesh, Function, NamedParameters>())
    return Embedding_measures();
  else
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;

    const internal::Measured_mesh mesh = internal::read_measured_mesh_of(f, tmesh, np);
    Embedding_measures measures;
    measures.sigma = internal::checked_not_negative(
        "sigma", to_double(choose_parameter(get_parameter(np, internal_np::sigma), 0.01 * mesh.diagonal())));
    measures.target_edge_length = internal::checked_not_negative(
        "target_edge_length", to_double(choose_parameter(get_parameter(np, internal_np::target_edge_length), 0.)));
    const internal::Embedded_mesh embedded{mesh, internal::unit_normals<ConcurrencyTag>(mesh, f), measures.sigma};
    internal::measure_edges(embedded, measures);
    internal::measure_faces(embedded, measures);
    return measures;
  }
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_QUALITY_MEASURES_H
