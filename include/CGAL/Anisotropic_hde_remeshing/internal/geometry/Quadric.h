// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_QUADRIC_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_QUADRIC_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A sum of weighted squared distances to planes and points, as a function of the place (Garland and Heckbert, Surface
// simplification using quadric error metrics, SIGGRAPH 1997).
class Quadric
{
public:
  static Quadric of_plane(const Vector& point, const Vector& unit_normal, const double weight)
  {
    return Quadric(weight * unit_normal * unit_normal.transpose(), point);
  }
  static Quadric of_point(const Vector& point, const double weight) { return Quadric(weight * Matrix::Identity(), point); }

  Quadric() = default;

  Quadric& operator+=(const Quadric& other)
  {
    m_matrix += other.m_matrix;
    m_vector += other.m_vector;
    m_constant += other.m_constant;
    return *this;
  }

  double operator()(const Vector& p) const { return (std::max)(p.dot(m_matrix * p) - 2 * m_vector.dot(p) + m_constant, 0.); }

  // the place of the least sum; the matrix must be positive definite
  Vector minimum() const { return m_matrix.llt().solve(m_vector); }

private:
  Quadric(const Matrix& matrix, const Vector& point)
    : m_matrix(matrix), m_vector(matrix * point), m_constant(point.dot(m_vector))
  {
  }

  Matrix m_matrix = Matrix::Zero();
  Vector m_vector = Vector::Zero();
  double m_constant = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_QUADRIC_H
