// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_GRID_COUNTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_GRID_COUNTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the box about some points, empty to begin with
struct Space_box
{
  Vector low = Vector::Constant((std::numeric_limits<double>::max)()), high = -low;

  void add(const Vector& p)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void add(const Space_box& box)
  {
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
  }
  bool is_empty() const { return !(low.array() <= high.array()).all(); }
  double longest_side() const { return (high - low).maxCoeff(); }
};

// How many faces of the input lie in each voxel of a grid over its box, and how long their edges are. All that the tree of cells
// is built from: sums over shares of the input, so that no process needs all faces.
class Grid_counts
{
public:
  static constexpr std::int32_t voxels_of_longest_side = 512;

  struct Voxel
  {
    std::array<std::int32_t, 3> index;
    std::uint64_t number_of_faces;
    double sum_of_lengths; // of a mean edge for each face
  };

  Grid_counts() = default;
  explicit Grid_counts(const Space_box& box)
    : m_low(box.low), m_side((std::max)(box.longest_side(), (std::numeric_limits<double>::min)()) / voxels_of_longest_side)
  {
  }

  void add(const Vector& centroid, const double length) { m_voxels.push_back(Voxel{index_of(centroid), 1, length}); }

  // The voxels of other shares come in the order of the shares, as sums are rounded.
  void add(const std::vector<Voxel>& voxels) { m_voxels.insert(m_voxels.end(), voxels.begin(), voxels.end()); }

  // makes each voxel occur once, in the order of the indices
  void unite()
  {
    std::stable_sort(m_voxels.begin(), m_voxels.end(), [](const Voxel& a, const Voxel& b) { return a.index < b.index; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < m_voxels.size(); ++i)
      if (m_voxels[i].index == m_voxels[last].index)
      {
        m_voxels[last].number_of_faces += m_voxels[i].number_of_faces;
        m_voxels[last].sum_of_lengths += m_voxels[i].sum_of_lengths;
      }
      else
        m_voxels[++last] = m_voxels[i];
    m_voxels.resize(m_voxels.empty() ? 0 : last + 1);
  }

  const std::vector<Voxel>& voxels() const { return m_voxels; }
  double side() const { return m_side; }

  // of the lower side of the voxels with this index
  double coordinate(const int axis, const std::int32_t index) const { return m_low[axis] + index * m_side; }

private:
  std::array<std::int32_t, 3> index_of(const Vector& p) const
  {
    std::array<std::int32_t, 3> result{};
    for (int axis = 0; axis < 3; ++axis)
      result[axis] =
          std::int32_t((std::min)((std::max)((p[axis] - m_low[axis]) / m_side, 0.), double(voxels_of_longest_side - 1)));
    return result;
  }

  Vector m_low = Vector::Zero();
  double m_side = 1;
  std::vector<Voxel> m_voxels;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_GRID_COUNTS_H
