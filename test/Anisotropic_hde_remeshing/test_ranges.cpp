// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Ranges of faces and of points are told from meshes, whatever they are: containers, arrays, views that keep no iterator type and
// are not to be run over when const, and with C++20 std::span and std::views.

#include "check.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/anisotropic_hde_remeshing.h>
#include <CGAL/iterator.h>
#include <CGAL/property_map.h>

#include <array>
#include <list>
#include <type_traits>
#include <utility>
#include <vector>

// Clang before 16 cannot compile the views of GCC's library.
#if __cplusplus >= 202002L && !(defined(__clang__) && __clang_major__ < 16 && !defined(_LIBCPP_VERSION))
#  define HAS_RANGES
#  include <ranges>
#  include <span>
#endif

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Face_index Face;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;

namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

// as the views of C++20 may be: it remembers where it is, and its end is of another type
class Every_other_face
{
public:
  explicit Every_other_face(const std::vector<Face>& faces) : m_faces(&faces) {}

  struct End
  {
  };
  struct Iterator
  {
    const std::vector<Face>* faces;
    std::size_t i;
    Face operator*() const { return (*faces)[i]; }
    Iterator& operator++()
    {
      i += 2;
      return *this;
    }
    bool operator!=(End) const { return i < faces->size(); }
  };
  Iterator begin() { return Iterator{m_faces, 0}; }
  End end() { return End(); }

private:
  const std::vector<Face>* m_faces;
};

// which function is meant by a range, a mesh and what else there is
template <typename FaceRange, typename = void>
struct Is_taken_for_faces : std::false_type
{
};
template <typename FaceRange>
struct Is_taken_for_faces<
    FaceRange, std::void_t<decltype(CGAL::anisotropic_hde_remeshing(std::declval<FaceRange&>(), std::declval<Mesh&>(),
                                                                    std::declval<const Function&>())),
                           decltype(CGAL::anisotropic_hde_remeshing(std::declval<const FaceRange&>(), std::declval<Mesh&>())),
                           decltype(CGAL::anisotropic_hde_remeshing(std::declval<const FaceRange&>(), std::declval<Mesh&>(),
                                                                    params::sigma(1))),
                           decltype(CGAL::anisotropic_hde_remeshing(std::declval<FaceRange&>(), std::declval<Mesh&>(),
                                                                    std::declval<const Function&>(), params::sigma(1)))>>
  : std::bool_constant<internal::is_face_range<FaceRange> && internal::accepts_faces<Mesh, FaceRange>()>
{
};

// the numbers of the faces that a loop over the range meets
template <typename FaceRange>
std::vector<std::size_t> faces_of(const FaceRange& range)
{
  std::vector<std::size_t> result;
  internal::for_each_of_range(range, [&result](const Face f) { result.push_back(std::size_t(f)); });
  return result;
}

void test_ranges_of_faces()
{
  CHECK(Is_taken_for_faces<std::vector<Face>>::value);
  CHECK(Is_taken_for_faces<std::list<Face>>::value);
  CHECK(Is_taken_for_faces<std::array<Face, 3>>::value);
  CHECK(Is_taken_for_faces<Face[3]>::value);
  CHECK(Is_taken_for_faces<Mesh::Face_range>::value);
  CHECK(Is_taken_for_faces<CGAL::Iterator_range<std::vector<Face>::iterator>>::value);
  CHECK(Is_taken_for_faces<Every_other_face>::value);

  const std::vector<Face> faces = {Face(3), Face(1), Face(4), Face(1), Face(5)};
  CHECK(faces_of(faces) == std::vector<std::size_t>({3, 1, 4, 1, 5}));
  CHECK(faces_of(Every_other_face(faces)) == std::vector<std::size_t>({3, 4, 5}));
#ifdef HAS_RANGES
  const auto is_odd = [](const Face f) { return std::size_t(f) % 2 == 1; };
  auto view = faces | std::views::filter(is_odd);
  CHECK(Is_taken_for_faces<std::span<Face>>::value);
  CHECK(Is_taken_for_faces<std::span<const Face>>::value);
  CHECK(Is_taken_for_faces<std::span<Face, 3>>::value);
  CHECK(Is_taken_for_faces<decltype(view)>::value);
  CHECK(faces_of(std::span<const Face>(faces).subspan(3)) == std::vector<std::size_t>({1, 5}));
  CHECK(faces_of(view) == std::vector<std::size_t>({3, 1, 1, 5}));
  std::cout << "with ranges of C++20" << std::endl;
#endif
}

void test_meshes()
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  CHECK(internal::Is_face_graph<Mesh>::value && !internal::is_face_range<Mesh>);
  CHECK(internal::Is_face_graph<Polyhedron>::value && !internal::is_face_range<Polyhedron>);
  CHECK(!internal::Is_face_graph<std::vector<Face>>::value && !internal::Is_face_graph<Every_other_face>::value);
  CHECK(!internal::Is_face_graph<int>::value && !internal::is_face_range<int>);
}

// the points of a function are read from a view as from a container
template <typename PointRange>
std::size_t number_of_points(const PointRange& range)
{
  typedef internal::Value_of_range<PointRange> Item;
  CHECK(internal::Is_range<PointRange>::value);
  CHECK((internal::accepts_parameters<internal::Parameters_of_function_of_range, PointRange,
                                      CGAL::parameters::Default_named_parameters>()));
  internal::Interruption never;
  return internal::sample_points(range, CGAL::First_of_pair_property_map<Item>(), CGAL::Second_of_pair_property_map<Item>(),
                                 never)
      .size();
}

void test_ranges_of_points()
{
  typedef std::pair<Point_3, Kernel::Vector_3> Oriented_point;
  std::vector<Oriented_point> points;
  for (int i = 0; i < 20; ++i)
    points.emplace_back(Point_3(i % 5, i / 5, 0), Kernel::Vector_3(0, 0, 1));
  CHECK(number_of_points(points) == 20);
  CHECK(number_of_points(CGAL::make_range(points.begin(), points.begin() + 7)) == 7);
#ifdef HAS_RANGES
  CHECK(number_of_points(std::span<const Oriented_point>(points)) == 20);
  CHECK(number_of_points(points | std::views::filter([](const Oriented_point& p) { return p.first.x() > 1; })) == 12);
#endif
}

int main()
{
  test_ranges_of_faces();
  test_meshes();
  test_ranges_of_points();
  return check_summary();
}
