// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Mesh.h"
#include "Failure.h"

#include <CGAL/version.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

// Looks at a soup point by point, face by face, edge by edge; the first thing wrong ends the program. Messages count
// from one and say how many there are, as formats differ in where they begin to count.
class Soup_inspector
{
  // a side of a face: its ends, and the corners of the face there
  struct Side
  {
    std::size_t low, high;
    bool is_upward; // runs from `low` to `high` in its face
    std::size_t corner_at_low, corner_at_high;

    bool operator<(const Side& other) const { return std::make_pair(low, high) < std::make_pair(other.low, other.high); }
  };

public:
  Soup_inspector(const Soup& soup, const std::string& file_name) : m_soup(soup), m_file_name(file_name) {}

  void inspect_points() const
  {
    if (m_soup.faces.empty())
      fail("it has no faces");
    inspect_coordinates();
    inspect_indices();
  }

  void inspect_mesh()
  {
    inspect_faces();
    inspect_edges();
    inspect_vertices();
  }

private:
  [[noreturn]] void fail(const std::string& reason) const { throw Failure(in_quotes(m_file_name) + ": " + reason); }

  [[noreturn]] void fail_but_for_repair(const std::string& reason) const { fail(reason + " (--repair may mend it)"); }

  std::string vertex(const std::size_t i) const
  {
    return "vertex " + std::to_string(i + 1) + " of " + std::to_string(m_soup.points.size());
  }

  std::string face(const std::size_t i) const
  {
    return "face " + std::to_string(i + 1) + " of " + std::to_string(m_soup.faces.size());
  }

  void inspect_coordinates() const
  {
    for (std::size_t i = 0; i < m_soup.points.size(); ++i)
      for (int k = 0; k < 3; ++k)
        if (!std::isfinite(m_soup.points[i][k]))
          fail(vertex(i) + " has the coordinate " + std::to_string(m_soup.points[i][k]));
  }

  void inspect_indices() const
  {
    for (std::size_t i = 0; i < m_soup.faces.size(); ++i)
      for (const std::size_t v : m_soup.faces[i])
        if (v >= m_soup.points.size())
          fail(face(i) + " names a vertex that does not exist: there are " + std::to_string(m_soup.points.size()));
  }

  void inspect_faces() const
  {
    for (std::size_t i = 0; i < m_soup.faces.size(); ++i)
    {
      const std::vector<std::size_t>& f = m_soup.faces[i];
      if (f.size() != 3)
        fail_but_for_repair(face(i) + " has " + std::to_string(f.size()) + " vertices, but only triangles are remeshed");
      if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0])
        fail_but_for_repair(face(i) + " has the same vertex twice");
    }
  }

  std::vector<Side> sorted_sides() const
  {
    std::vector<Side> sides;
    sides.reserve(3 * m_soup.faces.size());
    for (std::size_t i = 0; i < m_soup.faces.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t a = m_soup.faces[i][k], b = m_soup.faces[i][(k + 1) % 3];
        const std::size_t corner_a = 3 * i + k, corner_b = 3 * i + (k + 1) % 3;
        sides.push_back(a < b ? Side{a, b, true, corner_a, corner_b} : Side{b, a, false, corner_b, corner_a});
      }
    std::stable_sort(sides.begin(), sides.end());
    return sides;
  }

  // Every edge has one face, or two that run through it in opposite directions. On the way, joins the corners at its
  // ends.
  void inspect_edges()
  {
    m_next_corner.resize(3 * m_soup.faces.size());
    std::iota(m_next_corner.begin(), m_next_corner.end(), std::size_t(0));
    const std::vector<Side> sides = sorted_sides();
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
    {
      while (end < sides.size() && !(sides[begin] < sides[end]))
        ++end;
      const Side& first = sides[begin];
      const std::string edge = "between " + vertex(first.low) + " and vertex " + std::to_string(first.high + 1);
      if (end - begin > 2)
        fail_but_for_repair("the edge " + edge + " has " + std::to_string(end - begin) + " faces, which no manifold mesh has");
      if (end - begin < 2)
        continue;
      const Side& second = sides[begin + 1];
      if (first.is_upward == second.is_upward)
        fail_but_for_repair(face(first.corner_at_low / 3) + " and face " + std::to_string(second.corner_at_low / 3 + 1) +
                            " are not oriented alike at their common edge " + edge);
      join(first.corner_at_low, second.corner_at_low);
      join(first.corner_at_high, second.corner_at_high);
    }
  }

  // The faces at a vertex hang together over edges: if not, two sheets touch in a point.
  void inspect_vertices()
  {
    const std::size_t none = (std::numeric_limits<std::size_t>::max)();
    std::vector<std::size_t> sheets(m_soup.points.size(), none);
    for (std::size_t corner = 0; corner < m_next_corner.size(); ++corner)
    {
      const std::size_t v = m_soup.faces[corner / 3][corner % 3], sheet = root(corner);
      if (sheets[v] == none)
        sheets[v] = sheet;
      else if (sheets[v] != sheet)
        fail_but_for_repair("at " + vertex(v) + " sheets of the surface touch in a point, which no manifold mesh does");
    }
  }

  std::size_t root(std::size_t corner)
  {
    while (m_next_corner[corner] != corner)
      corner = m_next_corner[corner] = m_next_corner[m_next_corner[corner]];
    return corner;
  }

  void join(const std::size_t a, const std::size_t b) { m_next_corner[root(a)] = root(b); }

  const Soup& m_soup;
  const std::string& m_file_name;
  std::vector<std::size_t> m_next_corner; // merges corners into sets
};

} // namespace

void check_points(const Soup& soup, const std::string& file_name) { Soup_inspector(soup, file_name).inspect_points(); }

Checked_mesh mesh_of_soup(const Soup& soup, const std::string& file_name)
{
  check_points(soup, file_name);
  Soup_inspector(soup, file_name).inspect_mesh();
  std::vector<char> is_used(soup.points.size(), 0);
  for (const std::vector<std::size_t>& f : soup.faces)
    for (const std::size_t v : f)
      is_used[v] = 1;
  Checked_mesh result;
  std::vector<Mesh::Vertex_index> vertices(soup.points.size());
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (is_used[v])
    {
      vertices[v] = result.mesh.add_vertex(soup.points[v]);
      result.positions.push_back(v);
    }
    else
      ++result.number_of_isolated_vertices;
  for (const std::vector<std::size_t>& f : soup.faces)
    if (result.mesh.add_face(vertices[f[0]], vertices[f[1]], vertices[f[2]]) == Mesh::null_face())
      throw Failure(in_quotes(file_name) + ": its faces do not make a manifold mesh");
  return result;
}

Soup soup_of_mesh(const Mesh& mesh)
{
  Soup soup;
  std::vector<std::size_t> numbers(mesh.num_vertices());
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    numbers[v] = soup.points.size();
    soup.points.push_back(mesh.point(v));
  }
  for (const Mesh::Face_index f : mesh.faces())
  {
    soup.faces.emplace_back();
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      soup.faces.back().push_back(numbers[v]);
  }
  return soup;
}

namespace {

template <typename Number>
void add_vertex_property(const Array& array, Mesh& mesh)
{
  auto property = mesh.add_property_map<Mesh::Vertex_index, Number>(array.name).first;
  for (const Mesh::Vertex_index v : mesh.vertices())
    property[v] = static_cast<Number>(array.values[v]);
}

} // namespace

Mesh mesh_with_arrays(const Soup& soup)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Point_3& p : soup.points)
    vertices.push_back(mesh.add_vertex(p));
  for (const std::vector<std::size_t>& f : soup.faces)
    mesh.add_face(vertices[f[0]], vertices[f[1]], vertices[f[2]]);
  for (const Array& array : soup.vertex_arrays)
    if (array.are_bytes)
      add_vertex_property<std::uint8_t>(array, mesh);
    else
      add_vertex_property<double>(array, mesh);
  for (const Array& array : soup.face_arrays)
  {
    auto property = mesh.add_property_map<Mesh::Face_index, double>(array.name).first;
    for (const Mesh::Face_index f : mesh.faces())
      property[f] = array.values[f];
  }
  return mesh;
}

namespace {

const char* name_of_field = "v:hde_remesh_field";
const char* name_of_creases = "e:hde_remesh_crease";
const char* name_of_regions = "f:hde_remesh_region";

// CGAL 6 returns a std::optional, what came before it a pair of the map and whether it exists.
template <typename Index, typename Value>
std::optional<Mesh::Property_map<Index, Value>> find_property(const Mesh& mesh, const std::string& name)
{
  const auto found = mesh.property_map<Index, Value>(name);
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  return found;
#else
  return found.second ? std::make_optional(found.first) : std::nullopt;
#endif
}

} // namespace

Field add_field(Mesh& mesh) { return mesh.add_property_map<Mesh::Vertex_index, double>(name_of_field, 0.).first; }

std::optional<Field> field_of(const Mesh& mesh) { return find_property<Mesh::Vertex_index, double>(mesh, name_of_field); }

Creases add_creases(Mesh& mesh)
{
  return Creases{mesh.add_property_map<Mesh::Edge_index, bool>(name_of_creases, false).first,
                 mesh.add_property_map<Mesh::Face_index, std::size_t>(name_of_regions, 0).first};
}

Creases creases_of(const Mesh& mesh)
{
  return Creases{find_property<Mesh::Edge_index, bool>(mesh, name_of_creases).value(),
                 find_property<Mesh::Face_index, std::size_t>(mesh, name_of_regions).value()};
}

} // namespace hde_remesh
