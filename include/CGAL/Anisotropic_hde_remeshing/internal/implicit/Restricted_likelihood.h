// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RESTRICTED_LIKELIHOOD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RESTRICTED_LIKELIHOOD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// How likely the data of a patch are, if they are a random function, with noise. Their covariance is tau^2 (A + lambda I): A is
// the interpolation matrix, and tau^2 lambda the variance of the noise. Polynomials are unknown; so only what is left of the data
// on their null space is judged (restricted maximum likelihood; Wahba, Spline models for observational data, 1990). It is a
// template so that it is compiled only where a function is built.
template <typename Dense_matrix>
class Restricted_likelihood
{
  typedef Eigen::Matrix<typename Dense_matrix::Scalar, Eigen::Dynamic, 1> Column;

public:
  // Z^T A Z and Z^T f. The matrix is made tridiagonal once: then each lambda takes a sweep over its diagonals.
  Restricted_likelihood(const Dense_matrix& matrix, const Column& data)
  {
    const Eigen::Tridiagonalization<Dense_matrix> tridiagonal(matrix);
    m_diagonal = tridiagonal.diagonal();
    m_subdiagonal = tridiagonal.subDiagonal();
    m_data = tridiagonal.matrixQ().adjoint() * data;
  }

  // The most likely variance of the noise. It is 0 unless the data contradict that: twice the logarithm of the likelihood must grow
  // by `least_gain`.
  double variance_of_noise() const
  {
    static constexpr double least_gain = 4; // two standard deviations of an estimate
    const double n = double(m_data.size());
    const auto profile = [&](const double lambda)
    {
      const Terms t = terms(lambda);
      return t.log_determinant + n * std::log(t.square / n);
    };
    const double lambda = minimum(profile);
    return profile(std::pow(10., least_exponent)) - profile(lambda) < least_gain ? 0. : lambda * terms(lambda).square / n;
  }

  // the most likely tau^2, if the variance of the noise is known
  double variance_of_function(const double noise) const
  {
    const double n = double(m_data.size());
    return noise / minimum(
                       [&](const double lambda)
                       {
                         const Terms t = terms(lambda);
                         return t.log_determinant + n * std::log(noise / lambda) + t.square * lambda / noise;
                       });
  }

private:
  static constexpr double least_exponent = -8, largest_exponent = 10; // of lambda

  struct Terms
  {
    double log_determinant = 0, square = 0; // of A + lambda I, and w^T (A + lambda I)^-1 w
  };

  Terms terms(const double lambda) const
  {
    Terms result;
    double pivot = 1, x = 0;
    for (Eigen::Index k = 0; k < m_data.size(); ++k)
    {
      const double factor = k > 0 ? m_subdiagonal[k - 1] / pivot : 0.;
      pivot = m_diagonal[k] + lambda - (k > 0 ? factor * m_subdiagonal[k - 1] : 0.);
      x = m_data[k] - factor * x;
      if (!(pivot > 0))
        return Terms{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
      result.log_determinant += std::log(pivot);
      result.square += x * x / pivot;
    }
    return result;
  }

  // the place of the least value; there may be several minima
  template <typename Function>
  static double minimum(const Function& f)
  {
    double best = least_exponent, least = std::numeric_limits<double>::infinity();
    const auto ask = [&](const double exponent)
    {
      const double value = f(std::pow(10., exponent));
      if (!(value < least))
        return;
      least = value;
      best = exponent;
    };
    for (double exponent = least_exponent; exponent <= largest_exponent; exponent += 0.5)
      ask(exponent);
    for (double step = 0.25; step > 0.01; step /= 2)
    {
      const double middle = best;
      ask((std::max)(middle - step, least_exponent));
      ask(middle + step);
    }
    return std::pow(10., best);
  }

  Column m_diagonal, m_subdiagonal, m_data;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RESTRICTED_LIKELIHOOD_H
