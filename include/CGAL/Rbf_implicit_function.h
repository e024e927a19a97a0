// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_RBF_IMPLICIT_FUNCTION_H
#define CGAL_RBF_IMPLICIT_FUNCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Patchwise_interpolant.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_points.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/named_parameters.h>
#include <CGAL/Radial_basis_functions.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

The signed function whose zero set is a smooth surface through the points of a triangle mesh, or through points with normals,
by radial basis functions. It is negative inside and grows outward; near the surface it is close to the signed distance.

The points are distributed over patches that overlap. Each patch interpolates the value 0 at its points and the value
\f$ \varepsilon_i \f$ at the off-surface points \f$ x_i + \varepsilon_i n_i \f$; the patches are solved in parallel and blended
into one function, twice continuously differentiable with `Polyharmonic_rbf`, by smooth weights that sum to one.

Copies are cheap: they share the data, which never change. All members are thread-safe. The function does not depend on the
number of threads that built it.

The construction takes time linear in the number of points (cubic in the number of points of a patch), an evaluation a time
that does not depend on the number of points but for the depth of the tree of patches.

\tparam GeomTraits a kernel; computations are in `double` whatever its number type
\tparam RadialFunction a model of `RadialBasisFunction`, such as `Polyharmonic_rbf` or `Thin_plate_rbf`
\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`

\cgalModels `ImplicitFunctionWithGradient`, hence `ImplicitFunction`
*/
template <typename GeomTraits, typename RadialFunction = Polyharmonic_rbf,
          typename ConcurrencyTag = Parallel_if_available_tag>
class Rbf_implicit_function
{
  typedef Anisotropic_hde_remeshing::internal::Patchwise_interpolant<RadialFunction, ConcurrencyTag> Interpolant;
  typedef Anisotropic_hde_remeshing::internal::Surface_sample Surface_sample;
  typedef Anisotropic_hde_remeshing::internal::Value_and_gradient Value_and_gradient;

  // boost::graph_traits of a type that is no graph is a hard error: a range is told by its iterator
  template <typename T, typename = void>
  struct Is_range : std::false_type
  {};
  template <typename T>
  struct Is_range<T, std::void_t<typename T::const_iterator>> : std::true_type
  {};

public:
  typedef GeomTraits Geom_traits;
  typedef typename GeomTraits::FT FT;
  typedef typename GeomTraits::Point_3 Point_3;
  typedef typename GeomTraits::Vector_3 Vector_3;
  typedef typename GeomTraits::Sphere_3 Sphere_3;
  typedef Point_3 Point; ///< as the concept `ImplicitFunction` calls it

  /*!
  builds the function from the vertices of a triangle mesh, or from a range of points with normals.

  \tparam MeshOrPointRange a model of `FaceListGraph` and `HalfedgeGraph`, or a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param input the mesh, whose isolated vertices are ignored, or the points
  \param np optional named parameters among the ones below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices, if `input` is a mesh}
      \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, input)`}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_normal_map}
      \cgalParamDescription{the outward normals of the vertices, of any length, if `input` is a mesh}
      \cgalParamDefault{the mean of the normals of the incident faces, weighted by their angles}
    \cgalParamNEnd
    \cgalParamNBegin{point_map}
      \cgalParamDescription{the points, if `input` is a range}
      \cgalParamDefault{`First_of_pair_property_map`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{the outward normals, of any length, if `input` is a range}
      \cgalParamDefault{`Second_of_pair_property_map`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_patches}
      \cgalParamDescription{the paper's K; patches that uneven sampling makes too large are split further}
      \cgalParamDefault{one for 25 points}
    \cgalParamNEnd
    \cgalParamNBegin{patch_overlap}
      \cgalParamDescription{the paper's Ov: how far beyond its zone of influence a patch gathers points, in units of the local
                            distance between points}
      \cgalParamDefault{3}
    \cgalParamNEnd
    \cgalParamNBegin{offset_distance}
      \cgalParamDescription{the paper's \f$ \varepsilon \f$, one for all points, in the unit of the coordinates}
      \cgalParamDefault{0.05 of the local distance between points}
    \cgalParamNEnd
    \cgalParamNBegin{radial_function}
      \cgalParamDescription{the object of type `RadialFunction`}
      \cgalParamDefault{`RadialFunction()`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throw std::invalid_argument if there are no points, a coordinate is not finite, all normals are zero, or a parameter is out
         of its range; the message names it
  */
  template <typename MeshOrPointRange, typename NamedParameters = parameters::Default_named_parameters,
            typename = std::enable_if_t<!std::is_base_of<Rbf_implicit_function, MeshOrPointRange>::value>>
  explicit Rbf_implicit_function(const MeshOrPointRange& input, const NamedParameters& np = parameters::default_values())
  {
    const auto parameters = interpolation_parameters(np);
    const RadialFunction function =
        parameters::choose_parameter(parameters::get_parameter(np, internal_np::radial_function), RadialFunction());
    const Surface_sample sample = sample_input(input, np, Is_range<MeshOrPointRange>());
    check_sample(sample);
    compute_bounding_sphere(sample);
    m_interpolant = std::make_shared<const Interpolant>(sample, parameters, function);
  }

  /// the value at `p`, in the unit of the coordinates
  FT operator()(const Point_3& p) const { return FT(evaluate(p).value); }

  /// the gradient at `p`, outward, of length close to 1 near the surface
  Vector_3 gradient(const Point_3& p) const { return to_vector_3(evaluate(p).gradient); }

  /// both, in the time of one
  std::pair<FT, Vector_3> value_and_gradient(const Point_3& p) const
  {
    const Value_and_gradient result = evaluate(p);
    return std::make_pair(FT(result.value), to_vector_3(result.gradient));
  }

  /// a sphere that contains the zero set near the points
  Sphere_3 bounding_sphere() const
  {
    return Sphere_3(Point_3(FT(m_centre[0]), FT(m_centre[1]), FT(m_centre[2])), FT(m_squared_radius));
  }

  /// what the construction did
  const Anisotropic_hde_remeshing::Rbf_diagnostics& diagnostics() const { return m_interpolant->diagnostics(); }

private:
  Value_and_gradient evaluate(const Point_3& p) const
  {
    return (*m_interpolant)({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }

  static Vector_3 to_vector_3(const Eigen::Vector3d& v) { return Vector_3(FT(v[0]), FT(v[1]), FT(v[2])); }

  template <typename NamedParameters>
  static Anisotropic_hde_remeshing::internal::Interpolation_parameters interpolation_parameters(const NamedParameters& np)
  {
    using namespace Anisotropic_hde_remeshing::internal;
    using parameters::get_parameter;
    using parameters::is_default_parameter;
    Interpolation_parameters result;
    if constexpr (!is_default_parameter<NamedParameters, internal_np::number_of_patches_t>::value)
      result.number_of_patches =
          checked_count("number_of_patches", get_parameter(np, internal_np::number_of_patches));
    if constexpr (!is_default_parameter<NamedParameters, internal_np::patch_overlap_t>::value)
      result.patch_overlap = checked_not_negative(
          "patch_overlap", CGAL::to_double(get_parameter(np, internal_np::patch_overlap)));
    if constexpr (!is_default_parameter<NamedParameters, internal_np::offset_distance_t>::value)
      result.absolute_offset =
          checked_positive("offset_distance", CGAL::to_double(get_parameter(np, internal_np::offset_distance)));
    return result;
  }

  template <typename TriangleMesh, typename NamedParameters>
  static Surface_sample sample_input(const TriangleMesh& tmesh, const NamedParameters& np, std::false_type)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    return Anisotropic_hde_remeshing::internal::sample_mesh(
        tmesh,
        choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh)),
        get_parameter(np, internal_np::vertex_normal_map));
  }

  template <typename PointRange, typename NamedParameters>
  static Surface_sample sample_input(const PointRange& points, const NamedParameters& np, std::true_type)
  {
    return Anisotropic_hde_remeshing::internal::sample_points<ConcurrencyTag>(points, point_map<PointRange>(np),
                                                                              normal_map<PointRange>(np));
  }

  // the defaults are instantiated only where they are used: they ask for pairs
  template <typename PointRange, typename NamedParameters>
  static auto point_map(const NamedParameters& np)
  {
    if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::point_t>::value)
      return First_of_pair_property_map<typename PointRange::value_type>();
    else
      return parameters::get_parameter(np, internal_np::point_map);
  }

  template <typename PointRange, typename NamedParameters>
  static auto normal_map(const NamedParameters& np)
  {
    if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value)
      return Second_of_pair_property_map<typename PointRange::value_type>();
    else
      return parameters::get_parameter(np, internal_np::normal_map);
  }

  static void check_sample(const Surface_sample& sample)
  {
    if (sample.size() == 0)
      throw std::invalid_argument("the input has no points");
    bool has_normal = false, has_spacing = false;
    for (std::size_t i = 0; i < sample.size(); ++i)
    {
      has_normal = has_normal || !sample.normals[i].isZero(0);
      has_spacing = has_spacing || sample.spacings[i] > 0;
    }
    if (!has_normal || !has_spacing)
      throw std::invalid_argument("the input has no point with a normal: all its faces are degenerate");
  }

  void compute_bounding_sphere(const Surface_sample& sample)
  {
    Eigen::Vector3d low = sample.points.front(), high = low;
    for (const Eigen::Vector3d& p : sample.points)
    {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    m_centre = 0.5 * (low + high);
    m_squared_radius = 1.1 * 1.1 * 0.25 * (high - low).squaredNorm(); // the zero set bulges between the points
  }

  std::shared_ptr<const Interpolant> m_interpolant;
  Eigen::Vector3d m_centre;
  double m_squared_radius = 0;
};

} // namespace CGAL

#endif // CGAL_RBF_IMPLICIT_FUNCTION_H
