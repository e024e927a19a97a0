// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_BUILD_REGION_FUNCTIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_BUILD_REGION_FUNCTIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/fit_region_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/split_regions.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The visitor of a region. Only the thread of the caller may ask the caller's visitor. In other threads, this one only tells
// whether the caller has asked to stop. It counts how much of the region is done.
class Visitor_of_region : public Remeshing_visitor
{
public:
  // a region of so many vertices, which are the parts of all regions; `owner` is the thread of the caller
  Visitor_of_region(Interruption& interruption, const std::thread::id owner, const std::size_t number_of_vertices)
    : m_interruption(&interruption), m_owner(owner), m_number_of_vertices(number_of_vertices)
  {
  }
  Visitor_of_region(const Visitor_of_region&) = delete;
  Visitor_of_region& operator=(const Visitor_of_region&) = delete;

  void progress(const double share)
  {
    const std::size_t done = std::size_t(share * double(m_number_of_vertices));
    m_interruption->end_parts(done - m_number_done);
    m_number_done = done;
  }

  bool go_further()
  {
    return !(std::this_thread::get_id() == m_owner ? m_interruption->ask() : m_interruption->is_requested());
  }

private:
  Interruption* m_interruption;
  std::thread::id m_owner;
  std::size_t m_number_of_vertices, m_number_done = 0;
};

// the share of a region in the number of patches that the caller asks for, if he does
template <typename NamedParameters>
auto with_share_of_patches(const NamedParameters& np, const double share)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::number_of_patches_t>::value)
    return np;
  else
  {
    const double n = double(parameters::get_parameter(np, internal_np::number_of_patches));
    return parameters::begin_with(np).number_of_patches(std::size_t((std::max)(1., std::round(share * n))));
  }
}

// The same as parallel_for, for a body that may throw and that has parallel loops of its own. An exception that left the loop
// would cancel the loops inside, which do not notice. So the first one by index is thrown in the end.
template <typename ConcurrencyTag, typename Body>
void parallel_for_with_exceptions(const std::size_t n, const Body& body, Interruption& interruption)
{
  std::vector<std::exception_ptr> exceptions(n);
  parallel_for<ConcurrencyTag>(
      n,
      [&](const std::size_t i)
      {
        try
        {
          body(i);
        }
        catch (...)
        {
          exceptions[i] = std::current_exception();
        }
      },
      1, interruption);
  interruption.check();
  for (const std::exception_ptr& exception : exceptions)
    if (exception)
      std::rethrow_exception(exception);
}

// Builds the functions of all regions. Large regions are built one after another, each by all threads. The thread of the caller
// asks the visitor, so it must not be busy with the region of another thread. Small regions are built at the same time.
template <typename Field, typename ConcurrencyTag, typename NamedParameters>
std::vector<Region_function<Field>> build_region_functions(const std::vector<Region_mesh>& regions, const NamedParameters& np,
                                                           Interruption& interruption)
{
  // the largest distance of points to the plane of their region, as a share of the size of the mesh
  static constexpr double planarity = 5e-6;
  // a region of so many vertices is worth all threads
  static constexpr std::size_t large_number_of_vertices = 2000;
  Bbox_3 box;
  std::size_t number_of_vertices = 0;
  for (const Region_mesh& region : regions)
  {
    box += Polygon_mesh_processing::bbox(region);
    number_of_vertices += region.number_of_vertices();
  }
  const double size = diagonal_of(box);
  const std::thread::id owner = std::this_thread::get_id();
  interruption.begin_parts(number_of_vertices, 1);
  std::vector<Region_function<Field>> result(regions.size());
  const auto build_one = [&](const std::size_t i)
  {
    Visitor_of_region visitor(interruption, owner, regions[i].number_of_vertices());
    const double share = double(regions[i].number_of_vertices()) / double(number_of_vertices);
    result[i] = fit_region_function<Field>(regions[i], planarity * size,
                                           with_share_of_patches(np, share).visitor(std::ref(visitor)), interruption);
    visitor.progress(1);
  };
  std::vector<std::size_t> small;
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (regions[i].number_of_vertices() < large_number_of_vertices)
      small.push_back(i);
    else
      build_one(i);
  parallel_for_with_exceptions<ConcurrencyTag>(
      small.size(), [&](const std::size_t k) { build_one(small[k]); }, interruption);
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_BUILD_REGION_FUNCTIONS_H
