// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERPOLATED_VERTEX_FIELD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERPOLATED_VERTEX_FIELD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/*!
\ingroup PkgAnisotropicHdeRemeshingEmbeddings

A field in space from numbers at the vertices of a triangle mesh. At a point, it has the value that is linearly interpolated at
the closest point of the mesh. It keeps what it needs of the mesh, may be called concurrently, and is cheap to copy. It turns a
vertex property, such as a solution on the mesh, into a field for `scalar_field_embedding()`.
*/
class Interpolated_vertex_field
{
public:
  /// \brief the field of numbers at the vertices of a mesh
  /// \tparam TriangleMesh a model of `VertexListGraph`, `HalfedgeListGraph` and `FaceListGraph`
  /// \tparam VertexValueMap a model of `ReadablePropertyMap` with the vertices as keys and numbers as values
  /// \param tmesh the mesh
  /// \param values the values at its vertices
  /// \param np optional named parameters: `vertex_point_map` and `geom_traits`
  /// \throw std::invalid_argument if the mesh has no face that is not degenerate, a face that is not a triangle, or coordinates
  ///        that are not finite
  template <typename TriangleMesh, typename VertexValueMap, typename NamedParameters = parameters::Default_named_parameters>
  Interpolated_vertex_field(const TriangleMesh& tmesh, const VertexValueMap& values,
                            const NamedParameters& np = parameters::default_values())
  {
    if constexpr (internal::accepts_measurement<TriangleMesh, NamedParameters>())
    {
      constexpr bool has_numbers =
          internal::is_number<internal::Value_of_map<VertexValueMap, internal::Vertex_of<TriangleMesh>>>;
      static_assert(has_numbers, "values must be a property map from the vertices of the mesh to numbers");
      if constexpr (has_numbers)
        read(tmesh, values, np);
    }
  }

  // a move would leave a field without data
  Interpolated_vertex_field(const Interpolated_vertex_field&) = default;
  Interpolated_vertex_field& operator=(const Interpolated_vertex_field&) = default;

  template <typename Point>
  double operator()(const Point& p) const
  {
    const internal::Closest_facet::Answer closest =
        m_data->closest_facet(internal::Vector(to_double(p.x()), to_double(p.y()), to_double(p.z())));
    double value = 0;
    for (int k = 0; k < 3; ++k)
      value += closest.barycentric[k] * m_data->values[m_data->facets[closest.facet][std::size_t(k)]];
    return value;
  }

private:
  struct Data
  {
    std::vector<internal::Vector> points;
    std::vector<internal::Facet> facets;
    std::vector<double> values;
    internal::Closest_facet closest_facet{points, facets};
  };

  template <typename TriangleMesh, typename VertexValueMap, typename NamedParameters>
  void read(const TriangleMesh& tmesh, const VertexValueMap& values, const NamedParameters& np)
  {
    auto data = std::make_shared<Data>();
    internal::Measured_mesh mesh = internal::read_measured_mesh(tmesh, np);
    data->points = std::move(mesh.points);
    data->facets = std::move(mesh.faces);
    for (const auto v : vertices(tmesh))
      if (halfedge(v, tmesh) != boost::graph_traits<TriangleMesh>::null_halfedge()) // as in `points`
        data->values.push_back(to_double(internal::value_of(values, v)));
    if (data->closest_facet.empty())
      throw std::invalid_argument("the mesh has no face that is not degenerate, which a field needs");
    m_data = std::move(data);
  }

  std::shared_ptr<const Data> m_data;
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERPOLATED_VERTEX_FIELD_H
