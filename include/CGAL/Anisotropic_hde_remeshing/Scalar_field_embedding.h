// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_SCALAR_FIELD_EMBEDDING_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_SCALAR_FIELD_EMBEDDING_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

namespace internal {

// the number of values of a field: 1 if it returns a number, the size if it returns an array
template <typename T, typename = void>
struct Field_dimension : std::integral_constant<int, 1>
{
};

template <typename T>
struct Field_dimension<T, std::void_t<decltype(std::tuple_size<T>::value)>>
  : std::integral_constant<int, int(std::tuple_size<T>::value)>
{
};

// the type that a field returns; a number if the type is no field
template <typename Field, typename Point, typename = void>
struct Field_result
{
  typedef double type;
};

template <typename Field, typename Point>
struct Field_result<Field, Point, std::void_t<decltype(std::declval<const Field&>()(std::declval<const Point&>()))>>
{
  typedef std::decay_t<decltype(std::declval<const Field&>()(std::declval<const Point&>()))> type;
};

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingEmbeddings

The embedding \f$ (x, \sigma n(x), \tau f(x)) \in R^{6+m} \f$ with a field \f$ f \f$ of the user's, of \f$ m \f$ numbers: a
texture, the solution of a differential equation, a function on the surface. The mesh becomes finer where the field varies:
edges along the direction of the variation become shorter. A small edge of direction \f$ t \f$ has the squared length
\f$ |t|^2 + \sigma^2 |S t|^2 + \tau^2 |\nabla f \cdot t|^2 \f$.

\tparam Point the type of the points that the field takes, with a constructor from three `double`
\tparam Field a function object with `f(Point) const`, which returns a number or a `std::array<double, m>`, is defined on and
        near the surface, and may be called concurrently

\cgalModels{RemeshingEmbedding}

\sa `scalar_field_embedding()`
*/
template <typename Point, typename Field>
class Scalar_field_embedding
{
  typedef typename internal::Field_result<Field, Point>::type Result;
  static constexpr int dimension = internal::Field_dimension<Result>::value;
  typedef Eigen::Matrix<double, dimension, 1> Values;

public:
  /// the values of the field
  struct Vertex_data
  {
    Values values = Values::Zero();
  };

  /// \brief the embedding with a field
  /// \param sigma the weight of the normals, a length in the unit of the mesh
  /// \param tau the weight of the field: a length in the unit of the mesh, over the unit of the field
  /// \param field the field
  /// \throw std::invalid_argument if `sigma` or `tau` is negative or not finite
  Scalar_field_embedding(const double sigma, const double tau, const Field& field)
    : m_normals(sigma),
      m_tau(internal::checked_not_negative("tau of Scalar_field_embedding", tau)),
      m_squared_tau(tau * tau),
      m_field(field)
  {
    static_assert(std::is_invocable<const Field&, const Point&>::value,
                  "the field must be a function object that takes a point");
  }

  double sigma() const { return m_normals.sigma(); }
  double tau() const { return m_tau; }

  /// the same for a mesh in another unit of length
  Scalar_field_embedding in_unit(const double unit) const
  {
    Scalar_field_embedding result(sigma() / unit, m_tau / unit, m_field);
    result.m_unit = m_unit * unit;
    return result;
  }

  /// the number by which lengths in the embedding are divided in another unit of length: the unit itself
  double unit_of_lengths(const double unit) const { return unit; }

  /// evaluates the field
  /// \throw std::domain_error if the field is not finite there
  template <typename Vertex>
  void place(Vertex& vertex) const
  {
    const Eigen::Vector3d p = m_unit * vertex.point;
    const Result result = m_field(Point(p[0], p[1], p[2]));
    if constexpr (internal::Field_dimension<Result>::value == 1 && !std::is_same<Result, std::array<double, 1>>::value)
      vertex.values[0] = CGAL::to_double(result);
    else
      for (int k = 0; k < dimension; ++k)
        vertex.values[k] = CGAL::to_double(result[std::size_t(k)]);
    if (!vertex.values.allFinite())
      throw std::domain_error("the field is not finite at (" + internal::text_of_number(p[0]) + ", " +
                              internal::text_of_number(p[1]) + ", " + internal::text_of_number(p[2]) + ")");
  }

  /// evaluates the field
  template <typename Vertex>
  void place_between(const Vertex&, const Vertex&, Vertex& middle) const
  {
    place(middle);
  }

  template <typename Vertex>
  double squared_length(const Vertex& a, const Vertex& b) const
  {
    return m_normals.squared_length(a, b) + m_squared_tau * (a.values - b.values).squaredNorm();
  }

  /// the centroid of the faces about a vertex in the embedding, pulled back to the tangent plane of the vertex
  template <typename Vertex>
  class Centroid
  {
  public:
    Centroid(const Scalar_field_embedding& embedding, const Vertex& center, const Eigen::Matrix<double, 3, 2>& frame)
      : m_embedding(embedding), m_center(center), m_frame(frame)
    {
    }

    void add_neighbor(const Eigen::Vector2d& edge, const Vertex& neighbor)
    {
      m_edges += edge * edge.transpose();
      m_changes += edge * (neighbor.values - m_center.values).transpose();
    }

    void add_face(const double weight, const Vertex& a, const Vertex& b)
    {
      m_weight += weight;
      m_in_space += weight * ((a.point + b.point + m_center.point) / 3 - m_center.point);
      m_of_normal += weight * ((a.normal + b.normal + m_center.normal) / 3 - m_center.normal);
      m_of_field += weight * ((a.values + b.values + m_center.values) / 3 - m_center.values);
    }

    /// as `Normal_embedding::Centroid::tangential_step()`, with the gradient of the field as a further part of the
    /// differential. Least squares give this gradient from the neighbours.
    Eigen::Vector2d tangential_step(const Eigen::Matrix2d& shape_operator) const
    {
      const double squared_sigma = m_embedding.sigma() * m_embedding.sigma(), squared_tau = m_embedding.m_squared_tau;
      const Eigen::Matrix2d edges = m_edges + 1e-9 * m_edges.trace() * Eigen::Matrix2d::Identity();
      const Eigen::Matrix<double, 2, dimension> gradient = edges.inverse() * m_changes;
      const Eigen::Matrix2d metric = Eigen::Matrix2d::Identity() + squared_sigma * shape_operator * shape_operator +
                                     squared_tau * gradient * gradient.transpose();
      return metric.inverse() *
             (m_frame.transpose() * m_in_space + squared_sigma * (shape_operator * (m_frame.transpose() * m_of_normal)) +
              squared_tau * (gradient * m_of_field)) /
             m_weight;
    }

  private:
    const Scalar_field_embedding& m_embedding;
    const Vertex& m_center;
    const Eigen::Matrix<double, 3, 2>& m_frame;
    Eigen::Vector3d m_in_space = Eigen::Vector3d::Zero(), m_of_normal = Eigen::Vector3d::Zero();
    Values m_of_field = Values::Zero();
    Eigen::Matrix2d m_edges = Eigen::Matrix2d::Zero();
    Eigen::Matrix<double, 2, dimension> m_changes = Eigen::Matrix<double, 2, dimension>::Zero();
    double m_weight = 0;
  };

private:
  Normal_embedding m_normals;
  double m_tau, m_squared_tau;
  double m_unit = 1; // of the points here, in the unit of the points that the field takes
  Field m_field;
};

/*!
\ingroup PkgAnisotropicHdeRemeshingEmbeddings

returns the embedding with the field. The type of the points cannot be deduced.
*/
template <typename Point, typename Field>
Scalar_field_embedding<Point, Field> scalar_field_embedding(const double sigma, const double tau, const Field& field)
{
  return Scalar_field_embedding<Point, Field>(sigma, tau, field);
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_SCALAR_FIELD_EMBEDDING_H
