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

#include <CGAL/Anisotropic_hde_remeshing/internal/check_parameters.h>

#include <Eigen/Core>
#include <Eigen/LU>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

The embedding of the paper's (2), \f$ \Psi(x) = (x, \sigma n(x)) \in R^6 \f$: a mesh that is uniform and isotropic there is
stretched along the directions of low curvature in space. A small edge of direction \f$ t \f$ has the squared 6D length
\f$ |t|^2 + \sigma^2 |S t|^2 \f$ with the shape operator \f$ S \f$.
*/
class Normal_embedding
{
public:
  /// \param sigma the weight of the normals, a length in the unit of the mesh; 0 makes the mesh isotropic in space
  /// \throw std::invalid_argument if `sigma` is negative or not finite
  explicit Normal_embedding(const double sigma)
    : m_squared_sigma(internal::checked_not_negative("sigma", sigma) * sigma)
  {
  }

  /// \f$ \sigma^2 \f$
  double squared_sigma() const { return m_squared_sigma; }

  /// the squared 6D distance of two points with unit normals, the paper's (3)
  template <typename VertexState>
  double squared_length(const VertexState& a, const VertexState& b) const
  {
    return (a.point - b.point).squaredNorm() + m_squared_sigma * (a.normal - b.normal).squaredNorm();
  }

  /// the tangential step, in the coordinates of an orthonormal tangent frame, whose image under the differential of
  /// \f$ \Psi \f$ is nearest to the displacement (`in_space`, \f$ \sigma \f$ `of_normal`) of \f$ R^6 \f$:
  /// \f$ (I + \sigma^2 S^2)\, t = d + \sigma^2 S\, d_n \f$ with the shape operator \f$ S \f$ in that frame
  Eigen::Vector2d tangential_step(const Eigen::Vector2d& in_space, const Eigen::Vector2d& of_normal,
                                  const Eigen::Matrix2d& shape_operator) const
  {
    const Eigen::Matrix2d metric = Eigen::Matrix2d::Identity() + m_squared_sigma * shape_operator * shape_operator;
    return metric.inverse() * (in_space + m_squared_sigma * shape_operator * of_normal);
  }

private:
  double m_squared_sigma;
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_NORMAL_EMBEDDING_H
