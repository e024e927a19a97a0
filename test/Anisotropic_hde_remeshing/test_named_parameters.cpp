// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The package's named parameters beside CGAL's, after headers of CGAL's that include its list first. CMake also compiles this
// file with a list of CGAL's that has names of the package, as a later version may have them.

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/Anisotropic_hde_remeshing/parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include "check.h"

#include <functional>
#include <type_traits>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3> Point_map;

namespace internal_np = CGAL::Anisotropic_hde_remeshing::internal_np;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

template <typename NamedParameters, typename Tag>
double value(const NamedParameters& np, Tag tag)
{
  return params::choose_parameter(params::get_parameter(np, tag), -1.0);
}

template <typename NamedParameters>
void check_values(const NamedParameters& np)
{
  CHECK(value(np, internal_np::sigma) == 2.0);
  CHECK(value(np, internal_np::target_edge_length) == 0.25);
  CHECK(value(np, internal_np::collapse_ratio) == 0.75);
  CHECK(value(np, internal_np::offset_distance) == -1.0); // not given
  CHECK(params::choose_parameter(params::get_parameter(np, CGAL::internal_np::number_of_iterations), 1u) == 7u);
}

void check_any_order()
{
  check_values(params::sigma(2.0).number_of_iterations(7u).target_edge_length(0.25).collapse_ratio(0.75));
  check_values(params::number_of_iterations(7u).collapse_ratio(0.75).target_edge_length(0.25).sigma(2.0));
  check_values(params::default_values().sigma(2.0).target_edge_length(0.25).collapse_ratio(0.75).number_of_iterations(7u));
  // begun by CGAL; ended with a name of CGAL's that the package does not know
  check_values(params::begin_with(CGAL::parameters::verbose(true).number_of_iterations(7u))
                   .sigma(2.0)
                   .target_edge_length(0.25)
                   .collapse_ratio(0.75)
                   .random_seed(3));
  // a copy is continued, and what is given last counts, as in CGAL
  const auto begun = params::sigma(1.0).number_of_iterations(7u).target_edge_length(0.25);
  check_values(begun.collapse_ratio(0.75).sigma(2.0));
  CHECK(value(begun, internal_np::sigma) == 1.0);
}

// whether all names of the package can follow
template <typename NamedParameters>
constexpr bool can_be_continued(const NamedParameters&)
{
  return false;
}
template <typename T, typename Tag, typename Base>
constexpr bool can_be_continued(const CGAL::Anisotropic_hde_remeshing::internal::Named_parameters<T, Tag, Base>&)
{
  return true;
}

// The value of a name is its line in the table. It must arrive under the tag of the name and can be continued, whether the name
// begins or not.
void check_every_name()
{
#define CGAL_AHR_NAMED_PARAMETER(NAME, CONDITION, WORDS) .NAME(double(__LINE__))
#define CGAL_AHR_NAMED_PARAMETER_OF_CGAL(NAME, TAG, CONDITION, WORDS) .NAME(double(__LINE__))
  const auto all = params::default_values()
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/named_parameter_table.h>
      ;
#define CGAL_AHR_NAMED_PARAMETER(NAME, CONDITION, WORDS) CGAL_AHR_NAMED_PARAMETER_OF_CGAL(NAME, NAME##_t, CONDITION, WORDS)
#define CGAL_AHR_NAMED_PARAMETER_OF_CGAL(NAME, TAG, CONDITION, WORDS)                                                          \
  CHECK(value(all, internal_np::TAG()) == __LINE__);                                                                           \
  CHECK(value(params::NAME(5.), internal_np::TAG()) == 5);                                                                     \
  CHECK(can_be_continued(params::NAME(5.)));                                                                                   \
  CHECK(can_be_continued(all.NAME(5.)));
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/named_parameter_table.h>
}

struct Not_copyable
{
  Not_copyable() = default;
  Not_copyable(const Not_copyable&) = delete;
  int number = 0;
};

// As in CGAL, a value is copied, std::ref passes a reference on, and what cannot be copied is referred to.
void check_references()
{
  int number = 1;
  Not_copyable object;
  const auto np = params::visitor(std::ref(number)).sigma(number).embedding(object).radial_function(std::ref(object));
  params::get_parameter_reference(np, internal_np::visitor) = 3;
  CHECK(number == 3);
  CHECK(params::get_parameter(np, internal_np::sigma) == 1);
  CHECK(&params::get_parameter_reference(np, internal_np::embedding) == &object);
  params::get_parameter_reference(np, internal_np::radial_function).number = 4;
  CHECK(object.number == 4);
}

// The package takes its own parameters and those of CGAL alone, and CGAL's helper finds its map among the package's names.
void check_functions()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 0, 1),
                         mesh);
  Point_map flat = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:flat").first;
  for (const Mesh::Vertex_index v : mesh.vertices())
    flat[v] = Kernel::Point_3(mesh.point(v).x(), mesh.point(v).y(), 0);
  const auto np = params::sigma(2.0).vertex_point_map(flat).number_of_patches(3);
  typedef CGAL::GetVertexPointMap<Mesh, std::decay_t<decltype(np)>>::const_type Found_map;
  CHECK(std::is_same<Found_map, Point_map>::value);
  const auto number_of_flat_faces = [&mesh](const auto& np)
  { return CGAL::Anisotropic_hde_remeshing::measure_shape(mesh, np).number_of_degenerate_faces; };
  CHECK(number_of_flat_faces(np) == 2);
  CHECK(number_of_flat_faces(CGAL::parameters::vertex_point_map(flat)) == 2);
  CHECK(number_of_flat_faces(params::default_values()) == 0);
  CHECK(number_of_flat_faces(CGAL::parameters::default_values()) == 0);
}

// A name of a later CGAL is another parameter than the package's of the same name.
void check_later_cgal()
{
#ifdef CGAL_AHR_TEST_LATER_CGAL
  const auto np = params::begin_with(CGAL::parameters::sigma(1.0)).sigma(2.0);
  CHECK(value(np, CGAL::internal_np::sigma) == 1.0);
  CHECK(value(np, internal_np::sigma) == 2.0);
  CHECK(value(CGAL::parameters::sigma(1.0), internal_np::sigma) == -1.0);
#endif
}

void check_trait()
{
  using CGAL::Anisotropic_hde_remeshing::internal::is_named_parameters;
  CHECK(is_named_parameters<decltype(params::sigma(1).visitor(2))>);
  CHECK(is_named_parameters<const decltype(params::visitor(1).sigma(2))>);
  CHECK(is_named_parameters<CGAL::parameters::Default_named_parameters>);
  CHECK(!is_named_parameters<int> && !is_named_parameters<Mesh> && !is_named_parameters<int(int)>);
}

int main()
{
  check_any_order();
  check_every_name();
  check_references();
  check_functions();
  check_later_cgal();
  check_trait();
  return check_summary();
}
