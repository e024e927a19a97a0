// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_NORMAL_EMBEDDING_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_NORMAL_EMBEDDING_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>

#include <Eigen/Core>
#include <Eigen/LU>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/*!
\ingroup PkgAnisotropicHdeRemeshingEmbeddings

The embedding of the paper's (2), \f$ \Psi(x) = (x, \sigma n(x)) \in R^6 \f$. A mesh that is uniform and isotropic in
\f$ R^6 \f$ is stretched in space, along the directions of low curvature. A small edge of direction \f$ t \f$ has the squared 6D
length \f$ |t|^2 + \sigma^2 |S t|^2 \f$ with the shape operator \f$ S \f$.

\cgalModels{RemeshingEmbedding}
*/
class Normal_embedding
{
public:
  /// nothing
  struct Vertex_data
  {
  };

  /// \brief the embedding with a weight of the normals
  /// \param sigma the weight of the normals, a length in the unit of the mesh; 0 makes the mesh isotropic in space
  /// \throw std::invalid_argument if `sigma` is negative or not finite
  explicit Normal_embedding(const double sigma)
    : m_sigma(internal::checked_not_negative("sigma", sigma)), m_squared_sigma(sigma * sigma)
  {
  }

  /// \f$ \sigma \f$
  double sigma() const { return m_sigma; }

  /// the same for a mesh in another unit of length
  Normal_embedding in_unit(const double unit) const { return Normal_embedding(m_sigma / unit); }

  /// the number by which lengths in the embedding are divided in another unit of length: the unit itself
  double unit_of_lengths(const double unit) const { return unit; }

  /// nothing needs to be kept
  void place(Vertex_data&) const {}
  /// nothing needs to be kept
  void place_between(const Vertex_data&, const Vertex_data&, Vertex_data&) const {}

  /// the squared 6D distance of two points with unit normals, the paper's (3)
  template <typename Vertex>
  double squared_length(const Vertex& a, const Vertex& b) const
  {
    return (a.point - b.point).squaredNorm() + m_squared_sigma * (a.normal - b.normal).squaredNorm();
  }

  /// the centroid of the faces about a vertex in the embedding, pulled back to the tangent plane of the vertex
  template <typename Vertex>
  class Centroid
  {
  public:
    Centroid(const Normal_embedding& embedding, const Vertex& center, const Eigen::Matrix<double, 3, 2>& frame)
      : m_embedding(embedding), m_center(center), m_frame(frame)
    {
    }

    void add_neighbor(const Eigen::Vector2d&, const Vertex&) {}

    void add_face(const double weight, const Vertex& a, const Vertex& b)
    {
      m_weight += weight;
      m_in_space += weight * ((a.point + b.point + m_center.point) / 3 - m_center.point);
      m_of_normal += weight * ((a.normal + b.normal + m_center.normal) / 3 - m_center.normal);
    }

    /// the step whose image under the differential of \f$ \Psi \f$ is nearest to the way (\f$ d, \sigma d_n \f$) to the
    /// centroid in \f$ R^6 \f$: \f$ (I + \sigma^2 S^2)\, t = d + \sigma^2 S\, d_n \f$ with the shape operator \f$ S \f$
    Eigen::Vector2d tangential_step(const Eigen::Matrix2d& shape_operator) const
    {
      const double squared_sigma = m_embedding.m_squared_sigma;
      const Eigen::Matrix2d metric = Eigen::Matrix2d::Identity() + squared_sigma * shape_operator * shape_operator;
      return metric.inverse() *
             (m_frame.transpose() * m_in_space + squared_sigma * (shape_operator * (m_frame.transpose() * m_of_normal))) /
             m_weight;
    }

  private:
    const Normal_embedding& m_embedding;
    const Vertex& m_center;
    const Eigen::Matrix<double, 3, 2>& m_frame;
    Eigen::Vector3d m_in_space = Eigen::Vector3d::Zero(), m_of_normal = Eigen::Vector3d::Zero();
    double m_weight = 0;
  };

private:
  double m_sigma, m_squared_sigma;
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_NORMAL_EMBEDDING_H
