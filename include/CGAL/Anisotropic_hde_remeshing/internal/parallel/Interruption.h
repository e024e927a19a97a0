// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_INTERRUPTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_INTERRUPTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The caller's wish to stop. Only the thread that made this object asks the visitor. All threads may read the answer.
class Interruption
{
  // Long loops ask only once in so many calls, and only after this time.
  static constexpr unsigned int calls_per_look_at_the_clock = 16;
  static constexpr std::chrono::milliseconds time_between_questions{5};

public:
  // one that is never requested
  Interruption() = default;

  explicit Interruption(std::function<bool()> go_further) : m_go_further(std::move(go_further)) {}
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  // whether the caller has wished to stop already
  bool is_requested() const { return m_is_requested.load(std::memory_order_relaxed); }

  // asks the visitor; only for the thread of the caller
  bool ask()
  {
    m_last_question = std::chrono::steady_clock::now();
    if (!is_requested() && m_go_further && !m_go_further())
      m_is_requested = true;
    return is_requested();
  }

  // for the inside of loops, and for any thread: asks from time to time
  bool poll()
  {
    if (m_go_further && std::this_thread::get_id() == m_owner && ++m_number_of_calls % calls_per_look_at_the_clock == 0 &&
        std::chrono::steady_clock::now() - m_last_question > time_between_questions)
      ask();
    return is_requested();
  }

  // the same, by an exception, for code that has no other way out
  void check()
  {
    if (poll())
      throw Interrupted();
  }

private:
  const std::function<bool()> m_go_further;
  const std::thread::id m_owner = std::this_thread::get_id();
  std::chrono::steady_clock::time_point m_last_question = std::chrono::steady_clock::now(); // the owner's
  unsigned int m_number_of_calls = 0;                                                       // the owner's
  std::atomic<bool> m_is_requested{false};
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_INTERRUPTION_H
