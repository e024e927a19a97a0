// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_PRINCIPAL_CURVATURES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_PRINCIPAL_CURVATURES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/*!
\ingroup PkgAnisotropicHdeRemeshingImplicit

the principal curvatures of a surface at a point, in the inverse of the unit of the coordinates, and their directions. A
curvature is positive where the surface curves away from its normal, as a sphere with outward normals does. The directions are
unit vectors orthogonal to each other and to the normal.

\tparam GeomTraits a kernel
*/
template <typename GeomTraits>
struct Principal_curvatures
{
  typename GeomTraits::FT min_curvature = 0;
  typename GeomTraits::FT max_curvature = 0;
  typename GeomTraits::Vector_3 min_direction;
  typename GeomTraits::Vector_3 max_direction;
};

namespace internal {

// T H T / |g| with T = I - n n^T, n = g / |g|
inline Matrix shape_operator(const Jet<2>& jet)
{
  const double length = jet.gradient.norm();
  if (!(length > 0))
    return Matrix::Zero();
  const Vector normal = jet.gradient / length;
  const Matrix tangential = Matrix::Identity() - normal * normal.transpose();
  const Matrix result = tangential * jet.hessian * tangential / length;
  return 0.5 * (result + result.transpose());
}

// `scale` converts the curvatures to the unit of the caller
template <typename GeomTraits>
Principal_curvatures<GeomTraits> principal_curvatures(const Jet<2>& jet, const double scale)
{
  typedef typename GeomTraits::FT FT;
  typedef typename GeomTraits::Vector_3 Vector_3;

  // In a basis of the tangent plane. In space, the eigenvalue 0 of the normal could be taken for a curvature.
  const double length = jet.gradient.norm();
  const Vector normal = length > 0 ? Vector(jet.gradient / length) : Vector(Vector::UnitZ());
  Eigen::Matrix<double, 3, 2> basis;
  basis.col(0) = normal.unitOrthogonal();
  basis.col(1) = normal.cross(basis.col(0));
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(basis.transpose() * shape_operator(jet) * basis);
  const Eigen::Matrix<double, 3, 2> directions = basis * solver.eigenvectors();

  Principal_curvatures<GeomTraits> result;
  result.min_curvature = FT(scale * solver.eigenvalues()[0]);
  result.max_curvature = FT(scale * solver.eigenvalues()[1]);
  result.min_direction = Vector_3(FT(directions(0, 0)), FT(directions(1, 0)), FT(directions(2, 0)));
  result.max_direction = Vector_3(FT(directions(0, 1)), FT(directions(1, 1)), FT(directions(2, 1)));
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_PRINCIPAL_CURVATURES_H
