// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_SIZING_FIELD_TYPES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_SIZING_FIELD_TYPES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <functional>
#include <type_traits>
#include <utility>

// The kinds of sizing fields: a property map of the vertices, an object that is asked for a vertex, as CGAL's isotropic_remeshing has
// them since CGAL 6.0, or a function of a point. The first that fits counts.

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

template <typename T>
struct Without_reference_wrapper
{
  typedef T type;
};
template <typename T>
struct Without_reference_wrapper<std::reference_wrapper<T>>
{
  typedef std::remove_const_t<T> type;
};

// A pointer is a map of indices, but a text is none of sizes.
template <typename T, typename Graph, typename Value = Value_of_map<T, typename boost::graph_traits<Graph>::vertex_descriptor>>
constexpr bool is_vertex_sizing_map = is_number<Value> && !std::is_same<Value, char>::value;

// a model of CGAL's concept PMPSizingField, as far as it is used here
template <typename T, typename Graph, typename = void>
struct Is_sizing_field_of_mesh : std::false_type
{
};
template <typename T, typename Graph>
struct Is_sizing_field_of_mesh<
    T, Graph,
    std::void_t<decltype(std::declval<const T&>().at(std::declval<typename boost::graph_traits<Graph>::vertex_descriptor>(),
                                                     std::declval<const Graph&>()))>>
  : std::bool_constant<is_number<std::decay_t<decltype(std::declval<const T&>().at(
        std::declval<typename boost::graph_traits<Graph>::vertex_descriptor>(), std::declval<const Graph&>()))>>>
{
};

template <typename T, typename Point, typename = void>
struct Is_sizing_function : std::false_type
{
};
template <typename T, typename Point>
struct Is_sizing_function<T, Point, std::void_t<decltype(std::declval<const T&>()(std::declval<const Point&>()))>>
  : std::bool_constant<is_number<std::decay_t<decltype(std::declval<const T&>()(std::declval<const Point&>()))>>>
{
};

// The points of a mesh. Those of a mesh without points of its own are known only by the map that comes with them.
struct Unknown_point
{
};
template <typename Graph, typename = void>
struct Own_point
{
  typedef Unknown_point type;
};
template <typename Graph>
struct Own_point<Graph, std::void_t<typename boost::property_map<Graph, vertex_point_t>::const_type>>
{
  typedef typename boost::property_traits<typename boost::property_map<Graph, vertex_point_t>::const_type>::value_type type;
};

// a named parameter of type T for a mesh; a function is asked for points of another map later
template <typename T, typename Graph>
struct Is_sizing_field
{
  typedef typename Without_reference_wrapper<T>::type Field;
  typedef typename Own_point<Graph>::type Point;
  static constexpr bool may_be_function =
      Is_sizing_function<Field, Point>::value || (std::is_same<Point, Unknown_point>::value && std::is_class<Field>::value);
  static constexpr bool value =
      is_vertex_sizing_map<Field, Graph> || Is_sizing_field_of_mesh<Field, Graph>::value || may_be_function;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_SIZING_FIELD_TYPES_H
