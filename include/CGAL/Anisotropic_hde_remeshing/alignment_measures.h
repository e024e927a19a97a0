// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_ALIGNMENT_MEASURES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_ALIGNMENT_MEASURES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Measures.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Curvature_by_differences.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the longer axis of the ellipse of inertia of the edges of a triangle, and the ratio of the axes, 1 for equal edges
struct Stretch
{
  Vector direction;
  double ratio;

  Stretch(const Vector& a, const Vector& b, const Vector& c)
  {
    Matrix moments = Matrix::Zero();
    for (const Vector& edge : {Vector(b - a), Vector(c - b), Vector(a - c)})
      moments += edge * edge.transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(moments);
    direction = solver.eigenvectors().col(2);
    const double shorter = solver.eigenvalues()[1];
    ratio = shorter > 0 ? std::sqrt(solver.eigenvalues()[2] / shorter) : 1.;
  }
};

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingMeasures

measures how well the stretched faces of a triangle mesh follow the direction in which the surface is flatter. A face counts if
two ratios are at least `smallest_ratio`: that of the axes of the ellipse of inertia of its edges, and that of the absolute
principal curvatures at its centroid. Its angle is the one between the longer axis and the flatter direction, in degrees.
Without alignment the mean is 45.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: how the gradients are computed
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam Function a model of `ImplicitFunctionWithGradient`, or of `PiecewiseImplicitFunction`, which needs `face_patch_map`; its
        curvatures are taken from differences of its gradient
\tparam NamedParameters a sequence of named parameters

\param tmesh a triangle mesh
\param f the implicit function
\param np optional named parameters: `vertex_point_map` and `geom_traits`
\param smallest_ratio see above

\throw std::invalid_argument if a face of `tmesh` is not a triangle, or a coordinate is not finite
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Function,
          typename NamedParameters = parameters::Default_named_parameters>
Alignment_measures measure_alignment(const TriangleMesh& tmesh, const Function& f,
                                     const NamedParameters& np = parameters::default_values(),
                                     const double smallest_ratio = 1.5)
{
  if constexpr (!internal::accepts_measurement<TriangleMesh, Function, NamedParameters>())
    return Alignment_measures();
  else
  {
    static constexpr double not_counted = -1;
    static constexpr double relative_step = 1e-3; // of the shortest edge
    const internal::Measured_mesh mesh = internal::read_measured_mesh_of(f, tmesh, np);
    std::vector<double> angles(mesh.faces.size(), not_counted);
    internal::parallel_for<ConcurrencyTag>(
        angles.size(),
        [&](const std::size_t i)
        {
          const internal::Vector &a = mesh.points[mesh.faces[i][0]], &b = mesh.points[mesh.faces[i][1]],
                                 &c = mesh.points[mesh.faces[i][2]];
          if (mesh.is_degenerate[i])
            return;
          const internal::Stretch stretch(a, b, c);
          if (!(stretch.ratio >= smallest_ratio))
            return;
          const double step =
              relative_step * std::sqrt((std::min)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
          const internal::Curvature_by_differences curvature(internal::piece(f, mesh.face_regions[i]), (a + b + c) / 3, step);
          if (curvature.steeper != 0 && std::abs(curvature.steeper) >= smallest_ratio * std::abs(curvature.flatter))
            angles[i] = std::acos((std::min)(std::abs(stretch.direction.dot(curvature.flatter_direction)), 1.)) * 180 / CGAL_PI;
        });
    Alignment_measures measures;
    for (const double angle : angles)
      if (angle >= 0)
      {
        ++measures.number_of_faces;
        measures.angle_mean += angle;
        measures.share_within_15_degrees += angle <= 15 ? 1 : 0;
      }
    if (measures.number_of_faces > 0)
    {
      measures.angle_mean /= double(measures.number_of_faces);
      measures.share_within_15_degrees /= double(measures.number_of_faces);
    }
    return measures;
  }
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_ALIGNMENT_MEASURES_H
