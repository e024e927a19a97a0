// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_SHAPE_OPERATOR_ESTIMATE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_SHAPE_OPERATOR_ESTIMATE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Tangent_frame.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <Eigen/Core>
#include <Eigen/LU>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The shape operator S at a vertex, in a tangent frame, estimated from the neighbours. Along an edge the normal changes by S
// times the edge. The three unknowns of S are the least squares solution of these equations.
class Shape_operator_estimate
{
public:
  void add_neighbor(const Eigen::Vector2d& edge, const Eigen::Vector2d& change_of_normal)
  {
    m_xx += edge[0] * edge[0];
    m_xy += edge[0] * edge[1];
    m_yy += edge[1] * edge[1];
    m_right += Eigen::Vector3d(edge[0] * change_of_normal[0], edge[1] * change_of_normal[0] + edge[0] * change_of_normal[1],
                               edge[1] * change_of_normal[1]);
  }

  Eigen::Matrix2d operator()() const
  {
    // the normal equations for S_xx, S_xy and S_yy, with a ridge
    const double ridge = 2e-9 * (m_xx + m_yy);
    Eigen::Matrix3d matrix;
    matrix << m_xx + ridge, m_xy, 0, m_xy, m_xx + m_yy + ridge, m_xy, 0, m_xy, m_yy + ridge;
    const Eigen::Vector3d s = matrix.inverse() * m_right;
    Eigen::Matrix2d result;
    result << s[0], s[1], s[1], s[2];
    return result;
  }

private:
  double m_xx = 0, m_xy = 0, m_yy = 0; // sums of products of the coordinates of the edges
  Eigen::Vector3d m_right = Eigen::Vector3d::Zero();
};

// The shape operator at the target of `in`, in tangent_frame() of the normal there. On a crease it is that of the region of
// `in`: only neighbours in this region count.
template <typename Mesh>
Eigen::Matrix2d shape_operator_at(const Halfedge_index in, const Mesh& mesh)
{
  const auto& center = mesh.state(mesh.target(in), in);
  const Tangent_frame frame = tangent_frame(center.normal);
  Shape_operator_estimate estimate;
  for (const Halfedge_index h : mesh.halfedges_around_target(in))
  {
    if (center.is_on_crease && mesh.region(h) != mesh.region(in) && mesh.region(mesh.opposite(h)) != mesh.region(in))
      continue;
    const auto& neighbor = mesh.state(mesh.source(h), in);
    estimate.add_neighbor(frame.transpose() * (neighbor.point - center.point),
                          frame.transpose() * (neighbor.normal - center.normal));
  }
  return estimate();
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_SHAPE_OPERATOR_ESTIMATE_H
