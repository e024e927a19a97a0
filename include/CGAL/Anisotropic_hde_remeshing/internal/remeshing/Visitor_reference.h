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

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The caller's visitor without its type. This class tells the visitor what happens. Its `Interruption` asks the visitor whether
// to go on.
class Visitor_reference
{
public:
  template <typename Visitor>
  Visitor_reference(Visitor& visitor, Interruption& interruption)
    : m_visitor(&visitor),
      m_interruption(&interruption),
      m_stage_started(&stage_started_of<Visitor>),
      m_progress(&progress_of<Visitor>)
  {
  }

  void stage_started(const Stage stage) const { m_stage_started(m_visitor, stage); }
  void progress(const double share) const { m_progress(m_visitor, share); }
  Interruption& interruption() const { return *m_interruption; }

private:
  template <typename Visitor>
  static void stage_started_of(void* visitor, const Stage stage)
  {
    static_cast<Visitor*>(visitor)->stage_started(stage);
  }

  template <typename Visitor>
  static void progress_of(void* visitor, const double share)
  {
    static_cast<Visitor*>(visitor)->progress(share);
  }

  void* m_visitor;
  Interruption* m_interruption;
  void (*m_stage_started)(void*, Stage);
  void (*m_progress)(void*, double);
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_VISITOR_REFERENCE_H
