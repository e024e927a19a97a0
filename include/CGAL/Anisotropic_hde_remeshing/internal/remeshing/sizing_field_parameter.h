// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SIZING_FIELD_PARAMETER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SIZING_FIELD_PARAMETER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Sized_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/sizing_field_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Metric_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Sized_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Vertex_sizes.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The size wanted at a point, both in the unit of the caller. All kinds of sizing fields have this type, so that the remesher is
// compiled once for them.
class Wanted_size
{
public:
  explicit Wanted_size(std::function<double(const Vector&)> size) : m_size(std::move(size)) {}

  // throws std::invalid_argument if it is not positive and finite
  double operator()(const Vector& p) const { return checked_size(m_size(p), p); }

private:
  std::function<double(const Vector&)> m_size;
};

template <typename T>
const T& without_reference_wrapper(const T& t)
{
  return t;
}
template <typename T>
const T& without_reference_wrapper(const std::reference_wrapper<T>& t)
{
  return t.get();
}

// the size at a vertex of the input, by a property map or by a sizing field of CGAL's
template <typename Field, typename TriangleMesh, typename Vertex>
double size_at_vertex(const Field& field, const TriangleMesh& tmesh, const Vertex v)
{
  if constexpr (is_vertex_sizing_map<Field, TriangleMesh>)
    return CGAL::to_double(value_of(field, v));
  else
    return CGAL::to_double(field.at(v, tmesh));
}

// A function of points as one of vectors. Keeps a copy of the function, or of the reference that was given.
template <typename Point, typename Given>
std::function<double(const Vector&)> size_of_function(const Given& given)
{
  typedef typename Without_reference_wrapper<Given>::type Field;
  constexpr bool is_function = Is_sizing_function<Field, Point>::value;
  static_assert(is_function, "sizing_field must take a point of vertex_point_map and return a number");
  if constexpr (is_function)
    return [given](const Vector& p) { return CGAL::to_double(without_reference_wrapper(given)(Point(p[0], p[1], p[2]))); };
  else
    return {};
}

// The sizes at the vertices of the input, checked. `size` is that of a vertex by its number and its point.
template <typename Size>
std::vector<double> sizes_of_vertices(const Input_surface& input, const double unit, const Size& size)
{
  std::vector<double> sizes;
  sizes.reserve(input.points().size());
  for (std::size_t i = 0; i < input.points().size(); ++i)
  {
    const Vector p = unit * input.points()[i];
    sizes.push_back(checked_size(size(i, p), p));
  }
  return sizes;
}

// `sizing_field`, and `gradation` if it is given. `vertices` are those of the input, which is in `unit`. A function is asked wherever
// the remesher asks. With a gradation it is asked at the vertices first, and the sizes that these allow are a second bound: between
// them the function may still be less.
template <typename Point, typename TriangleMesh, typename Vertex, typename NamedParameters>
Wanted_size sizing_field_parameter(const NamedParameters& np, const TriangleMesh& tmesh, const std::vector<Vertex>& vertices,
                                   const Input_surface& input, const double unit)
{
  const auto given = parameters::get_parameter(np, internal_np::sizing_field);
  typedef typename Without_reference_wrapper<std::decay_t<decltype(given)>>::type Field;
  const auto on_input = [&input, unit](std::vector<double> sizes) -> std::function<double(const Vector&)>
  {
    const Vertex_sizes field(input, std::move(sizes));
    return [field, unit](const Vector& p) { return field(p / unit); };
  };
  const auto limit = [&](std::vector<double>& sizes)
  {
    if constexpr (is_given<NamedParameters, internal_np::gradation_t>)
      limit_gradation(sizes, input.points(), input.facets(), unit * gradation_parameter(np));
    else
      (void)sizes;
  };
  if constexpr (is_vertex_sizing_map<Field, TriangleMesh> || Is_sizing_field_of_mesh<Field, TriangleMesh>::value)
  {
    std::vector<double> sizes = sizes_of_vertices(input, unit,
                                                  [&](const std::size_t i, const Vector&) {
                                                    return size_at_vertex(without_reference_wrapper(given), tmesh, vertices[i]);
                                                  });
    limit(sizes);
    return Wanted_size(on_input(std::move(sizes)));
  }
  else
  {
    const std::function<double(const Vector&)> function = size_of_function<Point>(given);
    if constexpr (is_given<NamedParameters, internal_np::gradation_t>)
    {
      std::vector<double> sizes = sizes_of_vertices(input, unit, [&](std::size_t, const Vector& p) { return function(p); });
      limit(sizes);
      const std::function<double(const Vector&)> limited = on_input(std::move(sizes));
      return Wanted_size([function, limited](const Vector& p) { return (std::min)(checked_size(function(p), p), limited(p)); });
    }
    else
      return Wanted_size(function);
  }
}

// the embedding in which edges of the sizes that are wanted have the length 1
template <typename Embedding>
auto embedding_with_sizes(const Embedding& embedding, const Wanted_size& size)
{
  if constexpr (is_metric<Embedding>)
  {
    typedef Sized_metric<std::decay_t<decltype(embedding.metric())>, Wanted_size> Metric;
    return Metric_embedding<Metric>(Metric(embedding.metric(), size));
  }
  else
    return Sized_embedding<Vector, Wanted_size, Embedding>(size, embedding);
}

template <typename NamedParameters, bool = is_given<NamedParameters, internal_np::sizing_field_t>>
struct Embedding_with_sizes
{
  typedef Embedding_parameter<NamedParameters> type;
};
template <typename NamedParameters>
struct Embedding_with_sizes<NamedParameters, true>
{
  typedef decltype(embedding_with_sizes(std::declval<Embedding_parameter<NamedParameters>>(),
                                        std::declval<Wanted_size>())) type;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SIZING_FIELD_PARAMETER_H
