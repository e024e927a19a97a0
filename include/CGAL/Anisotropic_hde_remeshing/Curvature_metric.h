// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_CURVATURE_METRIC_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_CURVATURE_METRIC_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/*!
\ingroup PkgAnisotropicHdeRemeshingEmbeddings

the bounds that the remesher puts on a metric
*/
struct Metric_bounds
{
  double shortest_edge = 1e-4; ///< no edge needs to be shorter, as a share of the diagonal of the bounding box of the mesh
  double longest_edge = 0.25;  ///< no edge shall be longer, as a share of the same diagonal
  /// The normal turns by no more than this along an edge, in radians. By default there is no such bound. Where detail is finer than
  /// the faces, such as hair or noise, the bound would take faces from everywhere else.
  double turn = (std::numeric_limits<double>::infinity)();
  double gradation = 2; ///< largest ratio of the lengths that the metric asks of neighbouring edges, above 1
};

namespace internal {

inline const Metric_bounds& checked_bounds(const Metric_bounds& bounds)
{
  checked_between("Metric_bounds::shortest_edge", bounds.shortest_edge, 0, 1);
  checked_positive("Metric_bounds::longest_edge", bounds.longest_edge);
  if (!(bounds.shortest_edge < bounds.longest_edge))
    throw_invalid_argument("Metric_bounds::longest_edge", bounds.longest_edge, "longer than shortest_edge");
  if (!(bounds.turn > 0))
    throw_invalid_argument("Metric_bounds::turn", bounds.turn, "above 0");
  if (!(bounds.gradation > 1))
    throw_invalid_argument("Metric_bounds::gradation", bounds.gradation, "above 1");
  return bounds;
}

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingEmbeddings

The metric of the least distance between a mesh and a surface in the \f$ L^p \f$ norm. Among the meshes with vertices on the
surface and the same number of faces, a mesh that is uniform in this metric has the least distance. The metric is
\f$ M_p = \det |S|^{-1/(2p+2)} |S| \f$ with the absolute value \f$ |S| \f$ of the shape operator (Cao, On the error of linear
interpolation and the orientation, aspect ratio, and internal angles of a triangle, SIAM J. Numer. Anal. 43, 2005; Loseille and
Alauzet, Continuous mesh framework, SIAM J. Numer. Anal. 49, 2011). For \f$ p = \infty \f$ it is \f$ |S| \f$ itself. Edges of
length \f$ \sqrt{6 \varepsilon} \f$ then make the largest distance about \f$ \varepsilon \f$ where the surface is curved to one
side.

The metric is weighted by the distance between a triangle that is equilateral in \f$ |S| \f$ and a surface with these curvatures
and signs. This distance is less at saddles, and less where a curvature vanishes. Without the weight a mesh has more faces there
than is best.

Curvatures smaller than that of a sphere about five times as large as the surface are raised smoothly. `Metric_bounds` limits
the lengths of edges, the turns of the normal along them, and how fast the metric changes. The curvature at a vertex is
estimated from the normals of its neighbours.

A length in this metric has the unit of space to the power of \f$ 1/2 + 1 / (2p + 2) \f$.

\cgalModels{RemeshingMetric}
*/
class Curvature_metric
{
public:
  /// \brief the metric for a norm
  /// \param p the norm, from 1 to infinity
  /// \param bounds see `Metric_bounds`
  /// \throw std::invalid_argument if `p` is less than 1 or not a number, or the bounds are out of their ranges
  explicit Curvature_metric(const double p = 2, const Metric_bounds& bounds = Metric_bounds())
    : m_p(p), m_bounds(internal::checked_bounds(bounds))
  {
    if (!(p >= 1))
      internal::throw_invalid_argument("p of Curvature_metric", p, "from 1 to infinity");
  }

  double p() const { return m_p; }
  const Metric_bounds& bounds() const { return m_bounds; }

  /// the same for a mesh in another unit of length: the curvature at its vertices is in that unit anyway
  Curvature_metric in_unit(double) const { return *this; }

  /// the number by which lengths in the metric are divided in another unit of length
  double unit_of_lengths(const double unit) const { return std::pow(unit, 0.5 - exponent()); }

  /// the metric in the frame of the tangent plane; only the shape operator counts
  Eigen::Matrix2d operator()(const Eigen::Vector3d&, const Eigen::Matrix<double, 3, 2>&,
                             const Eigen::Matrix2d& shape_operator) const
  {
    return of_shape_operator(shape_operator);
  }

  /// \f$ M_p \f$ in the frame of the shape operator. The unit of the shape operator is the inverse of a unit of length in which
  /// the surface has about the size 1.
  Eigen::Matrix2d of_shape_operator(const Eigen::Matrix2d& shape_operator) const
  {
    static constexpr double smallest_curvature = 0.2;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(shape_operator);
    const Eigen::Vector2d curvatures = solver.eigenvalues(),
                          absolute = (curvatures.array().square() + smallest_curvature * smallest_curvature).sqrt();
    const double weight = distance_constant(curvatures[0] / absolute[0], curvatures[1] / absolute[1]);
    const Eigen::Vector2d eigenvalues =
        std::pow(weight, 1 + 2 * exponent()) * std::pow(absolute[0] * absolute[1], exponent()) * absolute;
    const Eigen::Matrix2d metric = solver.eigenvectors() * eigenvalues.asDiagonal() * solver.eigenvectors().transpose();
    return 0.5 * (metric + metric.transpose());
  }

private:
  // The distance between a triangle that is equilateral in |S| and a surface with the curvatures r |k|, relative to the
  // distance for r = 1. r is from -1 to 1. The root mean square is exact: with the heights q_i of the quadratic form over the
  // edges it is ((sum q_i^2 + (sum q_i)^2) / 720)^(1/2). The largest distance is fitted to r = (1, 1), (1, -1) and (1, 0), in
  // the mean over all directions of the triangle. It is raised at saddles, where directions matter.
  double distance_constant(const double r, const double s) const
  {
    static constexpr double smallest = 0.1;
    if (std::isinf(m_p))
      return smallest +
             (1 - smallest) * std::pow(std::pow(0.5 * std::abs(r + s), 1.3) + std::pow(0.4 * std::abs(r - s), 1.3), 1 / 1.3);
    return smallest + (1 - smallest) * std::sqrt((9. / 8 * (r * r + s * s) + 3. / 4 * r * s + 9. / 4 * (r + s) * (r + s)) / 12);
  }

  // the exponent of the determinant
  double exponent() const { return std::isinf(m_p) ? 0. : -1 / (2 * m_p + 2); }

  double m_p;
  Metric_bounds m_bounds;
};

/*!
\ingroup PkgAnisotropicHdeRemeshingEmbeddings

The paper's embedding with a weight of the normals that follows the curvature, \f$ \sigma(x) = 1 / \sqrt{|K|} \f$ with the Gauss
curvature \f$ K \f$. This is the metric \f$ I + \sigma(x)^2 S^2 \f$. Everywhere, edges have about the ratio of lengths that is
best for the distance to the surface, \f$ \sqrt{k_1 / k_2} \f$. The sizes of faces hardly differ. The embedding has no
parameter and needs no scale. It is regularised and bounded as `Curvature_metric`.

\cgalModels{RemeshingMetric}
*/
class Adaptive_normal_embedding
{
public:
  /// \brief the embedding with some bounds
  /// \param bounds see `Metric_bounds`
  /// \throw std::invalid_argument if the bounds are out of their ranges
  explicit Adaptive_normal_embedding(const Metric_bounds& bounds = Metric_bounds()) : m_bounds(internal::checked_bounds(bounds))
  {
  }

  const Metric_bounds& bounds() const { return m_bounds; }

  /// the same for a mesh in another unit of length: the curvature at its vertices is in that unit anyway
  Adaptive_normal_embedding in_unit(double) const { return *this; }

  /// the number by which lengths in the metric are divided in another unit of length: the unit itself
  double unit_of_lengths(const double unit) const { return unit; }

  /// the metric in the frame of the tangent plane; only the shape operator counts
  Eigen::Matrix2d operator()(const Eigen::Vector3d&, const Eigen::Matrix<double, 3, 2>&,
                             const Eigen::Matrix2d& shape_operator) const
  {
    return of_shape_operator(shape_operator);
  }

  /// \f$ I + \sigma^2 S^2 \f$ in the frame of the shape operator. The unit of the shape operator is the inverse of a unit of
  /// length in which the surface has about the size 1.
  Eigen::Matrix2d of_shape_operator(const Eigen::Matrix2d& shape_operator) const
  {
    static constexpr double smallest_curvature = 0.2, smallest_ratio = 0.01; // of curvatures
    const Eigen::Matrix2d square = shape_operator * shape_operator;
    const double gauss_curvature = std::abs(shape_operator.determinant());
    return Eigen::Matrix2d::Identity() +
           0.5 * (square + square.transpose()) /
               (gauss_curvature + smallest_ratio * square.trace() + smallest_curvature * smallest_curvature);
  }

private:
  Metric_bounds m_bounds;
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_CURVATURE_METRIC_H
