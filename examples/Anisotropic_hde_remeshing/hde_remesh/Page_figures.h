// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_PAGE_FIGURES_H
#define HDE_REMESH_PAGE_FIGURES_H

#include "Element_figures.h"
#include "Mesh.h"
#include "Report.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace hde_remesh {

// a mesh and the figures of its elements
struct Measured_elements
{
  const Mesh& mesh;
  Element_figures figures;
};

// from `low` to `high`; the first and the last bin and colour stand for less and more
struct Scale
{
  double low, high;
  bool is_logarithmic;
};

// What the page tells of each face of both meshes, lengths in D. The worst face has the largest figure, the least, or that of the
// largest absolute value.
struct Page_figure
{
  std::string key, title, unit, worst;
  std::vector<double> before, after;
  Scale scale_before, scale_after; // that hardly cut an outlier of that mesh

  Scale common_scale() const;
  bool is_signed() const { return worst == "absolute"; }
};

std::vector<Page_figure> page_figures(const Measured_elements& before, const Measured_elements& after, double diagonal);

nlohmann::ordered_json to_json(const Page_figure& figure);

// those of the figures, and of the lengths of the edges where the report has them
nlohmann::ordered_json histograms(const std::vector<Page_figure>& figures, const Report& report, const Element_figures& before,
                                  const Element_figures& after);

} // namespace hde_remesh

#endif // HDE_REMESH_PAGE_FIGURES_H
