// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_COARSE_INTERPOLANT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_COARSE_INTERPOLANT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Coarse_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Interpolation_system.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Kernel_sum.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Polynomial_null_space.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_matrix.h>

#include <CGAL/Radial_basis_functions.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The smooth field through a coarse surface: r^3 and a linear polynomial interpolate 0 at the middles of its parts, and the
// offsets at places beside these. It goes on smoothly where there are no parts, but has an arbitrary sign far away.
class Coarse_interpolant
{
  static constexpr double relative_offset = 0.25; // in units of the radius of the part
  static constexpr double least_independence = 1e-6;

public:
  Coarse_interpolant(const Surface_sample& sample, const Coarse_surface& surface)
  {
    const Point_search search(sample.points);
    std::vector<Vector> centres;
    std::vector<double> values;
    for (const Coarse_surface::Part& part : surface.parts())
    {
      const Vector &p = sample.points[part.middle], &normal = sample.normals[part.middle];
      centres.push_back(p);
      values.push_back(0);
      if (!sample.has_side(part.middle))
        continue;
      for (const double side : {1., -1.})
        if (const double offset = side * free_offset(search, p, side * normal, relative_offset * part.radius); offset != 0)
        {
          centres.push_back(p + offset * normal);
          values.push_back(offset);
        }
    }
    solve(centres, values);
  }

  // false if it has no solution, as for points with normals in one plane
  bool is_solved() const { return m_is_solved; }

  template <int order>
  Jet<order> evaluate(const Vector& p) const
  {
    double squared_distance;
    Jet<order> result = m_sum.template evaluate<order>(p, squared_distance);
    result.value += m_constant + m_slope.dot(p);
    if constexpr (order >= 1)
      result.gradient += m_slope;
    return result;
  }

  std::size_t memory_bytes() const { return m_sum.memory_bytes(); }

private:
  // the largest one, halved a few times, that no other part of the surface is near to; 0 if there is none
  static double free_offset(const Point_search& search, const Vector& p, const Vector& direction, const double largest)
  {
    for (const double offset : {largest, largest / 2, largest / 4, largest / 8})
      if (search.nearest(p + offset * direction, 1).front().first >= 0.25 * offset * offset)
        return offset;
    return 0;
  }

  void solve(const std::vector<Vector>& centres, const std::vector<double>& values)
  {
    const Eigen::Index n = Eigen::Index(centres.size()), number_of_polynomials = 4;
    if (n <= number_of_polynomials)
      return;
    Eigen::Matrix<double, 3, Eigen::Dynamic> points(3, n);
    for (Eigen::Index i = 0; i < n; ++i)
      points.col(i) = centres[std::size_t(i)];
    Eigen::MatrixXd polynomials = Eigen::MatrixXd::Ones(n, number_of_polynomials);
    polynomials.rightCols(3) = points.transpose();
    const Eigen::VectorXd data = Eigen::Map<const Eigen::VectorXd>(values.data(), n);
    const Polynomial_null_space<Eigen::MatrixXd> null_space(polynomials);
    if (!(null_space.independence() > least_independence))
      return;
    const Polyharmonic_rbf kernel;
    const Interpolation_coefficients solution =
        Interpolation_system<Eigen::MatrixXd>([&] { return interpolation_matrix(points, kernel, 0); }, polynomials, null_space)
            .solve(data);
    m_is_solved = solution.solver != Solver::FAILED && solution.is_finite();
    if (!m_is_solved)
      return;
    m_sum = Kernel_sum<Polyharmonic_rbf>(points, solution.weights, kernel);
    m_constant = solution.polynomial[0];
    m_slope = solution.polynomial.tail(3);
  }

  Kernel_sum<Polyharmonic_rbf> m_sum;
  double m_constant = 0;
  Vector m_slope = Vector::Zero();
  bool m_is_solved = false;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_COARSE_INTERPOLANT_H
