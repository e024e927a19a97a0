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
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/named_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_plane.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Uneven_region.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/split_regions.h>
#include <CGAL/Radial_basis_functions.h>
#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

Signed functions, one for each region of a triangle mesh. Their zero sets together are a surface with sharp edges: each zero set
is smooth, and the edges are where two of them meet.

The regions are those of `Anisotropic_hde_remeshing::detect_surface_regions()`, or any other parts of the mesh. A vertex at a
crease belongs to all regions there, and has the normal of each. The function of a region is
- the signed distance to a plane, if all points of the region are in one up to 5 millionths of the size of the mesh. That is the
  rounding of files with six digits.
- else an `Rbf_implicit_function` of the faces of the region. The edges of a region may be much longer in one direction than in
  the other, as those of a cylinder of two rows of vertices. Its function is one of points with normals, and points are added on
  curves over the long edges.
- the signed distance to the facets of the region, if it has less than 10 vertices, if no function by radial basis functions can be
  built from it, or if that misses more than 2% of the area of the facets. At their boundary the distance goes on along the tangent
  planes.

All of them go on smoothly beyond the boundary of the region: planes without an end, facets along their tangents, fields for two
and a half local spacings.

Copies are cheap: they share the data, which never change. All members are thread-safe. The function does not depend on the
number of threads that built it. Large regions are built one after another, each in parallel. Small regions are built in
parallel with each other.

The construction takes time linear in the number of points. An evaluation takes the time of one of `Rbf_implicit_function`.

\tparam GeomTraits a kernel; computations are in `double` whatever its number type
\tparam RadialFunction a model of `RadialBasisFunction`, such as `Polyharmonic_rbf`
\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`

\cgalModels `PiecewiseImplicitFunction`
*/
template <typename GeomTraits, typename RadialFunction = Polyharmonic_rbf, typename ConcurrencyTag = Parallel_if_available_tag>
class Piecewise_rbf_implicit_function
{
  typedef Anisotropic_hde_remeshing::internal::Vector Vector;
  typedef Anisotropic_hde_remeshing::internal::Value_and_gradient Value_and_gradient;
  typedef Anisotropic_hde_remeshing::internal::Region_mesh Region_mesh;
  typedef Anisotropic_hde_remeshing::internal::Region_plane Region_plane;
  typedef Anisotropic_hde_remeshing::internal::Region_facets Region_facets;
  typedef Anisotropic_hde_remeshing::internal::Interruption Interruption;

  // the largest distance of points to the plane of their region, as a share of the size of the mesh
  static constexpr double planarity = 5e-6;
  // of a region with a field
  static constexpr std::size_t least_number_of_vertices = 10;
  // A field misses a facet if one of these is out of bounds: the distance of the zero set from the centroid of the facet, over
  // the longest edge of the facet (an arc of 90 degrees has .2), and the cosine between the normals of both.
  static constexpr double largest_height = 0.2, least_cosine = 0.5;
  // the largest share of the area of a region that its field may miss
  static constexpr double largest_share_of_missed_facets = 0.02;
  // a region of so many vertices is worth all threads
  static constexpr std::size_t large_number_of_vertices = 2000;

public:
  typedef GeomTraits Geom_traits;
  typedef typename GeomTraits::FT FT;
  typedef typename GeomTraits::Point_3 Point_3;
  typedef typename GeomTraits::Vector_3 Vector_3;
  /// the function of a region that is neither plane nor small
  typedef Rbf_implicit_function<GeomTraits, RadialFunction, ConcurrencyTag> Field;

  /*!
  The function of one region, negative inside.

  \cgalModels `ImplicitFunctionWithGradient`
  */
  class Piece
  {
    struct Nothing
    {
      Value_and_gradient operator()(const Vector&) const { return Value_and_gradient{{1.}, Vector::Zero()}; }
    };

  public:
    typedef typename GeomTraits::FT FT;
    typedef typename GeomTraits::Point_3 Point_3;
    typedef typename GeomTraits::Vector_3 Vector_3;
    typedef Point_3 Point; ///< as the concept `ImplicitFunction` calls it

    /// what it is
    Anisotropic_hde_remeshing::Piece_kind kind() const
    {
      using Anisotropic_hde_remeshing::Piece_kind;
      static constexpr Piece_kind kinds[] = {Piece_kind::NONE, Piece_kind::PLANE, Piece_kind::CLOSEST_POINT, Piece_kind::FIELD};
      return kinds[m_function.index()];
    }

    /// the interpolant, if the kind is `Piece_kind::FIELD`; else a null pointer
    const Field* field() const { return std::get_if<Field>(&m_function); }

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

    /// both, in the time of one
    std::pair<FT, Vector_3> value_and_gradient(const Point_3& p) const
    {
      if (field() != nullptr)
        return field()->value_and_gradient(p);
      const Value_and_gradient result = evaluate(p);
      return std::make_pair(FT(result.value), to_vector_3(result.gradient));
    }

  private:
    friend class Piecewise_rbf_implicit_function;

    // of a piece that is no field
    Value_and_gradient evaluate(const Point_3& p) const
    {
      const Vector point = Anisotropic_hde_remeshing::internal::to_vector(p);
      if (!point.allFinite())
        throw std::invalid_argument("the implicit function is asked for a point whose coordinates are not finite");
      if (const auto* plane = std::get_if<Region_plane>(&m_function))
        return (*plane)(point);
      if (const auto* facets = std::get_if<std::shared_ptr<const Region_facets>>(&m_function))
        return (**facets)(point);
      return Nothing()(point);
    }

    static Vector_3 to_vector_3(const Vector& v) { return Vector_3(FT(v[0]), FT(v[1]), FT(v[2])); }

    std::variant<Nothing, Region_plane, std::shared_ptr<const Region_facets>, Field> m_function;
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
         Only `vertex_normal_map` is not used: a vertex at a crease has several normals.

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
      \cgalParamDescription{its `go_further()` is asked every few milliseconds, and may stop the construction}
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
    Real_timer timer;
    timer.start();
    Anisotropic_hde_remeshing::internal::interpolation_parameters(np); // throws if one is wrong
    auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Anisotropic_hde_remeshing::Remeshing_visitor());
    Interruption interruption([&visitor] { return visitor.go_further(); });
    const std::vector<Region_mesh> regions = Anisotropic_hde_remeshing::internal::split_regions(
        tmesh, choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh)),
        face_region, interruption);
    const auto data = std::make_shared<Data>();
    data->pieces.resize(regions.size());
    build_pieces(regions, np, interruption, data->pieces);
    data->diagnostics = summary(data->pieces);
    data->diagnostics.seconds = timer.time();
    m_data = data;
  }

  // The visitor of a region. Only the thread of the caller may ask the caller's visitor. In other threads, this one only tells
  // whether the caller has asked to stop.
  class Visitor_of_region : public Anisotropic_hde_remeshing::Remeshing_visitor
  {
  public:
    explicit Visitor_of_region(Interruption& interruption) : m_interruption(&interruption) {}

    bool go_further()
    {
      return !(std::this_thread::get_id() == m_owner ? m_interruption->ask() : m_interruption->is_requested());
    }

  private:
    Interruption* m_interruption;
    std::thread::id m_owner = std::this_thread::get_id();
  };

  // Large regions are built one after another, each by all threads. The thread of the caller asks the visitor, so it must not
  // be busy with the region of another thread. Small regions are built at the same time. No exception may leave their loop: it
  // would cancel the loops inside, which do not notice.
  template <typename NamedParameters>
  static void build_pieces(const std::vector<Region_mesh>& regions, const NamedParameters& np, Interruption& interruption,
                           std::vector<Piece>& pieces)
  {
    Bbox_3 box;
    std::size_t number_of_vertices = 0;
    std::vector<std::size_t> small;
    for (const Region_mesh& region : regions)
    {
      box += Polygon_mesh_processing::bbox(region);
      number_of_vertices += region.number_of_vertices();
    }
    const double size = Anisotropic_hde_remeshing::internal::diagonal_of(box);
    const Visitor_of_region visitor(interruption);
    const auto build_one = [&](const std::size_t i)
    {
      const double share = double(regions[i].number_of_vertices()) / double(number_of_vertices);
      pieces[i] = build_piece(regions[i], planarity * size, with_share_of_patches(np, share), visitor, interruption);
    };
    for (std::size_t i = 0; i < regions.size(); ++i)
      if (regions[i].number_of_vertices() < large_number_of_vertices)
        small.push_back(i);
      else
        build_one(i);
    std::vector<std::exception_ptr> exceptions(small.size());
    Anisotropic_hde_remeshing::internal::parallel_for<ConcurrencyTag>(
        small.size(),
        [&](const std::size_t k)
        {
          try
          {
            build_one(small[k]);
          }
          catch (...)
          {
            exceptions[k] = std::current_exception();
          }
        },
        1, interruption);
    interruption.check();
    for (const std::exception_ptr& exception : exceptions)
      if (exception)
        std::rethrow_exception(exception);
  }

  template <typename NamedParameters>
  static auto with_share_of_patches(const NamedParameters& np, const double share)
  {
    if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::number_of_patches_t>::value)
      return np;
    else
    {
      const double n = double(parameters::get_parameter(np, internal_np::number_of_patches));
      return np.number_of_patches(std::size_t((std::max)(1., std::round(share * n))));
    }
  }

  template <typename NamedParameters>
  static Piece build_piece(const Region_mesh& region, const double tolerance, const NamedParameters& np,
                           const Visitor_of_region& visitor, Interruption& interruption)
  {
    Piece piece;
    if (const auto plane = Anisotropic_hde_remeshing::internal::plane_of(region, tolerance))
    {
      piece.m_function = *plane;
      return piece;
    }
    if (region.number_of_vertices() >= least_number_of_vertices)
    {
      try
      {
        const Field_piece field = field_of(region, np.visitor(visitor));
        if (field.missed <= largest_share_of_missed_facets)
          return field.piece;
      }
      catch (const std::invalid_argument&) // parameters and points are checked already: no face has an area
      {
      }
    }
    const auto facets = std::make_shared<const Region_facets>(Anisotropic_hde_remeshing::internal::sample_mesh(
        region, get(vertex_point, region), internal_np::Param_not_found(), interruption));
    if (!facets->empty())
      piece.m_function = facets;
    return piece;
  }

  // a piece that is a field, and what share of the facets it misses
  struct Field_piece
  {
    Piece piece;
    double missed = 0;
  };

  // If the vertices are spread unevenly, the field is one of points between them, too. If it misses facets, a field of the
  // vertices alone is built as well. The patches of that field are checked, and the facets answer where a patch fails. The
  // field that misses less is returned.
  template <typename NamedParameters>
  static Field_piece field_of(const Region_mesh& region, const NamedParameters& np)
  {
    Field_piece of_points, of_vertices;
    const auto points = Anisotropic_hde_remeshing::internal::Uneven_region(region).points();
    if (!points.empty())
    {
      of_points.piece.m_function.template emplace<Field>(points, np);
      of_points.missed = share_of_missed_facets(of_points.piece, region);
      if (of_points.missed == 0)
        return of_points;
    }
    of_vertices.piece.m_function.template emplace<Field>(
        region, np.vertex_point_map(get(vertex_point, region)).vertex_normal_map(internal_np::Param_not_found()));
    of_vertices.missed = share_of_missed_facets(of_vertices.piece, region);
    return points.empty() || of_vertices.missed < of_points.missed ? of_vertices : of_points;
  }

  // the share of the area of the facets at whose centroid the zero set is far away or turned
  static double share_of_missed_facets(const Piece& piece, const Region_mesh& region)
  {
    double area = 0, missed = 0;
    for (const auto f : region.faces())
    {
      const auto h = region.halfedge(f);
      const Vector a = to_vector(region.point(region.source(h))), b = to_vector(region.point(region.target(h))),
                   c = to_vector(region.point(region.target(region.next(h)))), normal = (b - a).cross(c - a);
      const double longest = std::sqrt((std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
      const Vector centroid = (a + b + c) / 3;
      const Value_and_gradient at_centroid = Anisotropic_hde_remeshing::internal::value_and_gradient_of(piece, centroid);
      const double slope = at_centroid.gradient.norm();
      const bool is_met = std::abs(at_centroid.value) <= largest_height * longest * slope &&
                          at_centroid.gradient.dot(normal) >= least_cosine * slope * normal.norm();
      area += normal.norm();
      missed += is_met ? 0 : normal.norm();
    }
    return area > 0 ? missed / area : 0;
  }

  template <typename Point>
  static Vector to_vector(const Point& p)
  {
    return Anisotropic_hde_remeshing::internal::to_vector(p);
  }

  static Anisotropic_hde_remeshing::Piecewise_rbf_diagnostics summary(const std::vector<Piece>& pieces)
  {
    using Anisotropic_hde_remeshing::Piece_kind;
    Anisotropic_hde_remeshing::Piecewise_rbf_diagnostics result;
    result.number_of_regions = pieces.size();
    for (const Piece& piece : pieces)
    {
      result.memory_bytes += sizeof(Piece);
      result.number_of_planes += piece.kind() == Piece_kind::PLANE ? 1 : 0;
      result.number_of_regions_without_area += piece.kind() == Piece_kind::NONE ? 1 : 0;
      if (piece.kind() == Piece_kind::CLOSEST_POINT)
      {
        ++result.number_of_closest_point_regions;
        result.memory_bytes += std::get<std::shared_ptr<const Region_facets>>(piece.m_function)->memory_bytes();
      }
      if (piece.field() != nullptr)
        add(piece.field()->diagnostics(), result);
    }
    return result;
  }

  static void add(const Anisotropic_hde_remeshing::Rbf_diagnostics& field,
                  Anisotropic_hde_remeshing::Piecewise_rbf_diagnostics& result)
  {
    ++result.number_of_fields;
    result.number_of_points += field.number_of_points;
    result.number_of_patches += field.number_of_patches;
    result.patches_repaired += field.patches_repaired;
    result.patches_on_fallback += field.patches_on_fallback;
    result.number_of_failed_checks += field.number_of_failed_checks;
    result.worst_residual = (std::max)(result.worst_residual, field.worst_residual);
    result.worst_value_residual = (std::max)(result.worst_value_residual, field.worst_value_residual);
    result.worst_condition = (std::max)(result.worst_condition, field.worst_condition);
    result.memory_bytes += field.memory_bytes;
  }

  std::shared_ptr<const Data> m_data;
};

} // namespace CGAL

#endif // CGAL_PIECEWISE_RBF_IMPLICIT_FUNCTION_H
