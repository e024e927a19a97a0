// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_ANY_VISITOR_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_ANY_VISITOR_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>

#include <type_traits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A reference to the caller's visitor without its type, so that what hears of it is compiled once.
class Any_visitor
{
public:
  template <typename Visitor, typename = std::enable_if_t<!std::is_same<std::remove_const_t<Visitor>, Any_visitor>::value>>
  explicit Any_visitor(Visitor& visitor)
    : m_visitor(&visitor),
      m_stage_started([](void* v, const Stage stage) { static_cast<Visitor*>(v)->stage_started(stage); }),
      m_progress([](void* v, const double share) { static_cast<Visitor*>(v)->progress(share); }),
      m_go_further([](void* v) -> bool { return static_cast<Visitor*>(v)->go_further(); })
  {
  }

  void stage_started(const Stage stage) const { m_stage_started(m_visitor, stage); }
  void progress(const double share) const { m_progress(m_visitor, share); }
  bool go_further() const { return m_go_further(m_visitor); }

private:
  void* m_visitor;
  void (*m_stage_started)(void*, Stage);
  void (*m_progress)(void*, double);
  bool (*m_go_further)(void*);
};

// The visitor in a part of the work: the shares of the part become shares of the whole.
class Visitor_of_part : public Remeshing_visitor
{
public:
  Visitor_of_part(const Any_visitor visitor, const double begin, const double end)
    : m_visitor(visitor), m_begin(begin), m_end(end)
  {
  }
  Visitor_of_part(const Visitor_of_part&) = delete;
  Visitor_of_part& operator=(const Visitor_of_part&) = delete;

  void stage_started(const Stage stage) { m_visitor.stage_started(stage); }
  void progress(const double share) { m_visitor.progress(m_begin + (m_end - m_begin) * share); }
  bool go_further() { return m_visitor.go_further(); }

private:
  const Any_visitor m_visitor;
  const double m_begin, m_end;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_ANY_VISITOR_H
