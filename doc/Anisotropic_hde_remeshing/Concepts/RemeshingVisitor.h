// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/*!
\ingroup PkgAnisotropicHdeRemeshingConcepts
\cgalConcept

The concept `RemeshingVisitor` describes an object that `CGAL::anisotropic_hde_remeshing()` and the constructor of
`CGAL::Rbf_implicit_function` call while they run. They tell it how far they are and ask it whether to go on. All calls come
from the calling thread. If a member throws, the mesh of the caller stays as it was, and the exception reaches the caller.

As all named parameters, a visitor is copied, and copies must share what they remember. `visitor(std::ref(v))` passes the visitor
itself, which need not be copyable.

`CGAL::Anisotropic_hde_remeshing::Remeshing_visitor` does nothing. Derive from it and hide the members that are needed.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Anisotropic_hde_remeshing::Remeshing_visitor}
\cgalHasModelsEnd
*/
class RemeshingVisitor
{
public:
  /// called once when `stage` begins
  void stage_started(CGAL::Anisotropic_hde_remeshing::Stage stage);

  /// called with the share of the call that is done, from 0 to 1. The share never decreases within a call. How often it is called may
  /// depend on the time that parts take.
  void progress(double share);

  /// asked between any two steps and every few milliseconds within them. If it returns `false`, the call returns soon, with a
  /// valid mesh on the surface. Before `Stage::REMESHING` this is the mesh that was given.
  bool go_further();
};
