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

The concept `RemeshingEmbedding` describes the space in which `CGAL::anisotropic_hde_remeshing()` makes a mesh uniform and
isotropic. This is a map of the surface into a space of more dimensions, or a Riemannian metric on the surface. All operations
measure lengths by it. They measure angles and areas by the lengths of three sides.

A `Vertex` below is a type of the package that is derived from `Vertex_data`. It has the members `Eigen::Vector3d point` and
`Eigen::Vector3d normal`, a unit vector. Points are in the remesher's own unit: a power of two for which the diagonal of
the bounding box of the mesh is less than one and no less than a half. Const members are called concurrently.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Anisotropic_hde_remeshing::Normal_embedding}
\cgalHasModels{CGAL::Anisotropic_hde_remeshing::Scalar_field_embedding}
\cgalHasModels{CGAL::Anisotropic_hde_remeshing::Sized_embedding}
\cgalHasModelsEnd

\sa `RemeshingMetric`, which is shorter to write where a matrix is all that is needed
*/
class RemeshingEmbedding
{
public:
  /// what the embedding keeps at a vertex: default constructible and copyable, perhaps empty
  typedef unspecified_type Vertex_data;

  /// the same embedding for points that are divided by `unit`
  RemeshingEmbedding in_unit(double unit) const;

  /// the number by which the lengths in the embedding are divided if the points are divided by `unit`
  double unit_of_lengths(double unit) const;

  /// computes the data of a vertex with a new point and normal
  template <typename Vertex>
  void place(Vertex& vertex) const;

  /// the same for a vertex between two others that have their data
  template <typename Vertex>
  void place_between(const Vertex& a, const Vertex& b, Vertex& middle) const;

  /// the squared length of the edge between two vertices; symmetric, positive for different points
  template <typename Vertex>
  double squared_length(const Vertex& a, const Vertex& b) const;

  /// the centroid of the faces about a vertex, as smoothing needs it
  template <typename Vertex>
  class Centroid
  {
  public:
    /// about `center`; `frame` has the axes of its tangent plane. Both outlive the object.
    Centroid(const RemeshingEmbedding& embedding, const Vertex& center, const Eigen::Matrix<double, 3, 2>& frame);

    /// adds a neighbour; `edge` is the vector to it in the frame
    void add_neighbor(const Eigen::Vector2d& edge, const Vertex& neighbor);

    /// adds the face of `center`, `a` and `b`, with its area in the embedding
    void add_face(double area, const Vertex& a, const Vertex& b);

    /// the step in the frame to the centroid, given the shape operator of the surface in the frame
    Eigen::Vector2d tangential_step(const Eigen::Matrix2d& shape_operator) const;
  };
};
