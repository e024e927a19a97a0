// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_SIZED_EMBEDDING_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_SIZED_EMBEDDING_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/text_of_number.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

namespace internal {

// Throws std::invalid_argument if the size wanted at `p` is not positive and finite.
inline double checked_size(const double size, const Eigen::Vector3d& p)
{
  if (!(std::isfinite(size) && size > 0))
    throw_invalid_argument("the size wanted at (" + text_of_number(p[0]) + ", " + text_of_number(p[1]) + ", " +
                               text_of_number(p[2]) + ") by the sizing field",
                           size, "finite and positive");
  return size;
}

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingEmbeddings

An embedding in which lengths are relative to a size. The size is the length that edges shall have at each place, measured in an
underlying embedding. With the target edge length 1, edges have that size. With a number of faces, only the proportions of the
sizes count. The length of an edge is that in the underlying embedding over the geometric mean of the sizes at its ends. Sizes
should change by no more than half of a length over that length. Triangles become thin where they change faster. The named
parameter `sizing_field` of `CGAL::anisotropic_hde_remeshing()` makes such an embedding.

\tparam Point the type of the points that the sizes are asked for, with a constructor from three `double`
\tparam Sizing_field a function object with `size(Point) const`, which returns a positive number, a length in the unit of the
       mesh, is defined on and near the surface, and may be called concurrently. `Interpolated_vertex_field` makes one of a
       property of the vertices of the input.
\tparam Embedding a model of `RemeshingEmbedding` whose lengths are in the unit of the mesh. `Normal_embedding(0)` makes triangles
        equilateral in space.

\cgalModels{RemeshingEmbedding}

\sa `sized_embedding()`
*/
template <typename Point, typename Sizing_field, typename Embedding = Normal_embedding>
class Sized_embedding
{
public:
  /// the data of the underlying embedding, and the size
  struct Vertex_data : Embedding::Vertex_data
  {
    double size = 1;
  };

  Sized_embedding(const Sizing_field& size, const Embedding& embedding) : m_embedding(embedding), m_size(size)
  {
    static_assert(std::is_invocable<const Sizing_field&, const Point&>::value,
                  "the sizing field must be a function object that takes a point");
  }

  /// the underlying embedding, in the unit of this one
  const Embedding& embedding() const { return m_embedding; }

  /// the same for a mesh in another unit of length
  Sized_embedding in_unit(const double unit) const
  {
    Sized_embedding result(m_size, m_embedding.in_unit(unit));
    result.m_unit = m_unit * unit;
    result.m_unit_of_lengths = m_unit_of_lengths * m_embedding.unit_of_lengths(unit);
    return result;
  }

  /// 1: the lengths are relative
  double unit_of_lengths(double) const { return 1; }

  /// evaluates the size
  /// \throw std::invalid_argument if it is not positive and finite
  template <typename Vertex>
  void place(Vertex& vertex) const
  {
    m_embedding.place(vertex);
    set_size(vertex);
  }

  /// evaluates the size
  template <typename Vertex>
  void place_between(const Vertex& a, const Vertex& b, Vertex& middle) const
  {
    m_embedding.place_between(a, b, middle);
    set_size(middle);
  }

  template <typename Vertex>
  double squared_length(const Vertex& a, const Vertex& b) const
  {
    return m_embedding.squared_length(a, b) / (a.size * b.size);
  }

  /// the centroid in the underlying embedding, with areas in this one
  template <typename Vertex>
  class Centroid : public Embedding::template Centroid<Vertex>
  {
  public:
    Centroid(const Sized_embedding& embedding, const Vertex& center, const Eigen::Matrix<double, 3, 2>& frame)
      : Embedding::template Centroid<Vertex>(embedding.m_embedding, center, frame)
    {
    }
  };

private:
  template <typename Vertex>
  void set_size(Vertex& vertex) const
  {
    const Eigen::Vector3d p = m_unit * vertex.point;
    const double size = internal::checked_size(CGAL::to_double(m_size(Point(p[0], p[1], p[2]))), p);
    vertex.size = size / m_unit_of_lengths;
  }

  Embedding m_embedding;
  double m_unit = 1;            // of the points here, in the unit of the points that the sizes are asked for
  double m_unit_of_lengths = 1; // of the embedding below, in the same
  Sizing_field m_size;
};

/*!
\ingroup PkgAnisotropicHdeRemeshingEmbeddings

returns an embedding with a size for each place. The type of the points cannot be deduced:

\code{.cpp}
const auto size = [](const Point_3& p) { return p.z() < 0 ? 0.1 : 0.2; };
CGAL::anisotropic_hde_remeshing(mesh, params::embedding(Hde::sized_embedding<Point_3>(size)).target_edge_length(1));
\endcode

\param size the length of edges that is wanted at a point, in the unit of the mesh; see `Sized_embedding`
\param embedding the embedding in which edges have that length. The default is for equilateral triangles in space.
*/
template <typename Point, typename Sizing_field, typename Embedding = Normal_embedding>
auto sized_embedding(const Sizing_field& size, const Embedding& embedding = Normal_embedding(0))
{
  constexpr bool is_embedding = internal::Is_embedding<Embedding, void>::value;
  static_assert(is_embedding, "the second argument must be a model of RemeshingEmbedding, such as Normal_embedding(0)");
  if constexpr (is_embedding)
    return Sized_embedding<Point, std::decay_t<const Sizing_field&>, Embedding>(size, embedding); // a function as a pointer
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_SIZED_EMBEDDING_H
