// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "estimate_normals.h"

#include <CGAL/jet_estimate_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <tuple>

namespace hde_remesh {

namespace {

constexpr unsigned int number_of_neighbors = 18; // three times what a surface needs, against noise

typedef std::tuple<Point_3, Vector_3, std::size_t> Item; // with the place in the file
typedef std::vector<Item> Items;

auto maps()
{
  return CGAL::parameters::point_map(CGAL::Nth_of_tuple_property_map<0, Item>())
      .normal_map(CGAL::Nth_of_tuple_property_map<1, Item>());
}

bool is_unit(const Vector_3& normal) { return std::abs(normal.squared_length() - 1) < 1e-6; } // not even if it is no number

// Orients the normals of the items that hang together with the highest one. Returns the others.
Items orient_part(Items& items, std::vector<Vector_3>& normals)
{
  const auto others = CGAL::mst_orient_normals(items, number_of_neighbors, maps());
  for (auto item = items.begin(); item != others; ++item)
    normals[std::get<2>(*item)] = std::get<1>(*item);
  return Items(others, items.end());
}

} // namespace

std::vector<Vector_3> estimate_normals(const std::vector<Point_3>& points)
{
  static constexpr int largest_number_of_parts = 100; // each costs the time of a search
  Items items;
  for (std::size_t i = 0; i < points.size(); ++i)
    items.emplace_back(points[i], Vector_3(0, 0, 0), i);
  CGAL::jet_estimate_normals<CGAL::Parallel_if_available_tag>(items, number_of_neighbors, maps());
  Items found;
  for (const Item& item : items)
    if (is_unit(std::get<1>(item)))
      found.push_back(item);
  std::vector<Vector_3> normals(points.size(), Vector_3(0, 0, 0));
  for (int part = 0; part < largest_number_of_parts && found.size() > number_of_neighbors; ++part)
    found = orient_part(found, normals);
  return normals;
}

} // namespace hde_remesh
