// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_VERTEX_FITTER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_VERTEX_FITTER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Surface_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/size_limits.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Moves vertices along normals so that the integral of the squared distance between the faces and the zero set is least. With
// the offsets s of the vertices, the distance of a point x of a face is d(x) + sum_i phi_i(x) (n_i . n(x)) s_i to first order.
// Here phi are the barycentric coordinates. The matrix of the normal equations is a mass matrix: a few dozen steps of conjugate
// gradients solve them, whatever the shapes of the faces are. There are two rounds, because d is linear to first order only.
template <typename ConcurrencyTag, typename Function>
class Vertex_fitter
{
  typedef Surface_distance<Piece_of<Function>> Distance;

  static constexpr int number_of_rounds = 2;
  // over the longest edge of a face: a surface that is further away does not belong to the face
  static constexpr double largest_distance = 0.5;
  // over the shortest edge at a vertex
  static constexpr double largest_offset = 0.5;

  struct Node
  {
    std::array<double, 3> barycentric;
    double weight;
  };

  // exact for polynomials of degree 4 (Dunavant, 1985)
  static std::array<Node, 6> quadrature()
  {
    const double a = 0.445948490915965, b = 0.091576213509771, wa = 0.223381589678011, wb = 0.109951743655322;
    return {Node{{1 - 2 * a, a, a}, wa}, Node{{a, 1 - 2 * a, a}, wa}, Node{{a, a, 1 - 2 * a}, wa},
            Node{{1 - 2 * b, b, b}, wb}, Node{{b, 1 - 2 * b, b}, wb}, Node{{b, b, 1 - 2 * b}, wb}};
  }

public:
  explicit Vertex_fitter(const Function& function)
  {
    for (std::size_t i = 0; i < number_of_pieces(function); ++i)
      m_distances.emplace_back(piece(function, Region(i)));
  }

  // Moves the points whose vertices are free. `normals` has unit vectors for the vertices that are free. `regions` are those of
  // the facets.
  void operator()(std::vector<Vector>& points, const std::vector<Vector>& normals, const std::vector<char>& is_free,
                  const std::vector<Facet>& facets, const std::vector<Region>& regions) const
  {
    const std::vector<double> bounds = bounds_of_offsets(points, facets);
    std::vector<double> offsets(points.size(), 0.);
    const std::vector<Vector> start = points;
    for (int round = 0; round < number_of_rounds; ++round)
    {
      const std::vector<double> change = solve(points, normals, is_free, facets, regions);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        offsets[i] = (std::min)((std::max)(offsets[i] + change[i], -bounds[i]), bounds[i]);
        if (is_free[i])
          points[i] = start[i] + offsets[i] * normals[i];
      }
    }
  }

private:
  static std::vector<double> bounds_of_offsets(const std::vector<Vector>& points, const std::vector<Facet>& facets)
  {
    std::vector<double> bounds(points.size(), (std::numeric_limits<double>::max)());
    for (const Facet& facet : facets)
      for (int k = 0; k < 3; ++k)
      {
        const std::size_t i = facet[k], j = facet[(k + 1) % 3];
        const double bound = largest_offset * (points[i] - points[j]).norm();
        bounds[i] = (std::min)(bounds[i], bound);
        bounds[j] = (std::min)(bounds[j], bound);
      }
    return bounds;
  }

  // what a face adds to the normal equations
  struct Contribution
  {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
  };

  Contribution contribution(const std::vector<Vector>& points, const std::vector<Vector>& normals, const Facet& facet,
                            const Distance& distance) const
  {
    const Vector &a = points[facet[0]], &b = points[facet[1]], &c = points[facet[2]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    const double longest = std::sqrt((std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    Contribution result;
    for (const Node& node : quadrature())
    {
      const auto at =
          distance(node.barycentric[0] * a + node.barycentric[1] * b + node.barycentric[2] * c, largest_distance * longest);
      if (!std::isfinite(at.distance))
        continue;
      Eigen::Vector3d row;
      for (int k = 0; k < 3; ++k)
        row[k] = node.barycentric[std::size_t(k)] * normals[facet[k]].dot(at.normal);
      result.matrix += node.weight * area * row * row.transpose();
      result.right -= node.weight * area * at.distance * row;
    }
    return result;
  }

  // the offsets of the vertices from where they are now
  std::vector<double> solve(const std::vector<Vector>& points, const std::vector<Vector>& normals,
                            const std::vector<char>& is_free, const std::vector<Facet>& facets,
                            const std::vector<Region>& regions) const
  {
    check_number_of_fitted_faces(double(facets.size()));
    std::vector<Contribution> contributions(facets.size());
    parallel_for<ConcurrencyTag>(
        facets.size(),
        [&](const std::size_t f) { contributions[f] = contribution(points, normals, facets[f], m_distances[regions[f]]); }, 16);

    std::vector<int> unknowns(points.size(), -1);
    int number_of_unknowns = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (is_free[i])
        unknowns[i] = number_of_unknowns++;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(number_of_unknowns);
    for (std::size_t f = 0; f < facets.size(); ++f)
      for (int i = 0; i < 3; ++i)
      {
        const int row = unknowns[facets[f][i]];
        if (row < 0)
          continue;
        right[row] += contributions[f].right[i];
        for (int j = 0; j < 3; ++j)
          if (const int column = unknowns[facets[f][j]]; column >= 0)
            entries.emplace_back(row, column, contributions[f].matrix(i, j));
      }
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(number_of_unknowns, number_of_unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double, Eigen::RowMajor>, Eigen::Lower | Eigen::Upper> solver;
    solver.setTolerance(1e-8);
    solver.setMaxIterations(1000);
    const Eigen::VectorXd solution = solver.compute(matrix).solve(right);

    std::vector<double> offsets(points.size(), 0.);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (unknowns[i] >= 0 && std::isfinite(solution[unknowns[i]]))
        offsets[i] = solution[unknowns[i]];
    return offsets;
  }

  std::vector<Distance> m_distances; // by region
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_VERTEX_FITTER_H
