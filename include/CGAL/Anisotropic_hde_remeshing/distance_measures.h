// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_DISTANCE_MEASURES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_DISTANCE_MEASURES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Measures.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Area_sampler.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/boost/graph/named_params_helper.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_traits_3.h>
#else
#  include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

namespace internal {

// the distance of points to a triangle mesh; may be asked by several threads
template <typename TriangleMesh, typename NamedParameters>
class Distance_to_mesh
{
  typedef typename GetGeomTraits<TriangleMesh, NamedParameters>::type Geom_traits;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  typedef AABB_face_graph_triangle_primitive<TriangleMesh, Vertex_point_map> Primitive;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  typedef AABB_traits_3<Geom_traits, Primitive> Traits;
#else
  typedef AABB_traits<Geom_traits, Primitive> Traits;
#endif
  typedef typename Geom_traits::Point_3 Point_3;
  typedef AABB_tree<Traits> Tree;

public:
  Distance_to_mesh(const TriangleMesh& tmesh, const NamedParameters& np)
  {
    build(tmesh, np);
    m_tree.accelerate_distance_queries(); // now, not when a thread asks first
  }

  // The same, for many queries. A query starts from the nearest of some points of the mesh. Where faces are long, vertices are far
  // away, and many faces would be looked at: points on the faces are nearer. `measured` is a copy of the mesh.
  Distance_to_mesh(const TriangleMesh& tmesh, const NamedParameters& np, const Measured_mesh& measured)
  {
    static constexpr std::size_t points_per_face = 4;
    build(tmesh, np);
    const std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> descriptors(faces(tmesh).first,
                                                                                               faces(tmesh).second);
    const Area_sampler sampler(measured, points_per_face * measured.faces.size());
    std::vector<typename Tree::Point_and_primitive_id> starts;
    for (std::size_t f = 0; f < measured.faces.size(); ++f)
      starts.emplace_back(to_point(measured.points[measured.faces[f][0]]), descriptors[f]);
    for (std::size_t i = 0; i < sampler.size(); ++i)
      starts.emplace_back(to_point(sampler(i)), descriptors[sampler.face(i)]);
    m_tree.accelerate_distance_queries(starts.begin(), starts.end());
  }

  double operator()(const Vector& p) const { return std::sqrt(to_double(m_tree.squared_distance(to_point(p)))); }

private:
  static Point_3 to_point(const Vector& p) { return Point_3(p.x(), p.y(), p.z()); }

  void build(const TriangleMesh& tmesh, const NamedParameters& np)
  {
    const Vertex_point_map point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                                    get_const_property_map(vertex_point, tmesh));
    m_tree.insert(faces(tmesh).first, faces(tmesh).second, tmesh, point_map);
    m_tree.build();
  }

  Tree m_tree;
};

// The distances of the points sampled on the mesh. The maximum is also over the vertices, where a distance often has its peaks.
template <typename ConcurrencyTag, typename Distance>
Rms_and_max rms_and_max_from(const Measured_mesh& mesh, const std::size_t number_of_samples, const Distance& distance)
{
  const Area_sampler sampler(mesh, number_of_samples);
  Rms_and_max result = rms_and_max<ConcurrencyTag>(sampler.size(), [&](const std::size_t i) { return distance(sampler(i)); });
  const Rms_and_max of_vertices =
      rms_and_max<ConcurrencyTag>(mesh.points.size(), [&](const std::size_t v) { return distance(mesh.points[v]); });
  result.max = (std::max)(result.max, of_vertices.max);
  return result;
}

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingMeasures

\brief measures the distances between two triangle meshes, both ways, at sampled points.

The sampled points are spread evenly over the area, without random numbers. So a second call and another number of threads give
the same result.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: how the distances are computed
\tparam TriangleMesh1 a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam TriangleMesh2 as `TriangleMesh1`
\tparam NamedParameters1 a sequence of named parameters
\tparam NamedParameters2 a sequence of named parameters

\param tmesh1 the first triangle mesh
\param tmesh2 the second triangle mesh
\param np1 optional named parameters for `tmesh1`: `vertex_point_map`, `geom_traits` and `number_of_points_on_faces`
(the number of points sampled on the faces of each of the two meshes, by default 200,000)
\param np2 optional named parameters for `tmesh2`: `vertex_point_map` and `geom_traits`

\throw std::invalid_argument if `number_of_points_on_faces` is less than 1, a face is not a triangle, or a coordinate is not
       finite
\pre both have a face
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh1, typename TriangleMesh2,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
Distance_measures measure_distance(const TriangleMesh1& tmesh1, const TriangleMesh2& tmesh2,
                                   const NamedParameters1& np1 = parameters::default_values(),
                                   const NamedParameters2& np2 = parameters::default_values())
{
  if constexpr (!internal::accepts_measurement<TriangleMesh1, NamedParameters1>() ||
                !internal::accepts_measurement<TriangleMesh2, NamedParameters2>())
    return Distance_measures();
  else
  {
    CGAL_precondition_msg(faces(tmesh1).first != faces(tmesh1).second && faces(tmesh2).first != faces(tmesh2).second,
                          "there is no distance to a mesh without faces");
    const std::size_t number_of_samples = internal::number_of_samples_parameter(np1);
    const internal::Measured_mesh first = internal::read_measured_mesh(tmesh1, np1),
                                  second = internal::read_measured_mesh(tmesh2, np2);
    const internal::Distance_to_mesh<TriangleMesh1, NamedParameters1> to_first(tmesh1, np1, first);
    const internal::Distance_to_mesh<TriangleMesh2, NamedParameters2> to_second(tmesh2, np2, second);
    const internal::Rms_and_max from_first = internal::rms_and_max_from<ConcurrencyTag>(first, number_of_samples, to_second);
    const internal::Rms_and_max from_second = internal::rms_and_max_from<ConcurrencyTag>(second, number_of_samples, to_first);

    Distance_measures measures;
    measures.rms_from_first = from_first.rms;
    measures.max_from_first = from_first.max;
    measures.rms_from_second = from_second.rms;
    measures.max_from_second = from_second.max;
    return measures;
  }
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_DISTANCE_MEASURES_H
