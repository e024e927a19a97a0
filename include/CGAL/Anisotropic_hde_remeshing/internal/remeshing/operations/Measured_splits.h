// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_MEASURED_SPLITS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_MEASURED_SPLITS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Quadric.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sampled_ring.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A split of an edge inside the mesh, and by how much it lowers the cost of both faces.
struct Measured_split
{
  double gain;
  Edge_index edge;
  Vector point;

  // the one that gains more comes first
  bool operator<(const Measured_split& other) const { return gain > other.gain || (gain == other.gain && edge < other.edge); }
};

// Finds where on an edge a new vertex gains most: at its middle on the input, at the sample that is farthest from both faces, or at
// the least of the quadric of their samples.
template <typename ConcurrencyTag, typename Mesh>
class Measured_splits
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;
  typedef Sampled_ring<ConcurrencyTag, Mesh> Ring;

  static constexpr double longest_neighbor = 1.3;    // over the length of an edge that is split
  static constexpr double nearest_to_end = 0.2;      // of an edge: nearer to an end a new vertex makes a needle
  static constexpr double weight_of_distance = 1e-2; // in a quadric: it keeps the point near where the samples are

public:
  Measured_splits(const Mesh& mesh, const Input_surface& input, const Owners& owners, const Shape_price& price)
    : m_mesh(mesh), m_input(input), m_owners(owners), m_price(price)
  {
  }

  // edges that are about the longest of their faces, where the cost is largest first, at most `largest_number`
  std::vector<Edge_index> candidates(const std::size_t largest_number) const
  {
    std::vector<Measured_split> splits;
    for (const Edge_index e : m_mesh.edges())
      if (is_candidate(e))
      {
        const Halfedge_index h = m_mesh.halfedge(e);
        splits.push_back(
            Measured_split{m_owners.cost(m_mesh.face(h)) + m_owners.cost(m_mesh.face(m_mesh.opposite(h))), e, Vector::Zero()});
      }
    const std::size_t n = (std::min)(splits.size(), largest_number);
    std::partial_sort(splits.begin(), splits.begin() + std::ptrdiff_t(n), splits.end());
    std::vector<Edge_index> result;
    for (std::size_t i = 0; i < n; ++i)
      result.push_back(splits[i].edge);
    return result;
  }

  // those that gain anything, the most first
  std::vector<Measured_split> measure(const std::vector<Edge_index>& edges, Interruption& interruption) const
  {
    std::vector<Measured_split> result(edges.size());
    parallel_for<ConcurrencyTag>(
        edges.size(), [&](const std::size_t i) { result[i] = measure(edges[i]); }, 16, interruption);
    result.erase(std::remove_if(result.begin(), result.end(), [](const Measured_split& s) { return !(s.gain > 0); }),
                 result.end());
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  bool is_candidate(const Edge_index e) const
  {
    if (m_mesh.is_border(e) || m_mesh.is_on_curve(e))
      return false;
    const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
    const double longest = (std::max)({squared_length(m_mesh.next(h), m_mesh), squared_length(m_mesh.prev(h), m_mesh),
                                       squared_length(m_mesh.next(g), m_mesh), squared_length(m_mesh.prev(g), m_mesh)});
    return longest <= longest_neighbor * longest_neighbor * squared_length(h, m_mesh);
  }

  Measured_split measure(const Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    Ring ring(m_mesh, m_owners, m_price);
    ring.add_quad(h);
    double least = ring.cost();
    Vector best = Vector::Zero();
    const auto look_at = [&](const Vector& point)
    {
      const double cost = ring.cost_at(point, least, (std::numeric_limits<double>::infinity)());
      if (cost < least)
      {
        least = cost;
        best = point;
      }
    };
    const Vector middle = internal::middle(h, m_mesh), farthest = farthest_sample(h, ring);
    look_at(m_input.empty() ? middle : m_input.closest(middle).point);
    if (farthest != middle)
      look_at(farthest);
    look_at(least_of_quadric(middle, ring));
    return Measured_split{ring.cost() - least, e, best};
  }

  // the middle of the edge if there is none
  Vector farthest_sample(const Halfedge_index h, const Ring& ring) const
  {
    const Vector &a = m_mesh.point(m_mesh.source(h)).point, &b = m_mesh.point(m_mesh.target(h)).point;
    Vector result = (a + b) / 2;
    double largest = 0;
    for (const std::uint32_t i : ring.samples())
    {
      const double place = (m_owners.sample(i).point - a).dot(b - a) / (b - a).squaredNorm();
      if (nearest_to_end <= place && place <= 1 - nearest_to_end && m_owners.squared_distance_of(i) > largest)
      {
        largest = m_owners.squared_distance_of(i);
        result = m_owners.sample(i).point;
      }
    }
    return result;
  }

  Vector least_of_quadric(const Vector& origin, const Ring& ring) const
  {
    Quadric sum;
    for (const std::uint32_t i : ring.samples())
    {
      const Reference_sample& s = m_owners.sample(i);
      sum += Quadric::of_plane(s.point - origin, s.normal.template cast<double>(), s.area);
      sum += Quadric::of_point(s.point - origin, weight_of_distance * s.area);
    }
    return ring.samples().empty() ? origin : Vector(origin + sum.minimum());
  }

  const Mesh& m_mesh;
  const Input_surface& m_input;
  const Owners& m_owners;
  const Shape_price& m_price;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_MEASURED_SPLITS_H
