// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/*!
\ingroup PkgAnisotropicHdeRemeshingConcepts
\cgalConcept

The concept `RemeshingMetric` describes a Riemannian metric of the tangent planes of a surface.
`CGAL::anisotropic_hde_remeshing()` takes a model of it as the parameter `embedding` and makes the mesh uniform and isotropic in
the metric. The remesher limits the metric by its bounds and keeps it at the vertices. Between two vertices it takes the mean.

The remesher has a unit of length of its own: a power of two for which the diagonal of the bounding box of the
mesh is less than one and no less than a half. Points and curvatures are passed in this unit, and `in_unit()` is called with it. A
common factor of all metrics only matters for a target length. Const members are called concurrently.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Anisotropic_hde_remeshing::Curvature_metric}
\cgalHasModels{CGAL::Anisotropic_hde_remeshing::Adaptive_normal_embedding}
\cgalHasModelsEnd

\sa `RemeshingEmbedding`, which need not be a metric
*/
class RemeshingMetric
{
public:
  /// the same metric for points that are divided by `unit`
  RemeshingMetric in_unit(double unit) const;

  /// the number by which the lengths in the metric are divided if the points are divided by `unit`: `unit` itself if the matrix
  /// below is the same in all units, 1 if it is that of the caller's unit times the square of `unit`
  double unit_of_lengths(double unit) const;

  /// the symmetric positive definite matrix \f$ M \f$ of the metric at a point of the surface: the squared length of a small
  /// edge \f$ e \f$ of the tangent plane is \f$ e^T M e \f$. `frame` has two orthonormal axes of the tangent plane as its
  /// columns. The rows and columns of the result belong to them, and so do those of the shape operator. The shape operator is
  /// that of the mesh around the point, and has the inverse of the unit of `point`.
  Eigen::Matrix2d operator()(const Eigen::Vector3d& point, const Eigen::Matrix<double, 3, 2>& frame,
                             const Eigen::Matrix2d& shape_operator) const;

  /// the bounds by which the remesher limits the metric
  CGAL::Anisotropic_hde_remeshing::Metric_bounds bounds() const;
};
