// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_REMESHING_VISITOR_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_REMESHING_VISITOR_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <stdexcept>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/// \ingroup PkgAnisotropicHdeRemeshingSchemes
///
/// the stages of `CGAL::anisotropic_hde_remeshing()`, in the order in which they run
enum class Stage
{
  IMPLICIT_FUNCTION, ///< the radial basis functions are built; only if no function is given
  PROJECTION,        ///< the vertices of the input are projected onto the zero set
  REMESHING,         ///< the local operations
  OUTPUT             ///< the result is written into the mesh of the caller
};

/// \ingroup PkgAnisotropicHdeRemeshingSchemes
///
/// thrown by the constructor of `CGAL::Rbf_implicit_function` if the visitor stops it. No function is left half built.
/// `CGAL::anisotropic_hde_remeshing()` does not throw it: it returns.
struct Interrupted : std::runtime_error
{
  Interrupted() : std::runtime_error("stopped by the visitor") {}
};

/// \ingroup PkgAnisotropicHdeRemeshingSchemes
///
/// the default visitor of `CGAL::anisotropic_hde_remeshing()`, a model of `RemeshingVisitor`. It does nothing and never stops
/// the remeshing. Derive from it and hide the members that are needed.
/// All calls come from the calling thread. A visitor that throws leaves the mesh as it was given.
struct Remeshing_visitor
{
  /// called once when `stage` begins
  void stage_started(Stage /* stage */) {}

  /// called with the share done, from 0 to 1. The share never decreases within a call. In `Stage::IMPLICIT_FUNCTION` it goes up to
  /// 0.3, in steps of about a hundredth of the stage; how often it is called there depends on the time that the patches take. A
  /// constructor of a function that is given this visitor tells the share of the construction, also from 0 to 1.
  void progress(double /* share */) {}

  /// asked between any two steps and, in the long ones, every few milliseconds. `false` ends the remeshing early. The mesh
  /// reached by then is written to the mesh of the caller. It is valid and has its vertices on the zero set. Before
  /// `Stage::REMESHING` the mesh of the caller stays as it was.
  bool go_further() { return true; }
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_REMESHING_VISITOR_H
