// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_BUILD_REGION_FUNCTIONS_IMPL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_BUILD_REGION_FUNCTIONS_IMPL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Rbf_field.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/build_region_functions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/fit_region_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/noise_of_regions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/split_regions.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// How much of a region is done, and whether to go on. Only the thread of the caller may ask the caller's visitor. In other threads,
// this one only tells whether the caller has asked to stop.
class Progress_of_region
{
public:
  // a region of so many vertices, which are the parts of all regions; `owner` is the thread of the caller
  Progress_of_region(Interruption& interruption, const std::thread::id owner, const std::size_t number_of_vertices)
    : m_interruption(&interruption), m_owner(owner), m_number_of_vertices(number_of_vertices)
  {
  }
  Progress_of_region(const Progress_of_region&) = delete;
  Progress_of_region& operator=(const Progress_of_region&) = delete;

  void tell(const double share)
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

// the parameters of a region, which has its share in the number of patches that the caller asks for, if he does
template <typename RadialFunction>
Region_parameters<RadialFunction> with_share_of_patches(Region_parameters<RadialFunction> parameters, const double share)
{
  std::size_t& number = parameters.interpolation.number_of_patches; // 0: not asked for
  if (number > 0)
    number = std::size_t((std::max)(1., std::round(share * double(number))));
  return parameters;
}

// the parameters with one noise for all regions, as most of them may be too small to tell
template <typename ConcurrencyTag, typename RadialFunction>
Region_parameters<RadialFunction> with_known_noise(const std::vector<Region_mesh>& regions,
                                                   Region_parameters<RadialFunction> parameters, Interruption& interruption)
{
  Interpolation_parameters& interpolation = parameters.interpolation;
  if (interpolation.estimates_noise)
    interpolation.noise = noise_of_regions<ConcurrencyTag>(regions, interruption);
  interpolation.estimates_noise = false;
  if (interpolation.noise > 0)
    interpolation.mistrust_facets();
  return parameters;
}

// Builds the functions of all regions. Large regions are built one after another, each by all threads. The thread of the caller
// asks the visitor, so it must not be busy with the region of another thread. Small regions are built at the same time. It has
// none of the caller's types but the radial function.
template <typename ConcurrencyTag, typename RadialFunction>
std::vector<Region_function<Rbf_field<RadialFunction, ConcurrencyTag>>>
build_region_functions(const std::vector<Region_mesh>& regions, const Region_parameters<RadialFunction>& given_parameters,
                       Interruption& interruption)
{
  // the largest distance of points to the plane of their region, as a share of the size of the mesh
  static constexpr double planarity = 5e-6;
  // a region of so many vertices is worth all threads
  static constexpr std::size_t large_number_of_vertices = 2000;
  const Region_parameters<RadialFunction> parameters =
      with_known_noise<ConcurrencyTag>(regions, given_parameters, interruption);
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
  std::vector<Region_function<Rbf_field<RadialFunction, ConcurrencyTag>>> result(regions.size());
  const auto build_one = [&](const std::size_t i)
  {
    Progress_of_region progress(interruption, owner, regions[i].number_of_vertices());
    Interruption of_region([&] { return progress.go_further(); }, [&](const double share) { progress.tell(share); });
    const double share = double(regions[i].number_of_vertices()) / double(number_of_vertices);
    result[i] =
        fit_region_function<ConcurrencyTag>(regions[i], planarity * size, with_share_of_patches(parameters, share), of_region);
    progress.tell(1);
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

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_BUILD_REGION_FUNCTIONS_IMPL_H
