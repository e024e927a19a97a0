// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The function of cells of the input: as accurate as one function of all, twice differentiable where cells meet, and the same bits
// whoever asks.

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Cell_functions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Input_partition.h>
#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>

#include "check.h"
#include "pieces.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
using pieces::internal::Vector;

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, pieces::Concurrency_tag> Whole_function;
const auto function_parameters = params::close_holes(false);
typedef pieces::internal::Cell_functions<pieces::Concurrency_tag, std::decay_t<decltype(function_parameters)>> Cell_functions;

const std::size_t unlimited_memory = std::size_t(1) << 40;

Kernel::Point_3 to_point(const Vector& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); }

// a mesh, divided
struct Divided
{
  Divided(const shapes::Mesh& mesh, const std::size_t faces_of_piece, const std::size_t faces_of_cell)
    : shares(pieces::shares_of(mesh, mesh.number_of_faces() / 3)),
      partition(shares, team, store, faces_of_piece, faces_of_cell),
      input(partition.input_of_cells(store))
  {
  }

  Cell_functions functions(const std::size_t memory_bytes = unlimited_memory) const
  {
    return Cell_functions(partition.tree(), input, function_parameters, memory_bytes);
  }

  const pieces::internal::Shares_of_soup shares;
  pieces::internal::Memory_store store;
  pieces::internal::Team_of_one team;
  const pieces::internal::Input_partition partition;
  const pieces::internal::Input_of_cells input;
};

const pieces::internal::Space_box everywhere{Vector::Constant(-1e9), Vector::Constant(1e9)};

// at the centres of the faces
std::vector<Vector> places_on(const shapes::Mesh& mesh)
{
  std::vector<Vector> places;
  for (const auto f : mesh.faces())
  {
    Vector sum = Vector::Zero();
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      sum += pieces::internal::to_vector(mesh.point(v));
    places.push_back(sum / 3);
  }
  return places;
}

// the root mean square of the distances along the gradient from the zero set to places on an ellipsoid
template <typename Function>
double error_on_ellipsoid(const Function& function, const std::vector<Vector>& places, const shapes::Ellipsoid_function& exact)
{
  double sum = 0;
  for (Vector p : places)
  {
    p /= 1 + exact(shapes::Point_3(p.x(), p.y(), p.z())); // along the ray from the centre
    const auto both = function.value_and_gradient(to_point(p));
    sum += std::pow(both.first / pieces::internal::to_vector(both.second).norm(), 2);
  }
  return std::sqrt(sum / double(places.size()));
}

void test_accuracy_on_exact_shape()
{
  const shapes::Ellipsoid_function exact;
  const shapes::Mesh mesh = shapes::ellipsoid(5, exact);
  const Divided divided(mesh, 5000, 2600);
  CHECK(divided.partition.tree().number_of_cells() >= 8);
  CHECK(divided.partition.tree().number_of_pieces() >= 4);
  Cell_functions functions = divided.functions();
  const auto places = places_on(mesh);
  const double of_whole = error_on_ellipsoid(Whole_function(mesh, function_parameters), places, exact);
  const double of_cells = error_on_ellipsoid(functions.near({everywhere}), places, exact);
  std::cout << "ellipsoid: error of one function " << of_whole << ", of cells " << of_cells << std::endl;
  CHECK(of_cells < 1.05 * of_whole);
}

void test_difference_on_scan()
{
  shapes::Mesh mesh;
  CHECK(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/bunny00.off"), mesh));
  const Divided divided(mesh, 40000, 20000);
  CHECK(divided.partition.tree().number_of_cells() == 4);
  Cell_functions functions = divided.functions();
  const auto of_cells = functions.near({everywhere});
  const Whole_function whole(mesh, function_parameters);
  double sum = 0;
  std::vector<double> angles;
  const auto places = places_on(mesh);
  for (const Vector& p : places)
  {
    const auto a = whole.value_and_gradient(to_point(p)), b = of_cells.value_and_gradient(to_point(p));
    sum += std::pow(a.first - b.first, 2);
    angles.push_back(
        pieces::internal::angle_between(pieces::internal::to_vector(a.second), pieces::internal::to_vector(b.second)));
  }
  std::sort(angles.begin(), angles.end());
  const double difference = std::sqrt(sum / double(places.size())) / whole.diagnostics().median_spacing;
  std::cout << "bunny: cells differ by " << difference << " of the spacing, normals by " << angles[angles.size() * 99 / 100]
            << " at 99 of 100 places" << std::endl;
  CHECK(difference < 0.001);
  CHECK(angles[angles.size() * 99 / 100] < 0.005);
}

// On both sides of the two ends of each slab, and in its middle, the function has the same derivatives up to the second.
void test_smoothness()
{
  const shapes::Mesh mesh = shapes::torus(96, 48);
  const Divided divided(mesh, 5000, 1500);
  Cell_functions functions = divided.functions();
  const auto f = functions.near({everywhere});
  double largest_jump = 0, largest_curvature = 0;
  std::size_t number = 0;
  const auto places = places_on(mesh);
  divided.partition.tree().visit_slabs(
      [&](const int axis, const double position, const double half_width)
      {
        for (const Vector& place : places)
          for (const double end : {-half_width, 0., half_width})
          {
            if (std::abs(place[axis] - position) > 2 * half_width)
              continue;
            Vector below = place, above = place;
            below[axis] = position + end - 1e-9 * half_width;
            above[axis] = position + end + 1e-9 * half_width;
            const auto a = f.hessian(to_point(below)), b = f.hessian(to_point(above));
            largest_jump = (std::max)(largest_jump, (a - b).norm());
            largest_curvature = (std::max)(largest_curvature, a.norm());
            ++number;
          }
      });
  std::cout << number << " places at ends of slabs: second derivatives jump by " << largest_jump << " at most, of "
            << largest_curvature << std::endl;
  CHECK(number > 500);
  CHECK(largest_jump < 1e-4 * largest_curvature);
}

// Who loads other cells, in another order, or anew as memory is short, gets the same bits.
void test_same_bits()
{
  const shapes::Mesh mesh = shapes::torus(96, 48);
  const Divided divided(mesh, 5000, 1500);
  Cell_functions functions = divided.functions(), one_at_a_time = divided.functions(1);
  const auto f = functions.near({everywhere});
  bool are_same = true;
  std::size_t number = 0;
  const auto places = places_on(mesh);
  for (std::size_t i = 0; i < places.size(); i += 400)
  {
    const Vector p = places[places.size() - 1 - i];
    const auto local = one_at_a_time.near({pieces::internal::Space_box{p, p}});
    const auto a = f.value_and_gradient(to_point(p)), b = local.value_and_gradient(to_point(p));
    are_same = are_same && a.first == b.first && a.second == b.second;
    ++number;
  }
  CHECK(number > 20);
  CHECK(are_same);
  CHECK(one_at_a_time.number_of_built() > functions.number_of_built());
  // where no cell is loaded the value is not finite, so that the remesher hears of it
  const Vector p = places.front();
  const auto elsewhere = functions.near({pieces::internal::Space_box{-p, -p}});
  CHECK(!std::isfinite(elsewhere(to_point(p))));
}

} // namespace

int main()
{
  test_accuracy_on_exact_shape();
  test_difference_on_scan();
  test_smoothness();
  test_same_bits();
  return check_summary();
}
