// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_MEASURES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_MEASURES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/// \ingroup PkgAnisotropicHdeRemeshingMeasures
///
/// the elements of a triangle mesh and how they are connected. Isolated vertices are left out but counted.
struct Topology_measures
{
  std::size_t number_of_vertices = 0;          ///< with a face
  std::size_t number_of_isolated_vertices = 0; ///< without one
  std::size_t number_of_edges = 0;             ///< all of them
  std::size_t number_of_faces = 0;             ///< all of them
  std::size_t number_of_boundary_edges = 0;    ///< edges with one face
  std::size_t number_of_boundary_loops = 0;    ///< closed curves of boundary edges
  std::size_t number_of_components = 0;        ///< connected by edges
  std::ptrdiff_t euler_characteristic = 0;     ///< vertices - edges + faces
  std::size_t number_of_interior_vertices = 0; ///< not on a boundary
  double valence_6_share = 0; ///< share of the interior vertices with 6 edges; 0 if there are no interior vertices
};

/// \ingroup PkgAnisotropicHdeRemeshingMeasures
///
/// the shapes of the faces of a triangle mesh in space, and how neighbouring faces lie to each other. The aspect ratio of a
/// face is \f$ q_T = R_T / (2 r_T) \f$, the circumradius over twice the inradius. It is 1 for an equilateral triangle, and
/// larger for any other.
struct Shape_measures
{
  double aspect_ratio_mean = 0;               ///< of the faces that are not degenerate
  double aspect_ratio_p99 = 0;                ///< the 99th percentile, infinite if too many faces are degenerate
  double aspect_ratio_max = 0;                ///< \f$ q_\Gamma \f$, infinite if a face is degenerate
  std::size_t number_of_degenerate_faces = 0; ///< those of three collinear points
  /// edges over which two faces turn by more than 143 degrees (a cosine of -0.8). Faces that are needles of no height do not
  /// count.
  std::size_t number_of_folded_edges = 0;
};

/// \ingroup PkgAnisotropicHdeRemeshingMeasures
///
/// a triangle mesh in the embedding \f$ \Psi(x) = (x, \sigma n(x)) \f$ in \f$ R^6 \f$, with `n` the unit gradient of an
/// implicit function. There an edge has the squared length \f$ |a-b|^2 + \sigma^2 |n_a-n_b|^2 \f$.
struct Embedding_measures
{
  double sigma = 0;                       ///< \f$ \sigma \f$, in the unit of the mesh
  double edge_length_mean = 0;            ///< geometric mean of the 6D lengths of the edges
  double target_edge_length = 0;          ///< the length `l` that the shares refer to
  double share_within_half = 0;           ///< share of the edges with a 6D length within [0.5, 1.5] `l`
  double share_within_sqrt_2 = 0;         ///< share of the edges with a 6D length within [0.7, 1.41] `l`
  double minimum_angle_mean = 0;          ///< mean of the least 6D angles of the faces, in degrees
  double minimum_angle_least = 0;         ///< the least 6D angle of all, in degrees
  std::size_t number_of_folded_faces = 0; ///< faces turned against the function, see `measure_embedding()`
};

/// \ingroup PkgAnisotropicHdeRemeshingMeasures
///
/// distances of a triangle mesh to the zero set of an implicit function, in the unit of the mesh, see
/// `measure_distance_to_zero_set()`
struct Zero_set_measures
{
  double interior_vertex_max = 0;    ///< largest distance of the vertices that are not on a boundary
  double boundary_vertex_max = 0;    ///< largest distance of the vertices on a boundary
  double face_rms = 0;               ///< root mean square of the distance over the area of the faces
  double face_max = 0;               ///< largest distance of the points sampled on the faces
  std::size_t number_of_samples = 0; ///< points sampled on the faces
};

/// \ingroup PkgAnisotropicHdeRemeshingMeasures
///
/// distances between two triangle meshes, in their unit
struct Distance_measures
{
  double rms_from_first = 0;  ///< root mean square over the area of the first mesh of the distance to the second
  double max_from_first = 0;  ///< largest distance of the sampled points and vertices of the first mesh to the second
  double rms_from_second = 0; ///< as `rms_from_first`, from the second mesh to the first
  double max_from_second = 0; ///< as `max_from_first`, from the second mesh to the first

  /// the larger of the two root mean squares
  double rms() const { return (std::max)(rms_from_first, rms_from_second); }
  /// the larger of the two maxima. It is the Hausdorff distance, except that points between the sampled ones are not seen.
  double max() const { return (std::max)(max_from_first, max_from_second); }
};

/// \ingroup PkgAnisotropicHdeRemeshingMeasures
///
/// how the stretched faces of a triangle mesh follow the curvature of a surface, see `measure_alignment()`
struct Alignment_measures
{
  std::size_t number_of_faces = 0; ///< faces that are stretched, at places where the principal curvatures differ
  double angle_mean = 0;           ///< mean angle between the longer axis of these faces and the flatter direction, in degrees
  double share_within_15_degrees = 0; ///< share of these faces with an angle of at most 15 degrees
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_MEASURES_H
