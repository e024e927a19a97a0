// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The parts that the time goes into, by Google Benchmark: evaluation, projection, and each local operation on an ellipsoid of
// 81,920 faces; `items_per_second` counts evaluations, points, and vertices, edges or faces looked at.

#include "scans.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Operation_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_collapser.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_flipper.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_splitter.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Vertex_smoother.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_projection.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace shapes;
namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace internal = Hde::internal;

typedef CGAL::Parallel_if_available_tag Tag;
typedef Hde::Normal_embedding Embedding;
typedef internal::Working_mesh<Embedding::Vertex_data> Working_mesh;
typedef internal::Surface_projection<Ellipsoid_function> Projection;
typedef internal::Mesh_intersections<Working_mesh> Intersections;
typedef internal::Operation_guard<Working_mesh, Ellipsoid_function> Guard;

// An ellipsoid as the remesher sees it, with the length that its edges would have if they were uniform.
class Scene
{
public:
  Scene() : m_input({}, {}, 1.), m_projection(m_function, m_input), m_curves(m_no_mesh)
  {
    const Mesh input = ellipsoid(6);
    for (const auto v : input.vertices())
    {
      Working_mesh::Vertex state;
      state.point = internal::to_vector(input.point(v));
      m_projection.project(state, 0, 1);
      m_vertices.push_back(state);
    }
    for (const auto f : input.faces())
      for (const auto v : CGAL::vertices_around_face(input.halfedge(f), input))
        m_corners.push_back(v);
    Working_mesh mesh;
    fill(mesh);
    double sum = 0;
    for (const auto e : mesh.edges())
      sum += m_embedding.squared_length(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
    m_length = std::sqrt(sum / double(mesh.number_of_edges()));
  }

  const std::vector<Working_mesh::Vertex>& vertices() const { return m_vertices; }
  const Projection& projection() const { return m_projection; }

  void fill(Working_mesh& mesh) const
  {
    for (const Working_mesh::Vertex& vertex : m_vertices)
      mesh.add_vertex(vertex);
    for (std::size_t i = 0; i < m_corners.size(); i += 3)
      mesh.add_face(internal::Vertex_index(m_corners[i]), internal::Vertex_index(m_corners[i + 1]),
                    internal::Vertex_index(m_corners[i + 2]));
  }

  void split(Working_mesh& mesh)
  {
    const Guard guard = guard_of(mesh);
    internal::Edge_splitter<Tag, Embedding, Projection, Guard>(mesh, m_embedding, m_projection, m_curves, guard,
                                                               m_never)(4. / 3 * m_length);
  }

  void collapse(Working_mesh& mesh)
  {
    const Guard guard = guard_of(mesh);
    internal::Edge_collapser<Tag, Embedding, Guard>(mesh, m_embedding, m_curves, guard, m_never)(0.8 * m_length,
                                                                                                 4. / 3 * m_length);
  }

  void flip(Working_mesh& mesh, const internal::Flip_criterion criterion)
  {
    const Guard guard = guard_of(mesh);
    internal::Edge_flipper<Tag, Embedding, Guard>(mesh, m_embedding, guard, m_never)(criterion);
  }

  void smooth(Working_mesh& mesh, const internal::Smoothing_step kind)
  {
    const Guard guard = guard_of(mesh);
    internal::Vertex_smoother<Tag, Embedding, Projection, Guard>(mesh, m_embedding, m_projection, m_curves, guard,
                                                                 m_never)(1, kind);
  }

private:
  Guard guard_of(const Working_mesh& mesh) { return Guard(mesh, m_function, m_intersections); }

  const Ellipsoid_function m_function;
  const internal::Input_surface m_input;
  const Embedding m_embedding{1.6};
  Projection m_projection;
  Working_mesh m_no_mesh;
  Intersections m_intersections{m_no_mesh, internal::Obstacles(), false};
  internal::Curve_network m_curves;
  internal::Interruption m_never;
  std::vector<Working_mesh::Vertex> m_vertices;
  std::vector<Mesh::size_type> m_corners;
  double m_length = 0;
};

Scene& scene()
{
  static Scene instance;
  return instance;
}

// each time on a fresh copy of the mesh
template <typename Operation>
void run(benchmark::State& state, const Operation& operation)
{
  for (auto _ : state)
  {
    state.PauseTiming();
    Working_mesh mesh;
    scene().fill(mesh);
    state.ResumeTiming();
    operation(mesh);
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(scene().vertices().size()));
}

void evaluation(benchmark::State& state)
{
  const Mesh input = ellipsoid(5);
  const Rbf_function function(input);
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        function.value_and_gradient(input.point(Mesh::Vertex_index(unsigned(i++ % input.number_of_vertices())))));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(evaluation);

void projection(benchmark::State& state)
{
  std::size_t i = 0;
  for (auto _ : state)
  {
    Working_mesh::Vertex vertex = scene().vertices()[i++ % scene().vertices().size()];
    vertex.point *= 1.001;
    scene().projection().project(vertex, 0, 1);
    benchmark::DoNotOptimize(vertex);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(projection);

void splits(benchmark::State& state)
{
  run(state, [](Working_mesh& mesh) { scene().split(mesh); });
}
BENCHMARK(splits)->UseRealTime()->Unit(benchmark::kMillisecond);

void contractions(benchmark::State& state)
{
  run(state, [](Working_mesh& mesh) { scene().collapse(mesh); });
}
BENCHMARK(contractions)->UseRealTime()->Unit(benchmark::kMillisecond);

void flips_for_valence(benchmark::State& state)
{
  run(state, [](Working_mesh& mesh) { scene().flip(mesh, internal::Flip_criterion::VALENCE); });
}
BENCHMARK(flips_for_valence)->UseRealTime()->Unit(benchmark::kMillisecond);

void flips_for_angle(benchmark::State& state)
{
  run(state, [](Working_mesh& mesh) { scene().flip(mesh, internal::Flip_criterion::ANGLE); });
}
BENCHMARK(flips_for_angle)->UseRealTime()->Unit(benchmark::kMillisecond);

void predicted_smoothing(benchmark::State& state)
{
  run(state, [](Working_mesh& mesh) { scene().smooth(mesh, internal::Smoothing_step::PREDICT); });
}
BENCHMARK(predicted_smoothing)->UseRealTime()->Unit(benchmark::kMillisecond);

void projected_smoothing(benchmark::State& state)
{
  run(state, [](Working_mesh& mesh) { scene().smooth(mesh, internal::Smoothing_step::PROJECT); });
}
BENCHMARK(projected_smoothing)->UseRealTime()->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
