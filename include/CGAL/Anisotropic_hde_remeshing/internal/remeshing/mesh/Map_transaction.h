// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_MAP_TRANSACTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_MAP_TRANSACTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// whether the mesh itself keeps the property map
template <typename TriangleMesh, typename Map, typename Key>
struct Is_own_map : std::false_type
{
};
template <typename Point, typename Map, typename Key>
struct Is_own_map<Surface_mesh<Point>, Map, Key>
  : std::is_same<Map, typename Surface_mesh<Point>::template Property_map<Key, Value_of_map<Map, Key>>>
{
};

// Overwrites values of one of the caller's property maps, which may throw. Puts the old values back unless `commit()` is
// called.
template <typename Map, typename Key>
class Map_transaction
{
  typedef Value_of_map<Map, Key> Value;

public:
  explicit Map_transaction(const Map& map) : m_map(map) {}
  Map_transaction(const Map_transaction&) = delete;
  Map_transaction& operator=(const Map_transaction&) = delete;

  ~Map_transaction()
  {
    for (std::size_t i = m_old.size(); i > 0; --i)
      put_back(m_old[i - 1]);
  }

  void write(const Key& key, const Value& value)
  {
    m_old.emplace_back(key, get(m_map, key));
    put(m_map, key, value);
  }

  void commit() { m_old.clear(); }

private:
  void put_back(const std::pair<Key, Value>& old) noexcept
  {
    try
    {
      put(m_map, old.first, old.second);
    }
    catch (...) // if the map throws now, it has thrown in write() too: the old value is still there
    {
    }
  }

  Map m_map; // not const: `put` of some maps takes no other
  std::vector<std::pair<Key, Value>> m_old;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_MAP_TRANSACTION_H
