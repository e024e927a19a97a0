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

#include <CGAL/Anisotropic_hde_remeshing/Principal_curvatures.h>
#include <CGAL/Anisotropic_hde_remeshing/Rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/Smoothing.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Rbf_field.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/input_of_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/visitor_parameter.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>
#include <CGAL/Radial_basis_functions.h>

#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgAnisotropicHdeRemeshingImplicit

A signed function by radial basis functions. Its zero set is a smooth surface through the vertices of a triangle mesh, or
through points with normals. The function is negative inside and grows outward. Near the surface it is close to the signed
distance.

The points are distributed over patches that overlap. Each patch interpolates the value 0 at its points and the value
\f$ \varepsilon_i \f$ at the off-surface points \f$ x_i + \varepsilon_i n_i \f$. The patches are solved in parallel. Smooth
weights that sum to one blend them into one function. It is twice continuously differentiable with `Polyharmonic_rbf`.

<b>Adapted meshes.</b> Simplification adapts a mesh to the shape: it puts vertices off the surface, so that the facets are on it
in the mean. There four points of each facet replace the vertices: the centre, with the normal of the facet, and the points
halfway from it to the vertices, without a normal. These points have a variance on the diagonal of the system, in proportion to
the variation of the kernel over their spacing. So the surface passes near them. A mesh counts as adapted at a vertex under two
conditions on the vertices of some ten rings around it. More than half of them are at an edge longer than 2.5 times the size
there (see below). And along more than a quarter of the edges that are not flat, the normals at both ends do not fit an arc. So
even meshes, and exact samples of smooth surfaces, are interpolated at their vertices. So are the boundary, and all vertices if
`vertex_normal_map` is given. The construction takes one to three times as long.

<b>Points on facets.</b> In meshes of CAD programs long facets meet short ones, and large ones small ones. A smooth surface
through the vertices alone swells between them. There the function also interpolates points on facets: the middles of edges that
are longer than 2.5 times the size there, the longest first, if no point is near. The size is between the least and the mean
altitude of the facets around. It grows by at most half of the way from a smaller one, and less where the surface bends. The
normals of these points are those of the facets. A point is off its facet only if the normals at the vertices indicate a bend:
they turn little, and alike at both ends of each edge. A mesh whose triangles are all about alike gets none of these points. At
most four points are added for a vertex, except in adapted meshes.

<b>Edges.</b> Where facets turn by more than a radian, 57 degrees, across an edge, the surface is not smooth at its own sampling:
it would have to bend as sharply as a facet is wide. A normal between those of the facets would make it swell on both sides. So
vertices and points there have no off-surface points, unless `vertex_normal_map` is given. The surface still rounds the edge off,
within a facet or two. `Piecewise_rbf_implicit_function` keeps the edge.

<b>Check of the facets.</b> In the end the function is checked at the centre of each facet and at the middle of each edge. Let h be
the spacing there. The value may be at most twice the sum of h/10 and the rise of an arc. The arc has the normals at the vertices,
is at most 2 h long, and is at most 17 degrees steep at its ends. Where the value is larger, points are added, and the patches
around are solved again, twice at most. If this fails, the signed distance to the facets replaces the function of the patch, as
described below. With `smoothing` there are no such points and no such check, as vertices and facets are uncertain.
`diagnostics()` counts all of this.

<b>Noise.</b> With `smoothing` the function need not meet the points. It is the most likely one if the points are off the surface
by noise of that standard deviation. In each patch the heights of the points over a plane tell how much the surface bends
(restricted maximum likelihood). A point and its off-surface points are off by the same error. So small offsets still tell the
slope, and normals need not be exact. `AUTOMATIC_SMOOTHING` estimates the noise from the heights in at most 400 patches, and takes
the median. For exact data the estimate is 0, and the data are interpolated. So are data with noise of less than 1/200 of the
spacing. On smooth shapes with Gaussian noise of .03 to .5 spacings the estimate is 0 to 12% too large. Detail that is finer than
a few spacings counts as noise, as on a mesh that was simplified.

<b>Outliers.</b> With `detect_outliers` a point of a range is left out if it is off the tangent planes of all but two of its 12
nearest neighbours. It must be off by more than a fifth of the spacing, and by more than four times the distance that nine tenths
of the points keep. A normal is turned if its neighbours agree on about the opposite one. It is dropped if it is more than 60
degrees off theirs. Smooth shapes, sharp edges and tips are left as they are. Of shapes with detail as fine as the spacing, up to 1
in 200 points was lost. At most a tenth of the points count as outliers, and at most a tenth of the normals as wrong.

<b>Holes.</b> Points may be missing over more than about six spacings, or a mesh may have a hole as wide. Then the function is
closed: it is positive on the `bounding_sphere()` and beyond, so the zero set is bounded. Nothing is changed within a spacing or
two of the data, nor where the data are nearer than half the distance to the rim of a hole. Further away the function passes to a
smooth one from a few hundred well-spread points, so the surface continues smoothly from the rims. This function is positive around
the whole, and negative where most directions look at the inside of the surface. `distance_to_data()` tells how far a place is from
the data. Data without a hole are not changed. See `close_holes`. An evaluation takes 3 to 6 microseconds longer.

<b>Near and far.</b> From 2.5 to 3.5 local spacings away from the points the function passes to the signed distance to the input:
to the facets of a mesh, or to the tangent planes of the nearest points. Interpolants would only extrapolate there, and might
vanish where there is no surface. So the sign is right everywhere for a closed mesh that does not intersect itself, and mesh
generators of CGAL can use the function. The far part is continuous where the distance is. Its gradient is not continuous at
points that are equally far from two parts of the surface. Its Hessian is zero, not that of a distance.

<b>Self-check.</b> After a patch is solved, its function is checked around its facets, or around its points if the input is a
range. The sign is checked at a quarter to twice the local spacing, the gradient and the distance of the zero set at the facets or
points. If there is noise, the sides of a point are those of the zero set near it. A patch that fails in at most a tenth of its
checks is solved again: with smaller offsets, with a little smoothing, and with both smoothing and a wider view. A solution is kept
if it at least halves the number of failures. A patch may still fail in more than a twentieth of its checks, where sampling is too
coarse for the shape. There the function is the signed distance to the input, with a gradient along the interpolated normals of the
input, blended with the neighbouring patches. `diagnostics()` counts these patches.

Copies are cheap: they share the data, which never change. A function that is moved is copied: it can still be used. All members
are thread-safe. The function does not depend on the number of threads that built it.

The construction takes time linear in the number of points, and cubic in the number of points of a patch. The time of an
evaluation depends on the number of points only by the depth of the tree of patches.

\tparam GeomTraits a kernel; computations are in `double` whatever its number type
\tparam RadialFunction a model of `RadialBasisFunction`, such as `Polyharmonic_rbf`
\tparam ConcurrencyTag `Sequential_tag` (the default), `Parallel_tag` or `Parallel_if_available_tag`: how the function is built.
       With the latter two, `RadialFunction` is called from several threads at once. The result is the same.

\cgalModels{ImplicitFunctionWithGradient,ImplicitFunction}
*/
template <typename GeomTraits, typename RadialFunction = Polyharmonic_rbf, typename ConcurrencyTag = Sequential_tag>
class Rbf_implicit_function
{
  typedef Anisotropic_hde_remeshing::internal::Rbf_field<RadialFunction, ConcurrencyTag> Field;
  template <int order>
  using Jet = Anisotropic_hde_remeshing::internal::Jet<order>;

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
      \cgalParamDescription{the paper's K. Patches are split further if uneven sampling makes them too large, or if they have
                            more than 3,000 points and the kernel has no compact support.}
      \cgalParamDefault{one for 25 points}
    \cgalParamNEnd
    \cgalParamNBegin{patch_overlap}
      \cgalParamDescription{the paper's Ov: how far beyond its zone of influence a patch gathers points, in units of the local
                            distance between points}
      \cgalParamDefault{2.4}
    \cgalParamNEnd
    \cgalParamNBegin{offset_distance}
      \cgalParamDescription{the paper's \f$ \varepsilon \f$, one for all points, in the unit of the coordinates}
      \cgalParamDefault{`relative_offset_distance` of the local distance between points}
      \cgalParamExtra{An offset is halved while the off-surface point is nearer to another point of the surface than to its
                      own.}
    \cgalParamNEnd
    \cgalParamNBegin{relative_offset_distance}
      \cgalParamDescription{\f$ \varepsilon_i \f$ in units of the local distance between points. More than 1 makes sheets that
                            the surface does not have.}
      \cgalParamDefault{0.05}
    \cgalParamNEnd
    \cgalParamNBegin{two_sided_offsets}
      \cgalParamDescription{whether to interpolate \f$ -\varepsilon_i \f$ at \f$ x_i - \varepsilon_i n_i \f$, too. It takes
                            three times longer. It is of use with offsets of the size of the local distance between points.}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
    \cgalParamNBegin{smoothing}
      \cgalParamDescription{the standard deviation of the noise of the points, in the unit of the coordinates, or
                            `Anisotropic_hde_remeshing::AUTOMATIC_SMOOTHING`: it is estimated. 0 interpolates.
                            `Rbf_diagnostics::noise` is the estimate. `Rbf_diagnostics::worst_value_residual` is the
                            largest difference between the function and the data.}
      \cgalParamType{a number that is finite and not negative, or `Anisotropic_hde_remeshing::Smoothing`}
      \cgalParamDefault{0}
    \cgalParamNEnd
    \cgalParamNBegin{points_on_facets}
      \cgalParamDescription{if `input` is a mesh: whether to add points on facets that are large for their surroundings, to
                            replace vertices by points on facets where the mesh is adapted to the shape, and to check the
                            function on all facets}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`, but without effect if there is noise}
    \cgalParamNEnd
    \cgalParamNBegin{detect_edges}
      \cgalParamDescription{if `input` is a mesh: whether vertices at which facets turn by more than a radian across an edge, and
                            those at tips of cones and spikes, have no off-surface points}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`, but without effect if there is noise, or with `vertex_normal_map`}
    \cgalParamNEnd
    \cgalParamNBegin{detect_outliers}
      \cgalParamDescription{if `input` is a range: whether points that their neighbours contradict are left out, and such normals
                            are turned or dropped. `Rbf_diagnostics` counts them.}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
    \cgalParamNBegin{close_holes}
      \cgalParamDescription{whether the function is closed where data are missing. Otherwise it continues along the last tangent
                            planes, and the zero set may have no end.}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{radial_function}
      \cgalParamDescription{the object of type `RadialFunction`}
      \cgalParamDefault{`RadialFunction()`}
    \cgalParamNEnd
    \cgalParamNBegin{visitor}
      \cgalParamDescription{its `go_further()` is asked every few milliseconds, and may stop the construction. Its `progress()`
                            gets the share of the construction that is done, from 0 to 1, at least four times.}
      \cgalParamType{a model of `RemeshingVisitor`}
      \cgalParamDefault{`Anisotropic_hde_remeshing::Remeshing_visitor`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throw Anisotropic_hde_remeshing::Interrupted if the visitor stops the construction
  \throw std::invalid_argument if there are no points, a coordinate is not finite, all normals are zero, or a parameter is out
         of its range; the message names it
  */
#ifdef DOXYGEN_RUNNING
  template <typename MeshOrPointRange, typename NamedParameters = parameters::Default_named_parameters>
#else
  template <typename MeshOrPointRange, typename NamedParameters = parameters::Default_named_parameters,
            typename = std::enable_if_t<!std::is_base_of<Rbf_implicit_function, MeshOrPointRange>::value>>
#endif
  explicit Rbf_implicit_function(const MeshOrPointRange& input, const NamedParameters& np = parameters::default_values())
  {
    if constexpr (Anisotropic_hde_remeshing::internal::accepts_input_of_function<RadialFunction, MeshOrPointRange,
                                                                                 NamedParameters>())
      build(input, np);
  }

  // a move would leave a function without data
  Rbf_implicit_function(const Rbf_implicit_function&) = default;
  Rbf_implicit_function& operator=(const Rbf_implicit_function&) = default;

  /*!
  the value at `p`, in the unit of the coordinates

  \throw std::invalid_argument here and in the functions below if a coordinate of `p` is not finite
  */
  FT operator()(const Point_3& p) const { return FT(evaluate<0>(p).value / m_field->scale()); }

  /// the gradient at `p`, outward, of length close to 1 near the surface
  Vector_3 gradient(const Point_3& p) const { return to_vector_3(evaluate<1>(p).gradient); }

  /// the value and the gradient at `p`, in the time of one
  std::pair<FT, Vector_3> value_and_gradient(const Point_3& p) const
  {
    const Jet<1> jet = evaluate<1>(p);
    return std::make_pair(FT(jet.value / m_field->scale()), to_vector_3(jet.gradient));
  }

  /// the matrix of the second derivatives at `p`, symmetric, in the inverse of the unit of the coordinates. `RadialFunction`
  /// must return second derivatives. It takes twice the time of the gradient.
  Eigen::Matrix3d hessian(const Point_3& p) const { return evaluate<2>(p).hessian * m_field->scale(); }

  /*!
  the shape operator at `p` of the level set through it, \f$ S = T H T / |\nabla f| \f$ with the Hessian \f$ H \f$, the unit
  normal \f$ n \f$ and \f$ T = I - n n^T \f$. It is symmetric and has \f$ n \f$ in its kernel. Its other eigenvalues are the
  principal curvatures. They are positive where the surface curves away from the normal, as a sphere does. The operator is zero
  where the gradient vanishes.
  */
  Eigen::Matrix3d shape_operator(const Point_3& p) const
  {
    return Anisotropic_hde_remeshing::internal::shape_operator(evaluate<2>(p)) * m_field->scale();
  }

  /// the principal curvatures and directions at `p` of the level set through it, the eigenvalues and eigenvectors of
  /// `shape_operator()`
  Anisotropic_hde_remeshing::Principal_curvatures<Geom_traits> principal_curvatures(const Point_3& p) const
  {
    return Anisotropic_hde_remeshing::internal::principal_curvatures<Geom_traits>(evaluate<2>(p), m_field->scale());
  }

  /// the number of the patch in whose cell `p` lies, below `Rbf_diagnostics::number_of_patches`. The function at `p` is that of
  /// this patch. Near the planes between cells it is blended with the neighbouring patches.
  std::size_t patch(const Point_3& p) const
  {
    const Eigen::Vector3d point = Anisotropic_hde_remeshing::internal::to_vector(p);
    check_finite(point);
    return m_field->patch(point);
  }

  /// the distance from `p` to the nearest point that was given, in the unit of the coordinates. Far from these the function only
  /// guesses, and one may trim it. The first call builds a tree of the points.
  FT distance_to_data(const Point_3& p) const
  {
    const Eigen::Vector3d point = Anisotropic_hde_remeshing::internal::to_vector(p);
    check_finite(point);
    return FT(m_field->distance_to_data(point));
  }

  /// a sphere that contains the zero set; without `close_holes`, only near the points
  Sphere_3 bounding_sphere() const
  {
    const Eigen::Vector3d& c = m_field->centre();
    const double radius = m_field->radius();
    return Sphere_3(Point_3(FT(c[0]), FT(c[1]), FT(c[2])), FT(radius * radius));
  }

  /// what the construction did
  const Anisotropic_hde_remeshing::Rbf_diagnostics& diagnostics() const { return m_field->diagnostics(); }

private:
  template <typename MeshOrPointRange, typename NamedParameters>
  void build(const MeshOrPointRange& input, const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    namespace internal = Anisotropic_hde_remeshing::internal;
    Real_timer timer;
    timer.start();
    const internal::Interpolation_parameters interpolation = internal::interpolation_parameters(np);
    Anisotropic_hde_remeshing::Remeshing_visitor nobody;
    internal::Visitor_parameter<NamedParameters> visitor = internal::visitor_parameter(np, nobody);
    internal::Interruption interruption([&visitor] { return visitor.go_further(); },
                                        [&visitor](const double share) { visitor.progress(share); });
    const RadialFunction function =
        choose_parameter(get_parameter(np, Anisotropic_hde_remeshing::internal_np::radial_function), RadialFunction());
    m_field = std::make_shared<const Field>(internal::sample_input(input, np, interruption), interpolation, function, timer,
                                            interruption);
  }

  template <int order>
  Jet<order> evaluate(const Point_3& p) const
  {
    return m_field->template evaluate<order>(Anisotropic_hde_remeshing::internal::to_vector(p));
  }

  static void check_finite(const Eigen::Vector3d& point)
  {
    if (!point.allFinite())
      throw std::invalid_argument("the implicit function is asked for a point whose coordinates are not finite");
  }

  static Vector_3 to_vector_3(const Eigen::Vector3d& v) { return Vector_3(FT(v[0]), FT(v[1]), FT(v[2])); }

  template <typename, typename, typename>
  friend class Piecewise_rbf_implicit_function;

  explicit Rbf_implicit_function(std::shared_ptr<const Field> field) : m_field(std::move(field)) {}

  std::shared_ptr<const Field> m_field;
};

} // namespace CGAL

#endif // CGAL_RBF_IMPLICIT_FUNCTION_H
