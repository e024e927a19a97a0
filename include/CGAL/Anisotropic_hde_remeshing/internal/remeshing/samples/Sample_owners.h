// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_SAMPLE_OWNERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_SAMPLE_OWNERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Space_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Reference_samples.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Which face of the working mesh each sample of the reference belongs to: the nearest one that does not look the other way. So
// each face knows what it stands for, and how far it is from it. Operations hand the samples over to the faces that follow.
template <typename ConcurrencyTag, typename Mesh>
class Sample_owners
{
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  static constexpr int largest_number_of_steps = 64;
  static constexpr double far_ratio = 9;     // of a squared distance to the mean
  static constexpr double other_side = 16;   // the factor of squared distances to faces that look the other way
  static constexpr double price_beyond = 20; // of a squared distance above the largest that is allowed, over that

public:
  Sample_owners(const Mesh& mesh, const Reference_samples& samples)
    : m_mesh(mesh),
      m_samples(samples),
      m_owners(samples.size(), none),
      m_next(samples.size(), none),
      m_squared_distances(samples.size(), 0.f)
  {
  }

  const Reference_sample& sample(const std::uint32_t i) const { return m_samples[i]; }
  // of a sample to its face
  double squared_distance_of(const std::uint32_t i) const { return m_squared_distances[i]; }
  double area_of_surface() const { return m_samples.area_of_surface(); }

  // `vertex_of(s)` is the vertex of the mesh at which the search for the owner of a sample starts
  template <typename VertexOf>
  void start(const VertexOf& vertex_of)
  {
    parallel_for<ConcurrencyTag>(m_samples.size(),
                                 [&](const std::size_t i)
                                 {
                                   const Halfedge_index h = m_mesh.halfedge(vertex_of(m_samples[i]));
                                   m_owners[i] = m_mesh.face(m_mesh.is_border(h) ? m_mesh.opposite(h) : h);
                                 });
  }

  // Finds the nearest face of each sample by walking from its owner, and measures all faces. A walk may miss the nearest face:
  // samples that are far from theirs are also searched for, if it is asked for.
  void update(const bool searches_for_far_samples = true)
  {
    parallel_for<ConcurrencyTag>(m_samples.size(), [&](const std::size_t i) { walk(i); });
    if (searches_for_far_samples)
      search_for_far_samples();
    m_first.assign(face_capacity(m_mesh), none);
    for (std::size_t i = m_samples.size(); i-- > 0;)
      link(std::uint32_t(i), Face_index(m_owners[i]));
    m_mean_square = sum_of_squares();
    measure_faces();
  }

  // of the distances of the samples
  double mean_square() const { return m_mean_square; }

  // makes distances above this one dear
  void set_largest_distance(const double distance) { m_largest_square = distance * distance; }
  bool bounds_distance() const { return m_largest_square < (std::numeric_limits<double>::infinity)(); }
  double largest_square() const { return m_largest_square; }

  // What a distance costs, over its square. The cost is the third power: by that the largest distance becomes about a third
  // smaller than by least squares, and the root mean square 2% larger.
  double weight(const double squared_distance) const
  {
    if (!(m_mean_square > 0))
      return 1;
    const double weight = std::sqrt(squared_distance / m_mean_square);
    return squared_distance > m_largest_square ? weight * (1 + price_beyond * (squared_distance / m_largest_square - 1))
                                               : weight;
  }
  double cost(const double squared_distance) const { return squared_distance * weight(squared_distance); }

  // of a face, both ways; and the sum of the normals of its samples weighted by areas
  double cost(const Face_index f) const { return m_costs[f]; }
  const Vector& normal(const Face_index f) const { return m_normals[f]; }

  // the square of the largest distance of a sample of a face
  double squared_distance(const Face_index f) const
  {
    double largest = 0;
    for_each(f, [&](const std::uint32_t i) { largest = (std::max)(largest, double(m_squared_distances[i])); });
    return largest;
  }

  // Points of a face, by their barycentric coordinates, for the way from the face to the reference: the centroid, the middles of
  // the edges, and the corners, as these are often the farthest. The weights are those that gave the least distances on many
  // meshes. They integrate linear functions exactly.
  struct Node
  {
    Vector barycentric;
    double weight;
  };
  static constexpr std::size_t number_of_nodes = 7;
  static const Node& node(const std::size_t k)
  {
    static const double of_centroid = 0.6, of_middle = 0.12, of_corner = (1 - of_centroid) / 3 - of_middle;
    static const std::array<Node, number_of_nodes> nodes{Node{Vector(1. / 3, 1. / 3, 1. / 3), of_centroid},
                                                         Node{Vector(0, .5, .5), of_middle},
                                                         Node{Vector(.5, 0, .5), of_middle},
                                                         Node{Vector(.5, .5, 0), of_middle},
                                                         Node{Vector(1, 0, 0), of_corner},
                                                         Node{Vector(0, 1, 0), of_corner},
                                                         Node{Vector(0, 0, 1), of_corner}};
    return nodes[k];
  }

  // the sample that is nearest to a node of a face among those of the face and its neighbours; none if they have none
  std::uint32_t nearest(const Face_index f, const std::size_t k) const { return m_nearest[f][k]; }
  static bool is_none(const std::uint32_t i) { return i == none; }

  // the point of the reference near q, by the plane of a sample
  Vector reference_point(const Vector& q, const std::uint32_t i) const
  {
    const Reference_sample& s = m_samples[i];
    const Vector normal = s.normal.template cast<double>();
    const Vector aside = q - s.point - normal.dot(q - s.point) * normal;
    const double length = aside.norm();
    return length > s.reach ? Vector(s.point + (s.reach / length) * aside) : Vector(s.point + aside);
  }

  // the samples that are nearest to the nodes of a face
  typedef std::array<std::uint32_t, number_of_nodes> Nearest_samples;

  // What the way from a triangle to the reference costs; infinite if a node is further than a distance. `visit_samples(visit)`
  // visits the samples that come into question.
  template <typename VisitSamples>
  double cost_of_way_back(const Space_triangle& t, const VisitSamples& visit_samples, Nearest_samples& nearest,
                          const double largest_squared_distance = (std::numeric_limits<double>::infinity)()) const
  {
    find_nearest(t, visit_samples, nearest);
    double sum = 0;
    for (std::size_t k = 0; k < number_of_nodes; ++k)
      if (nearest[k] != none)
      {
        const double squared_distance = squared_distance_of_node(t, k, nearest[k]);
        if (squared_distance > largest_squared_distance)
          return (std::numeric_limits<double>::infinity)();
        sum += node(k).weight * cost(squared_distance);
      }
    return m_samples.area_of_surface() > 0 ? sum * t.normal().norm() / (2 * m_samples.area_of_surface()) : 0.;
  }

  Space_triangle triangle(const Face_index f) const
  {
    const Triangle t(m_mesh.halfedge(f), m_mesh);
    return Space_triangle{m_mesh.point(t.a).point, m_mesh.point(t.b).point, m_mesh.point(t.c).point};
  }

  template <typename Visit>
  void for_each(const Face_index f, const Visit& visit) const
  {
    for (std::uint32_t i = m_first[f]; i != none; i = m_next[i])
      visit(i);
  }

  // takes the samples of a face away and adds them to a list
  void take(const Face_index f, std::vector<std::uint32_t>& samples)
  {
    for_each(f, [&](const std::uint32_t i) { samples.push_back(i); });
    m_first[f] = none;
  }

  // makes room for faces that an operation has added
  void resize()
  {
    m_first.resize(face_capacity(m_mesh), none);
    m_costs.resize(face_capacity(m_mesh), 0.);
    m_normals.resize(face_capacity(m_mesh), Vector::Zero());
    m_nearest.resize(face_capacity(m_mesh));
  }

  // gives samples to the nearest of the faces, and measures these
  template <typename Faces>
  void give(const std::vector<std::uint32_t>& samples, const Faces& faces)
  {
    for (const std::uint32_t i : samples)
    {
      double least = (std::numeric_limits<double>::infinity)();
      Face_index nearest = *faces.begin();
      for (const Face_index f : faces)
      {
        const double squared_distance = triangle(f).closest(m_samples[i].point).squared_distance;
        if (squared_distance < least)
        {
          least = squared_distance;
          nearest = f;
        }
      }
      m_squared_distances[i] = float(least);
      m_owners[i] = nearest;
      link(i, nearest);
    }
    for (const Face_index f : faces)
      measure(f);
  }

  // the samples of a face and of the faces beyond its edges; if there are none, of all faces around its corners
  template <typename Visit>
  void for_each_around(const Face_index f, const Visit& visit) const
  {
    bool is_any = false;
    const auto visit_samples_of = [&](const Face_index g)
    {
      is_any = is_any || m_first[g] != none;
      for_each(g, visit);
    };
    visit_samples_of(f);
    const Halfedge_index h = m_mesh.halfedge(f);
    for (const Halfedge_index g : {m_mesh.opposite(h), m_mesh.opposite(m_mesh.next(h)), m_mesh.opposite(m_mesh.prev(h))})
      if (!m_mesh.is_border(g))
        visit_samples_of(m_mesh.face(g));
    if (is_any)
      return;
    for (const Halfedge_index corner : {h, m_mesh.next(h), m_mesh.prev(h)})
      for (const Halfedge_index g : m_mesh.halfedges_around_target(corner))
        if (!m_mesh.is_border(g))
          for_each(m_mesh.face(g), visit);
  }

private:
  // The nodes of a triangle, and the sample nearest to each. This is the innermost loop: single precision, seen from a corner, no
  // branches and a number that is a power of two let the compiler look at several nodes at once.
  struct Searched_nodes
  {
    static constexpr std::size_t size = 8;

    explicit Searched_nodes(const Space_triangle& t) : origin(t.a)
    {
      for (std::size_t k = 0; k < size; ++k)
      {
        const Vector p = t.point(node(k % number_of_nodes).barycentric) - origin;
        x[k] = float(p[0]);
        y[k] = float(p[1]);
        z[k] = float(p[2]);
      }
      least.fill((std::numeric_limits<float>::infinity)());
      nearest.fill(none);
    }

    void look_at(const std::uint32_t i, const Vector& point, const float factor)
    {
      const Eigen::Vector3f p = (point - origin).cast<float>();
      std::array<float, size> squared_distances;
      for (std::size_t k = 0; k < size; ++k)
      {
        const float dx = x[k] - p[0], dy = y[k] - p[1], dz = z[k] - p[2];
        squared_distances[k] = factor * (dx * dx + dy * dy + dz * dz);
      }
      for (std::size_t k = 0; k < size; ++k)
      {
        const std::uint32_t is_nearer = 0u - std::uint32_t(squared_distances[k] < least[k]); // all bits
        nearest[k] = (nearest[k] & ~is_nearer) | (i & is_nearer);
      }
      for (std::size_t k = 0; k < size; ++k)
        least[k] = squared_distances[k] < least[k] ? squared_distances[k] : least[k];
    }

    const Vector origin;
    std::array<float, size> x, y, z, least;
    std::array<std::uint32_t, size> nearest;
  };

  template <typename VisitSamples>
  void find_nearest(const Space_triangle& t, const VisitSamples& visit_samples, Nearest_samples& nearest) const
  {
    const Vector normal = t.normal();
    Searched_nodes nodes(t);
    visit_samples(
        [&](const std::uint32_t i)
        {
          const Reference_sample& s = m_samples[i];
          nodes.look_at(i, s.point, normal.dot(s.normal.template cast<double>()) < 0 ? float(other_side) : 1.f);
        });
    std::copy_n(nodes.nearest.begin(), number_of_nodes, nearest.begin());
  }

  double squared_distance_of_node(const Space_triangle& t, const std::size_t k, const std::uint32_t nearest) const
  {
    const Vector q = t.point(node(k).barycentric);
    return (reference_point(q, nearest) - q).squaredNorm();
  }

  // of the distances of the samples, weighted by their areas
  double sum_of_squares() const
  {
    return parallel_sum<ConcurrencyTag>(m_samples.size(), [&](const std::size_t i)
                                        { return double(m_samples[i].area) * m_squared_distances[i]; });
  }

  void measure_faces()
  {
    m_costs.assign(face_capacity(m_mesh), 0.);
    m_normals.assign(face_capacity(m_mesh), Vector::Zero());
    m_nearest.resize(face_capacity(m_mesh));
    parallel_for<ConcurrencyTag>(face_capacity(m_mesh), [&](const std::size_t f) { measure(Face_index(std::uint32_t(f))); });
  }

  void link(const std::uint32_t i, const Face_index f)
  {
    m_next[i] = m_first[f];
    m_first[f] = i;
  }

  void measure(const Face_index f)
  {
    if (m_mesh.is_removed(f))
      return;
    double sum = 0;
    Vector normal = Vector::Zero();
    for_each(f,
             [&](const std::uint32_t i)
             {
               sum += m_samples[i].area * cost(m_squared_distances[i]);
               normal += m_samples[i].area * m_samples[i].normal.template cast<double>();
             });
    m_costs[f] = sum + cost_of_way_back(
                           triangle(f), [&](const auto& visit) { for_each_around(f, visit); }, m_nearest[f]);
    m_normals[f] = normal;
  }

  // Samples that are far from their face may have missed a nearer one: these are looked for in all of the mesh.
  void search_for_far_samples()
  {
    const double mean_square = sum_of_squares();
    std::vector<std::uint32_t> far;
    for (std::size_t i = 0; i < m_samples.size(); ++i)
      if (m_squared_distances[i] > far_ratio * mean_square)
        far.push_back(std::uint32_t(i));
    if (far.empty())
      return;
    std::vector<Vector> points(vertex_capacity(m_mesh), Vector::Zero());
    for (const Vertex_index v : m_mesh.vertices())
      points[v] = m_mesh.point(v).point;
    std::vector<Facet> facets;
    std::vector<Face_index> faces;
    for (const Face_index f : m_mesh.faces())
    {
      const Triangle t(m_mesh.halfedge(f), m_mesh);
      facets.push_back(Facet{t.a, t.b, t.c});
      faces.push_back(f);
    }
    const Closest_facet closest_facet(points, facets);
    if (closest_facet.empty())
      return;
    parallel_for<ConcurrencyTag>(
        far.size(),
        [&](const std::size_t k)
        {
          const std::size_t i = far[k];
          const Face_index f = faces[closest_facet(m_samples[i].point).facet];
          if (view(f, m_samples[i]).key < view(Face_index(m_owners[i]), m_samples[i]).key)
          {
            m_owners[i] = f;
            walk(i);
          }
        },
        16);
  }

  // where a sample is seen from a face
  struct View
  {
    Closest_on_triangle closest;
    double key;      // the squared distance; faces that look the other way count as farther away
    bool is_nearest; // no face beside this one can be nearer: its edges are farther away than the sample
  };

  View view(const Face_index f, const Reference_sample& sample) const
  {
    const Space_triangle t = triangle(f);
    const Vector normal = t.normal();
    View result{t.closest(sample.point), 0, false};
    const bool looks_away = normal.dot(sample.normal.template cast<double>()) < 0;
    result.key = (looks_away ? other_side : 1.) * result.closest.squared_distance;
    const double least = result.closest.barycentric.minCoeff();
    if (least > 0 && !looks_away)
    {
      // the least barycentric coordinate times the least altitude is no more than the distance from the foot to the edges
      const double longest = (std::max)({(t.b - t.a).squaredNorm(), (t.c - t.b).squaredNorm(), (t.a - t.c).squaredNorm()});
      result.is_nearest = result.key * longest <= least * least * normal.squaredNorm();
    }
    return result;
  }

  // From face to face as long as the distance becomes less.
  void walk(const std::size_t i)
  {
    const Reference_sample& sample = m_samples[i];
    Face_index f(m_owners[i]);
    View best = view(f, sample);
    for (int step = 0; step < largest_number_of_steps && !best.is_nearest; ++step)
    {
      const Face_index next = nearest_beside(f, sample, best);
      if (next == f)
        break;
      f = next;
    }
    m_owners[i] = f;
    m_squared_distances[i] = float(best.closest.squared_distance);
  }

  // The nearest of a face, the faces around the corner nearest to the sample, and the face across the nearest edge.
  Face_index nearest_beside(const Face_index from, const Reference_sample& sample, View& best) const
  {
    Vector::Index nearest, farthest;
    best.closest.barycentric.maxCoeff(&nearest);
    best.closest.barycentric.minCoeff(&farthest);
    const Halfedge_index h = m_mesh.halfedge(from); // from the first corner to the second one
    const Halfedge_index into_corner = nearest == 0 ? m_mesh.prev(h) : nearest == 1 ? h : m_mesh.next(h);
    const Halfedge_index across = m_mesh.opposite(farthest == 0 ? m_mesh.next(h) : farthest == 1 ? m_mesh.prev(h) : h);
    Face_index result = from;
    const auto look_at = [&](const Halfedge_index g)
    {
      if (m_mesh.is_border(g) || m_mesh.face(g) == from)
        return;
      const View other = view(m_mesh.face(g), sample);
      if (other.key < best.key)
      {
        best = other;
        result = m_mesh.face(g);
      }
    };
    for (const Halfedge_index g : m_mesh.halfedges_around_target(into_corner))
      look_at(g);
    look_at(across);
    return result;
  }

  const Mesh& m_mesh;
  const Reference_samples& m_samples;
  std::vector<std::uint32_t> m_owners, m_next; // by sample
  std::vector<float> m_squared_distances;      // by sample
  std::vector<std::uint32_t> m_first;          // by face
  std::vector<double> m_costs;
  std::vector<Vector> m_normals;
  std::vector<Nearest_samples> m_nearest; // to the nodes of a face
  double m_mean_square = 0;
  double m_largest_square = (std::numeric_limits<double>::infinity)();
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_SAMPLE_OWNERS_H
