// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// A metric of one's own: the best one for the distance, with edges a quarter as long near a point.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <iostream>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Anisotropic_hde_remeshing::Curvature_metric Curvature_metric;

// an ellipsoid with the half axes 1, 2 and 3
struct Ellipsoid
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return p.x() * p.x() + p.y() * p.y() / 4 + p.z() * p.z() / 9 - 1; }
  Vector_3 gradient(const Point_3& p) const { return Vector_3(2 * p.x(), p.y() / 2, 2 * p.z() / 9); }
};

// A model of RemeshingMetric. The remesher asks it in a unit of its own.
class Finer_near_a_point
{
public:
  explicit Finer_near_a_point(const Eigen::Vector3d& center) : m_center(center) {}

  Finer_near_a_point in_unit(const double unit) const
  {
    Finer_near_a_point result = *this;
    result.m_metric = m_metric.in_unit(unit);
    result.m_unit = m_unit * unit;
    return result;
  }

  double unit_of_lengths(const double unit) const { return m_metric.unit_of_lengths(unit); }

  Eigen::Matrix2d operator()(const Eigen::Vector3d& point, const Eigen::Matrix<double, 3, 2>& frame,
                             const Eigen::Matrix2d& shape_operator) const
  {
    const double distance = (m_unit * point - m_center).norm();
    const double factor = 1 + 3 * (std::max)(1 - distance, 0.); // of the lengths: 4 at the centre, 1 from a distance of 1 on
    return factor * factor * m_metric(point, frame, shape_operator);
  }

  CGAL::Anisotropic_hde_remeshing::Metric_bounds bounds() const { return m_metric.bounds(); }

private:
  Eigen::Vector3d m_center;
  Curvature_metric m_metric{2};
  double m_unit = 1; // of the points here, in that of the mesh
};

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1);
  for (const Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = Kernel::Point_3(mesh.point(v).x(), 2 * mesh.point(v).y(), 3 * mesh.point(v).z());
  CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(
      mesh, Ellipsoid(), params::embedding(Finer_near_a_point(Eigen::Vector3d(0, 0, 3))).number_of_target_faces(5000));

  std::size_t near_center = 0, near_opposite_point = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    near_center += mesh.point(v).z() > 2.5 ? 1 : 0;
    near_opposite_point += mesh.point(v).z() < -2.5 ? 1 : 0;
  }
  std::cout << mesh.number_of_faces() << " faces; " << near_center << " vertices near the point, " << near_opposite_point
            << " at the other end; written to finer.off" << std::endl;
  return CGAL::IO::write_polygon_mesh("finer.off", mesh, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
