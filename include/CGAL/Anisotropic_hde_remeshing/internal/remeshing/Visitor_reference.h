// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_VISITOR_REFERENCE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_VISITOR_REFERENCE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/Any_visitor.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The caller's visitor, which is told what happens, and the interruption that asks it whether to go on.
class Visitor_reference
{
public:
  Visitor_reference(const Any_visitor visitor, Interruption& interruption) : m_visitor(visitor), m_interruption(&interruption)
  {
  }

  void stage_started(const Stage stage) const { m_visitor.stage_started(stage); }
  void progress(const double share) const { m_visitor.progress(share); }
  Interruption& interruption() const { return *m_interruption; }

private:
  Any_visitor m_visitor;
  Interruption* m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_VISITOR_REFERENCE_H
