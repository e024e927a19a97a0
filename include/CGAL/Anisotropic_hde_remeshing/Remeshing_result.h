// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_REMESHING_RESULT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_REMESHING_RESULT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/// \ingroup PkgAnisotropicHdeRemeshingSchemes
///
/// for how many points each way of projecting onto the zero set was used. The ways are tried in this order.
struct Projection_counters
{
  std::size_t newton = 0;        ///< Newton's method along the gradient
  std::size_t bisection = 0;     ///< a bracket along the first gradient, halved
  std::size_t descent = 0;       ///< small steps along the gradient, where the mesh given is coarse and far from the zero set
  std::size_t closest_point = 0; ///< the closest point of the input with its interpolated normal
};

/// \ingroup PkgAnisotropicHdeRemeshingSchemes
///
/// what decided on the number of faces
enum class Target
{
  NUMBER_OF_FACES,     ///< `number_of_target_faces`, or as many as there were
  EDGE_LENGTH,         ///< the target length
  APPROXIMATION_ERROR, ///< the error
  /// none: the number of faces was missed by more than 1%. Most faces are at creases, boundaries or constraints, which need
  /// their vertices.
  FEATURE_CURVES,
  /// none: the number of faces was missed by more than 1%. What was left to do would have folded or flattened faces, or changed
  /// the topology.
  GUARDS
};

/// \ingroup PkgAnisotropicHdeRemeshingSharp
///
/// the feature curves of a mesh: its creases, boundaries and constrained edges
struct Feature_curves
{
  std::size_t number_of_curves = 0;  ///< from corner to corner, or closed
  std::size_t number_of_corners = 0; ///< vertices on them that stay where they are
  double length = 0;                 ///< of all together, in the unit of the mesh
};

/// \ingroup PkgAnisotropicHdeRemeshingSchemes
///
/// the aspect ratio \f$ R / (2 r) \f$, circumradius over twice the inradius, beyond which a face is called a needle. Needles are of
/// hardly any use in computations, and no metric that follows a curvature asks for them.
constexpr double needle_aspect_ratio = 1000;

/// \ingroup PkgAnisotropicHdeRemeshingSchemes
///
/// what `CGAL::anisotropic_hde_remeshing()` did, and with which parameters. It chooses those that are not given.
struct Remeshing_result
{
  double sigma = 0;              ///< the weight of the normals, in the unit of the mesh
  double target_edge_length = 0; ///< the 6D edge length aimed at in the end, in the unit of the mesh
  Target binding_target =
      Target::NUMBER_OF_FACES; ///< which of the given targets was reached first, or what kept the mesh from it
  /// the bound on the distance between the faces and the surface, in the unit of the mesh, if an error was asked for. It is at most
  /// the error asked for, unless the number of faces was reached first. By measured error, the distance is that between the mesh
  /// and the input, both ways, and the bound is certain; it is 0 if the mesh stays as it was. With a
  /// function, faces at boundary and constrained curves do not count, and it is infinite where the function does not lead to a
  /// surface. It is infinite if the visitor stopped the search for it.
  double approximation_error = 0;
  /// how many faces were aimed at: `number_of_target_faces`, or as many as there were. With an error, it is the largest number
  /// allowed. It is 0 if a length was asked for, or an error alone.
  std::size_t number_of_target_faces = 0;
  std::size_t number_of_faces = 0;   ///< the faces that have replaced the remeshed ones; 0 if the mesh stays as it was
  std::size_t number_of_needles = 0; ///< of these, the faces with an aspect ratio of more than `needle_aspect_ratio`
  /// of these, the faces beyond `aspect_ratio_bound`, by any scheme; 0 without it
  std::size_t number_of_faces_beyond_aspect_ratio = 0;
  /// of these, the faces that share no edge with another one. Many of them, in a mesh that should be connected, are a sign of
  /// points that coincide and should be one.
  std::size_t number_of_lone_faces = 0;
  /// pairs of faces of the input that intersect, alone or with faces that are not remeshed; 0 without `do_self_intersection_tests`
  std::size_t number_of_self_intersections_before = 0;
  /// the pairs of faces of the result that intersect. If there are more than before, `warnings()` says so. If the visitor stopped
  /// the remeshing, it is the number of the input.
  std::size_t number_of_self_intersections = 0;
  /// whether the remeshing went by measured error, and took the faces for the long and exact facets of a CAD program
  bool has_long_facets = false;
  /// the patches of the function that the package has built, and those of them in which the distance to the input replaces the
  /// function. There parameters such as `smoothing` have no effect. Both are 0 if the function is the caller's, or by measured
  /// error, where there is none.
  std::size_t number_of_patches = 0, number_of_patches_on_fallback = 0;
  unsigned int number_of_iterations = 0; ///< the iterations done
  std::size_t number_of_splits = 0;      ///< edges that were split
  std::size_t number_of_collapses = 0;   ///< edges that were contracted
  std::size_t number_of_flips = 0;       ///< edges that were flipped
  /// between creases, each smooth: one, unless the function is piecewise, or exact facets are kept, each as a region
  std::size_t number_of_regions = 0;
  Feature_curves curves_before, curves_after;  ///< in the input and in the result
  std::size_t number_of_isolated_vertices = 0; ///< isolated vertices of the input, which the result does not have
  /// Vertices of the result that are further from the zero set than 1e-8 of the diagonal of the bounding box. The distance is
  /// the value of the function over the length of its gradient. Vertices of curves and constrained ones do not count, but those of
  /// boundaries do with `project_borders`. There are two reasons. No zero was found near the vertex, and it is on the input. Or the
  /// last step would have folded a face, or made it intersect another one if intersections are tested. Vertices are counted before
  /// `fit_to_surface` moves them.
  std::size_t number_of_unprojected_vertices = 0;
  Projection_counters projections;
  bool was_stopped = false;             ///< whether the visitor ended the remeshing early
  double implicit_function_seconds = 0; ///< wall time of `Stage::IMPLICIT_FUNCTION`
  double projection_seconds = 0;        ///< wall time of `Stage::PROJECTION`
  double remeshing_seconds = 0;         ///< wall time of `Stage::REMESHING`
  double split_seconds = 0;             ///< wall time of the splits; it and the next three are parts of `Stage::REMESHING`
  double collapse_seconds = 0;          ///< wall time of the contractions
  double flip_seconds = 0;              ///< wall time of the flips
  double smoothing_seconds = 0;         ///< wall time of the smoothing
  double output_seconds = 0;            ///< wall time of `Stage::OUTPUT`

  /// Whether the number of faces is not the one aimed at: it differs by more than 1% of it, and by more than two faces. With an
  /// error, fewer faces are no miss.
  bool misses_number_of_faces() const
  {
    if (number_of_target_faces == 0 || number_of_faces == 0 || was_stopped)
      return false;
    const double difference = double(number_of_faces) - double(number_of_target_faces);
    const double allowed = (std::max)(0.01 * double(number_of_target_faces), 2.);
    return difference > allowed || (difference < -allowed && !(approximation_error > 0));
  }

  /// what a caller should know before using the mesh, a line for each: that the number of faces is missed, that more faces
  /// intersect than before, that there are needles, and that the bound on aspect ratios is missed. It is empty if all is well.
  /// The distance to the input is not known here, see `measure_distance()`.
  std::vector<std::string> warnings() const
  {
    std::vector<std::string> result;
    if (misses_number_of_faces())
      result.push_back("there are " + std::to_string(number_of_faces) + " faces, not about " +
                       std::to_string(number_of_target_faces) + " as asked for" + reason());
    if (number_of_self_intersections > number_of_self_intersections_before)
      result.push_back(std::to_string(number_of_self_intersections) + " pairs of faces intersect, " +
                       std::to_string(number_of_self_intersections_before) + " did before");
    if (number_of_needles > 0)
      result.push_back(std::to_string(number_of_needles) + " of " + std::to_string(number_of_faces) +
                       " faces are needles, with an aspect ratio above " + std::to_string(int(needle_aspect_ratio)));
    if (number_of_faces_beyond_aspect_ratio > 0)
      result.push_back(std::to_string(number_of_faces_beyond_aspect_ratio) + " of " + std::to_string(number_of_faces) +
                       " faces are beyond the bound on aspect ratios");
    return result;
  }

private:
  std::string reason() const
  {
    switch (binding_target)
    {
    case Target::FEATURE_CURVES:
      return ": creases, boundaries and constraints need them";
    case Target::GUARDS:
      return ": what is left to do would fold or flatten faces, or change the topology";
    default:
      return "";
    }
  }
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_REMESHING_RESULT_H
