// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_TYPE_TRAITS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_TYPE_TRAITS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>

#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What a type of the caller's can do. These questions are asked of any type whatsoever, so they must not be errors themselves.
// boost::graph_traits of a type that is no graph is an error.

// a graph with faces, recognised by the functions that belong to it
template <typename T, typename = void>
struct Is_face_graph : std::false_type
{
};
template <typename T>
struct Is_face_graph<T, std::void_t<decltype(faces(std::declval<const T&>())), decltype(halfedges(std::declval<const T&>())),
                                    decltype(vertices(std::declval<const T&>()))>> : std::true_type
{
};

// what a loop runs over: a container, a view, an array
template <typename T, typename = void>
struct Has_begin_and_end : std::false_type
{
};
template <typename T>
struct Has_begin_and_end<T, std::void_t<decltype(*std::begin(std::declval<T&>())), decltype(std::end(std::declval<T&>()))>>
  : std::true_type
{
};

// a range of points or of faces
template <typename T>
struct Is_range : std::bool_constant<Has_begin_and_end<T>::value && !Is_face_graph<std::remove_const_t<T>>::value>
{
};

// A view may keep its position, and then only a copy of it can be run over. Such a copy is cheap.
template <typename Range, typename Function>
void for_each_of_range(const Range& range, const Function& function)
{
  if constexpr (Has_begin_and_end<const Range>::value)
    for (const auto& element : range)
      function(element);
  else
  {
    Range copy(range);
    for (const auto& element : copy)
      function(element);
  }
}

template <typename Range>
using Value_of_range = std::decay_t<decltype(*std::begin(std::declval<Range&>()))>;

template <typename T, typename = void>
struct Is_pair : std::false_type
{
};
template <typename T>
struct Is_pair<T, std::void_t<decltype(std::declval<const T&>().first), decltype(std::declval<const T&>().second)>>
  : std::true_type
{
};

// a number of C++ or of CGAL
template <typename T>
constexpr bool is_number =
    std::is_arithmetic<T>::value ? !std::is_same<T, bool>::value
                                 : std::is_same<typename Real_embeddable_traits<T>::Is_real_embeddable, Tag_true>::value;

// Any type for true and false: also 0 and 1, tags, and what a vector of bool returns.
template <typename T>
constexpr bool is_boolean = std::is_convertible<T, bool>::value && !std::is_floating_point<T>::value &&
                            !std::is_pointer<T>::value && !std::is_enum<T>::value;
template <typename T>
constexpr bool is_boolean<std::reference_wrapper<T>> = std::is_same<std::remove_const_t<T>, bool>::value;

// a point or a vector: its coordinates are numbers
template <typename T, typename = void>
struct Has_coordinates : std::false_type
{
};
template <typename T>
struct Has_coordinates<T, std::void_t<decltype(std::declval<const T&>().x()), decltype(std::declval<const T&>().y()),
                                      decltype(std::declval<const T&>().z())>>
  : std::bool_constant<is_number<std::decay_t<decltype(std::declval<const T&>().x())>>>
{
};

// Property maps, recognised by what can be done with them. Those of Boost seem to take any key and value, and fail only inside.
// So their declared types are compared.
namespace property_maps {

using boost::get;
using boost::put;

template <typename Map, typename Key, typename = void>
struct Takes_key : std::true_type
{
};
template <typename Map, typename Key>
struct Takes_key<Map, Key, std::void_t<typename boost::property_traits<Map>::key_type>>
  : std::is_convertible<Key, typename boost::property_traits<Map>::key_type>
{
};

template <typename Map, typename Value, typename = void>
struct Takes_value : std::true_type
{
};
template <typename Map, typename Value>
struct Takes_value<Map, Value, std::void_t<typename boost::property_traits<Map>::value_type>>
  : std::is_convertible<Value, typename boost::property_traits<Map>::value_type>
{
};

// the value type that a map declares; `get` may return a proxy
template <typename Map, typename Returned, typename = void>
struct Declared_value
{
  typedef std::decay_t<Returned> type;
};
template <typename Map, typename Returned>
struct Declared_value<Map, Returned, std::void_t<typename boost::property_traits<Map>::value_type>>
{
  typedef std::remove_cv_t<typename boost::property_traits<Map>::value_type> type;
};

struct Nothing
{
};

template <typename Map, typename Key, typename = void>
struct Value
{
  typedef Nothing type;
};
template <typename Map, typename Key>
struct Value<Map, Key,
             std::void_t<std::enable_if_t<Takes_key<Map, Key>::value>,
                         decltype(get(std::declval<const Map&>(), std::declval<const Key&>()))>>
{
  typedef typename Declared_value<Map, decltype(get(std::declval<const Map&>(), std::declval<const Key&>()))>::type type;
};

template <typename Map, typename Key, typename Value, typename = void>
struct Is_writable : std::false_type
{
};
template <typename Map, typename Key, typename Value>
struct Is_writable<Map, Key, Value,
                   std::void_t<std::enable_if_t<Takes_key<Map, Key>::value && Takes_value<Map, Value>::value>,
                               decltype(put(std::declval<Map&>(), std::declval<const Key&>(), std::declval<const Value&>()))>>
  : std::true_type
{
};

} // namespace property_maps

// The value of a map for a key. What `get` returns may be a proxy of it, which has no coordinates and is no number.
namespace property_maps {

template <typename Map, typename Key>
decltype(auto) value_of(const Map& map, const Key& key)
{
  typedef typename Value<Map, Key>::type Declared;
  if constexpr (std::is_same<std::decay_t<decltype(get(map, key))>, Declared>::value)
    return get(map, key);
  else
    return static_cast<Declared>(get(map, key));
}

} // namespace property_maps
using property_maps::value_of;

// the type of the values of a property map for a key; `property_maps::Nothing` if it is no map or takes other keys
template <typename Map, typename Key>
using Value_of_map = typename property_maps::Value<Map, Key>::type;

template <typename Map, typename Key>
constexpr bool is_readable_map = !std::is_same<Value_of_map<Map, Key>, property_maps::Nothing>::value;

template <typename Map, typename Key, typename Value>
constexpr bool is_writable_map = property_maps::Is_writable<Map, Key, Value>::value;

// a model of `ImplicitFunctionWithGradient`
template <typename T, typename = void>
struct Is_function_with_gradient : std::false_type
{
};
template <typename T>
struct Is_function_with_gradient<
    T, std::void_t<typename T::Point_3, decltype(std::declval<const T&>()(std::declval<const typename T::Point_3&>())),
                   decltype(std::declval<const T&>().gradient(std::declval<const typename T::Point_3&>()))>>
  : std::bool_constant<
        std::is_constructible<typename T::Point_3, double, double, double>::value &&
        is_number<std::decay_t<decltype(std::declval<const T&>()(std::declval<const typename T::Point_3&>()))>> &&
        Has_coordinates<
            std::decay_t<decltype(std::declval<const T&>().gradient(std::declval<const typename T::Point_3&>()))>>::value>
{
};

template <typename T>
constexpr bool is_implicit_function = Is_function_with_gradient<Piece_of<T>>::value;

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_TYPE_TRAITS_H
