// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Whether edges have the lengths that are wanted at each place.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_LENGTH_CHECKS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_LENGTH_CHECKS_H

#include "check.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>

#include <cmath>
#include <cstddef>
#include <iostream>

// The lengths over the sizes wanted in their middle have this mean, and few are far from it.
template <typename Size>
void check_lengths(const shapes::Mesh& mesh, const Size& size, const double expected)
{
  double sum = 0;
  std::size_t number = 0, number_far = 0;
  for (const auto e : mesh.edges())
  {
    const shapes::Point_3 &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
    const double relative = std::sqrt(CGAL::squared_distance(p, q)) / size(CGAL::midpoint(p, q));
    sum += relative;
    ++number;
    number_far += relative < 0.6 * expected || relative > 1.5 * expected ? 1 : 0;
  }
  std::cout << mesh.number_of_faces() << " faces, lengths over sizes " << sum / double(number) << ", " << number_far << " of "
            << number << " far from it" << std::endl;
  CHECK_CLOSE(sum / double(number), expected, 0.06 * expected);
  CHECK(number_far < number / 50);
  CHECK(CGAL::Anisotropic_hde_remeshing::measure_shape(mesh).aspect_ratio_max < 3);
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_LENGTH_CHECKS_H
