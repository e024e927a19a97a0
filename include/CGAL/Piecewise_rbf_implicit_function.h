// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_PIECEWISE_RBF_IMPLICIT_FUNCTION_H
#define CGAL_PIECEWISE_RBF_IMPLICIT_FUNCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Piecewise_rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/Smoothing.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Rbf_field.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/shares_of_construction.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/visitor_parameter.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/build_region_functions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/split_regions.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>
#include <CGAL/Radial_basis_functions.h>
#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgAnisotropicHdeRemeshingSharp

Signed functions, one for each region of a triangle mesh. Their zero sets together are a surface with sharp edges: each zero set
is smooth, and the edges are where two of them meet.

The regions are those of `Anisotropic_hde_remeshing::detect_surface_regions()`, or any other parts of the mesh. A vertex at a
crease belongs to all regions there, and has the normal of each. The function of a region is
- the signed distance to a plane, if all points of the region are in a plane, up to 5 millionths of the size of the mesh. That is
  the rounding of files with six digits.
- the signed distance to the facets of the region, if it has less than 10 vertices, if no function by radial basis functions can be
  built from it, or if that function misses more than 2% of the area of the facets. Beyond the boundary of the region the distance
  continues along the tangent planes.
- otherwise an `Rbf_implicit_function` of the faces of the region. The edges of a region may be much longer in one direction than
  in the other, as those of a cylinder of two rows of vertices. Then the function is one of points with normals, and points are
  added on curves over the long edges.

All of them continue smoothly beyond the boundary of the region: planes without an end, facets along their tangents, fields for two
and a half local spacings.

Copies are cheap: they share the data, which never change. All members are thread-safe. The function does not depend on the
number of threads that built it. Large regions are built one after another, each in parallel. Small regions are built in
parallel with each other.

The construction takes time linear in the number of points. An evaluation takes the time of one of `Rbf_implicit_function`.

\tparam GeomTraits a kernel; computations are in `double` whatever its number type
\tparam RadialFunction a model of `RadialBasisFunction`, such as `Polyharmonic_rbf`
\tparam ConcurrencyTag `Sequential_tag` (the default), `Parallel_tag` or `Parallel_if_available_tag`: how the function is built.
       With the latter two, `RadialFunction` is called from several threads at once. The result is the same.

\cgalModels{PiecewiseImplicitFunction}
*/
template <typename GeomTraits, typename RadialFunction = Polyharmonic_rbf, typename ConcurrencyTag = Sequential_tag>
class Piecewise_rbf_implicit_function
{
  typedef Anisotropic_hde_remeshing::internal::Value_and_gradient Value_and_gradient;

public:
  typedef GeomTraits Geom_traits;
  typedef typename GeomTraits::FT FT;
  typedef typename GeomTraits::Point_3 Point_3;
  typedef typename GeomTraits::Vector_3 Vector_3;
  /// the function of a region that is neither plane nor small
  typedef Rbf_implicit_function<GeomTraits, RadialFunction, ConcurrencyTag> Field;

  /*!
  The function of one region, negative inside.

  \cgalModels{ImplicitFunctionWithGradient}
  */
  class Piece
  {
    typedef Anisotropic_hde_remeshing::internal::Region_function<
        Anisotropic_hde_remeshing::internal::Rbf_field<RadialFunction, ConcurrencyTag>>
        Function;

  public:
    typedef typename GeomTraits::FT FT;
    typedef typename GeomTraits::Point_3 Point_3;
    typedef typename GeomTraits::Vector_3 Vector_3;
    typedef Point_3 Point; ///< as the concept `ImplicitFunction` calls it

    // a move would leave a piece without data
    Piece(const Piece&) = default;
    Piece& operator=(const Piece&) = default;

    /// the kind of the function
    Anisotropic_hde_remeshing::Piece_kind kind() const { return m_function.kind(); }

    /// the interpolant, if the kind is `Piece_kind::FIELD`; else a null pointer
    const Field* field() const { return m_field ? &*m_field : nullptr; }

    /*!
    the value at `p`, in the unit of the coordinates

    \throw std::invalid_argument here and in the functions below if a coordinate of `p` is not finite
    */
    FT operator()(const Point_3& p) const { return field() != nullptr ? (*field())(p) : FT(evaluate(p).value); }

    /// the gradient at `p`, outward, of length close to 1 near the surface
    Vector_3 gradient(const Point_3& p) const
    {
      return field() != nullptr ? field()->gradient(p) : to_vector_3(evaluate(p).gradient);
    }

    /// the value and the gradient at `p`, in the time of one
    std::pair<FT, Vector_3> value_and_gradient(const Point_3& p) const
    {
      if (field() != nullptr)
        return field()->value_and_gradient(p);
      const Value_and_gradient result = evaluate(p);
      return std::make_pair(FT(result.value), to_vector_3(result.gradient));
    }

  private:
    friend class Piecewise_rbf_implicit_function;

    explicit Piece(Function function) : m_function(std::move(function))
    {
      if (auto field = m_function.field())
        m_field.emplace(Field(std::move(field)));
    }

    // of a piece that is no field
    Value_and_gradient evaluate(const Point_3& p) const
    {
      return m_function(Anisotropic_hde_remeshing::internal::to_vector(p));
    }

    static Vector_3 to_vector_3(const Anisotropic_hde_remeshing::internal::Vector& v)
    {
      return Vector_3(FT(v[0]), FT(v[1]), FT(v[2]));
    }

    Function m_function;
    std::optional<Field> m_field;
  };

  /*!
  builds the functions of the regions of a mesh.

  \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
  \tparam FaceRegionMap a model of `ReadablePropertyMap` with the faces of `tmesh` as keys and values that are convertible to
          `std::size_t`
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param tmesh the mesh, whose isolated vertices are ignored
  \param face_region the regions of the faces, numbered from 0 on without a gap
  \param np optional named parameters among the ones below, and those of the constructor of `Rbf_implicit_function` for a mesh.
         Only `vertex_normal_map` and `close_holes` are not used: a vertex at a crease has several normals, and regions end there.

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_patches}
      \cgalParamDescription{the number for all regions together. Each region has its share, in proportion to its vertices, but
                            at least one.}
      \cgalParamDefault{one for 25 points}
    \cgalParamNEnd
    \cgalParamNBegin{visitor}
      \cgalParamDescription{its `go_further()` is asked every few milliseconds, and may stop the construction. Its `progress()`
                            gets the share of the construction that is done, from 0 to 1.}
      \cgalParamType{a model of `RemeshingVisitor`}
      \cgalParamDefault{`Anisotropic_hde_remeshing::Remeshing_visitor`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throw Anisotropic_hde_remeshing::Interrupted if the visitor stops the construction
  \throw std::invalid_argument if there are no faces, a region below the largest number has no face, a coordinate is not finite,
         or a parameter is out of its range; the message names it
  */
  template <typename TriangleMesh, typename FaceRegionMap, typename NamedParameters = parameters::Default_named_parameters>
  Piecewise_rbf_implicit_function(const TriangleMesh& tmesh, const FaceRegionMap face_region,
                                  const NamedParameters& np = parameters::default_values())
  {
    if constexpr (accepts<TriangleMesh, FaceRegionMap, NamedParameters>())
      build(tmesh, face_region, np);
  }

  // a move would leave a function without pieces
  Piecewise_rbf_implicit_function(const Piecewise_rbf_implicit_function&) = default;
  Piecewise_rbf_implicit_function& operator=(const Piecewise_rbf_implicit_function&) = default;

  /// the number of regions
  std::size_t number_of_pieces() const { return m_data->pieces.size(); }

  /// the function of region `i`, less than `number_of_pieces()`. The reference is valid as long as a copy of this object
  /// exists.
  const Piece& piece(const std::size_t i) const { return m_data->pieces[i]; }

  /// what the construction did
  const Anisotropic_hde_remeshing::Piecewise_rbf_diagnostics& diagnostics() const { return m_data->diagnostics; }

private:
  struct Data
  {
    std::vector<Piece> pieces;
    Anisotropic_hde_remeshing::Piecewise_rbf_diagnostics diagnostics;
  };

  // whether the types of the arguments are accepted
  template <typename TriangleMesh, typename FaceRegionMap, typename NamedParameters>
  static constexpr bool accepts()
  {
    namespace internal = Anisotropic_hde_remeshing::internal;
    if constexpr (!internal::accepts_mesh<TriangleMesh>())
      return false;
    else
    {
      constexpr bool has_regions =
          std::is_convertible<internal::Value_of_map<FaceRegionMap, internal::Face_of<TriangleMesh>>, std::size_t>::value;
      static_assert(has_regions, "face_region must be a property map from the faces of the mesh to std::size_t");
      return has_regions &&
             internal::accepts_parameters<internal::Parameters_of_function_of_mesh, TriangleMesh, NamedParameters>();
    }
  }

  template <typename TriangleMesh, typename FaceRegionMap, typename NamedParameters>
  void build(const TriangleMesh& tmesh, const FaceRegionMap face_region, const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    namespace internal = Anisotropic_hde_remeshing::internal;
    Real_timer timer;
    timer.start();
    const internal::Region_parameters<RadialFunction> parameters = region_parameters(np); // throws if one is wrong
    Anisotropic_hde_remeshing::Remeshing_visitor nobody;
    internal::Visitor_parameter<NamedParameters> visitor = internal::visitor_parameter(np, nobody);
    internal::Interruption interruption([&visitor] { return visitor.go_further(); },
                                        [&visitor](const double share) { visitor.progress(share); });
    const std::vector<internal::Region_mesh> regions = internal::split_regions(
        tmesh, choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh)),
        face_region, interruption);
    interruption.report(internal::share_of_sample);
    const auto data = std::make_shared<Data>();
    for (auto& function : internal::build_region_functions<ConcurrencyTag>(regions, parameters, interruption))
    {
      function.add_to(data->diagnostics);
      data->pieces.push_back(Piece(std::move(function)));
    }
    data->diagnostics.seconds = timer.time();
    m_data = data;
    interruption.report(1);
  }

  template <typename NamedParameters>
  static Anisotropic_hde_remeshing::internal::Region_parameters<RadialFunction> region_parameters(const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    namespace internal = Anisotropic_hde_remeshing::internal;
    internal::Region_parameters<RadialFunction> result;
    result.interpolation = internal::interpolation_parameters(
        Anisotropic_hde_remeshing::parameters::begin_with(np).vertex_normal_map(internal_np::Param_not_found()));
    result.interpolation.closes_holes = false;
    result.function =
        choose_parameter(get_parameter(np, Anisotropic_hde_remeshing::internal_np::radial_function), RadialFunction());
    if constexpr (internal::keeps_long_facets<NamedParameters>)
    {
      result.keeps_long_facets = true;
      result.has_mesh_long_facets = get_parameter(np, internal::Keeps_long_facets());
    }
    return result;
  }

  std::shared_ptr<const Data> m_data;
};

} // namespace CGAL

#endif // CGAL_PIECEWISE_RBF_IMPLICIT_FUNCTION_H
