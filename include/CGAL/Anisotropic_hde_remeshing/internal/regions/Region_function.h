// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_FUNCTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_FUNCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Piecewise_rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/Rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_plane.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The function of one region of a surface with sharp edges: a field by radial basis functions, a plane, facets, or nothing.
// `Field` is an `Rbf_field`.
template <typename Field>
class Region_function
{
  struct Nothing
  {
    Value_and_gradient operator()(const Vector&) const { return Value_and_gradient{{1.}, Vector::Zero()}; }
  };

public:
  Region_function() = default;
  explicit Region_function(const Region_plane& plane) : m_function(plane) {}
  explicit Region_function(std::shared_ptr<const Region_facets> facets) : m_function(std::move(facets)) {}
  explicit Region_function(std::shared_ptr<const Field> field) : m_function(std::move(field)) {}

  Piece_kind kind() const
  {
    static constexpr Piece_kind kinds[] = {Piece_kind::NONE, Piece_kind::PLANE, Piece_kind::CLOSEST_POINT, Piece_kind::FIELD};
    return kinds[m_function.index()];
  }

  // none unless it is one
  std::shared_ptr<const Field> field() const
  {
    const auto* field = std::get_if<std::shared_ptr<const Field>>(&m_function);
    return field != nullptr ? *field : nullptr;
  }

  // requires that it is no field; throws if the point is not finite
  Value_and_gradient operator()(const Vector& point) const
  {
    if (!point.allFinite())
      throw std::invalid_argument("the implicit function is asked for a point whose coordinates are not finite");
    if (const auto* plane = std::get_if<Region_plane>(&m_function))
      return (*plane)(point);
    if (const auto* facets = std::get_if<std::shared_ptr<const Region_facets>>(&m_function))
      return (**facets)(point);
    return Nothing()(point);
  }

  void add_to(Piecewise_rbf_diagnostics& diagnostics) const
  {
    ++diagnostics.number_of_regions;
    diagnostics.memory_bytes += sizeof(*this);
    diagnostics.number_of_planes += kind() == Piece_kind::PLANE ? 1 : 0;
    diagnostics.number_of_regions_without_area += kind() == Piece_kind::NONE ? 1 : 0;
    if (const auto* facets = std::get_if<std::shared_ptr<const Region_facets>>(&m_function))
    {
      ++diagnostics.number_of_closest_point_regions;
      diagnostics.memory_bytes += (*facets)->memory_bytes();
    }
    if (const auto field_of_region = field())
      add(field_of_region->diagnostics(), diagnostics);
  }

private:
  static void add(const Rbf_diagnostics& field, Piecewise_rbf_diagnostics& result)
  {
    ++result.number_of_fields;
    result.number_of_points += field.number_of_points;
    result.number_of_points_on_facets += field.number_of_points_on_facets;
    result.number_of_replaced_vertices += field.number_of_replaced_vertices;
    result.number_of_points_on_edges += field.number_of_points_on_edges;
    result.noise = (std::max)(result.noise, field.noise);
    result.number_of_patches += field.number_of_patches;
    result.patches_repaired += field.patches_repaired;
    result.patches_on_fallback += field.patches_on_fallback;
    result.patches_off_facets += field.patches_off_facets;
    result.number_of_refined_places += field.number_of_refined_places;
    result.number_of_failed_checks += field.number_of_failed_checks;
    result.worst_residual = (std::max)(result.worst_residual, field.worst_residual);
    result.worst_value_residual = (std::max)(result.worst_value_residual, field.worst_value_residual);
    result.worst_condition = (std::max)(result.worst_condition, field.worst_condition);
    result.memory_bytes += field.memory_bytes;
  }

  std::variant<Nothing, Region_plane, std::shared_ptr<const Region_facets>, std::shared_ptr<const Field>> m_function;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_FUNCTION_H
