// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Coloured meshes for the pictures of the manual (scripts/make_pictures.sh):
//   draw_function patches MESH OUT.ply K: each face in the colour of its patch
//   draw_function directions MESH REMESHED OUT.ply: REMESHED, with a needle along the direction of least curvature on each face

#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/sequential_vertex_coloring.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;
typedef CGAL::IO::Color Color;

Mesh read(const std::string& file)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read " + file);
  return mesh;
}

std::array<Point_3, 3> corners(const Mesh& mesh, const Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))};
}

// triangles without common vertices, so that each has its own colour
class Picture
{
public:
  void add_triangle(const std::array<Point_3, 3>& triangle, const Color& color)
  {
    std::array<Mesh::Vertex_index, 3> vertices;
    for (std::size_t i = 0; i < 3; ++i)
    {
      vertices[i] = m_mesh.add_vertex(triangle[i]);
      m_colors[vertices[i]] = color;
    }
    m_mesh.add_face(vertices[0], vertices[1], vertices[2]);
  }

  void write(const std::string& file) const
  {
    std::ofstream stream(file, std::ios::binary);
    CGAL::IO::set_binary_mode(stream);
    if (!CGAL::IO::write_PLY(stream, m_mesh))
      throw std::runtime_error("cannot write " + file);
  }

private:
  Mesh m_mesh;
  Mesh::Property_map<Mesh::Vertex_index, Color> m_colors =
      m_mesh.add_property_map<Mesh::Vertex_index, Color>("v:color", Color(255, 255, 255)).first;
};

// colours such that patches that touch differ
std::vector<Color> colors_of_patches(const Mesh& mesh, const std::vector<std::size_t>& patches, const std::size_t n)
{
  typedef boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS> Graph;
  static const std::array<Color, 8> palette = {Color(78, 121, 167),  Color(242, 142, 43), Color(118, 183, 178),
                                               Color(225, 87, 89),   Color(237, 201, 72), Color(89, 161, 79),
                                               Color(176, 122, 161), Color(255, 157, 167)};
  Graph graph(n);
  for (const Mesh::Edge_index e : mesh.edges())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    if (!mesh.is_border(e) && patches[mesh.face(h)] != patches[mesh.face(mesh.opposite(h))])
      boost::add_edge(patches[mesh.face(h)], patches[mesh.face(mesh.opposite(h))], graph);
  }
  std::vector<std::size_t> numbers(n);
  boost::sequential_vertex_coloring(graph,
                                    boost::make_iterator_property_map(numbers.begin(), boost::get(boost::vertex_index, graph)));
  std::vector<Color> colors;
  for (const std::size_t number : numbers)
    colors.push_back(palette[number % palette.size()]);
  return colors;
}

void draw_patches(const Mesh& mesh, const std::size_t number_of_patches, const std::string& file)
{
  const Function function(mesh, params::number_of_patches(number_of_patches));
  std::vector<std::size_t> patches;
  for (const Mesh::Face_index f : mesh.faces())
  {
    const auto [a, b, c] = corners(mesh, f);
    patches.push_back(function.patch(CGAL::centroid(a, b, c)));
  }
  const std::vector<Color> colors = colors_of_patches(mesh, patches, function.diagnostics().number_of_patches);
  Picture picture;
  for (const Mesh::Face_index f : mesh.faces())
    picture.add_triangle(corners(mesh, f), colors[patches[f]]);
  picture.write(file);
  std::cout << function.diagnostics().number_of_patches << " patches" << std::endl;
}

// a needle above the middle of the triangle, as long as a quarter of the longest edge
void add_needle(const std::array<Point_3, 3>& triangle, const Function& function, Picture& picture)
{
  const auto [a, b, c] = triangle;
  const double length =
      std::sqrt((std::max)({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)}));
  const Vector_3 normal = CGAL::unit_normal(a, b, c);
  const Point_3 middle = CGAL::centroid(a, b, c) + 0.02 * length * normal;
  const auto curvatures = function.principal_curvatures(CGAL::centroid(a, b, c));
  const bool is_min_flatter = std::abs(curvatures.min_curvature) < std::abs(curvatures.max_curvature);
  const Vector_3 along = 0.25 * length * (is_min_flatter ? curvatures.min_direction : curvatures.max_direction);
  const Vector_3 across = 0.12 * CGAL::cross_product(normal, along);
  const Color red(200, 30, 30);
  picture.add_triangle({middle - across, middle + along, middle + across}, red);
  picture.add_triangle({middle + across, middle - along, middle - across}, red);
}

void draw_directions(const Mesh& mesh, const Mesh& remeshed, const std::string& file)
{
  const Function function(mesh);
  Picture picture;
  for (const Mesh::Face_index f : remeshed.faces())
  {
    picture.add_triangle(corners(remeshed, f), Color(242, 230, 204));
    add_needle(corners(remeshed, f), function, picture);
  }
  picture.write(file);
}

} // namespace

int main(int argc, char* argv[])
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try
  {
    if (arguments.size() == 4 && arguments[0] == "patches")
      draw_patches(read(arguments[1]), std::stoul(arguments[3]), arguments[2]);
    else if (arguments.size() == 4 && arguments[0] == "directions")
      draw_directions(read(arguments[1]), read(arguments[2]), arguments[3]);
    else
      return std::cerr << "Usage: draw_function patches MESH OUT.ply K | directions MESH REMESHED OUT.ply" << std::endl, 2;
  }
  catch (const std::exception& error)
  {
    return std::cerr << "draw_function: " << error.what() << std::endl, 1;
  }
  return 0;
}
