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

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <thread>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The caller's wish to stop, and, if someone listens, how far the work is. Only the thread that made this object asks and tells the
// visitor. All threads may read the answer, and count the parts that they have done.
class Interruption
{
  // Long loops ask only once in so many calls, and only after this time.
  static constexpr unsigned int calls_per_look_at_the_clock = 16;
  static constexpr std::chrono::milliseconds time_between_questions{5};

public:
  // one that is never requested
  Interruption() = default;

  explicit Interruption(std::function<bool()> go_further, std::function<void(double)> progress = {})
    : m_go_further(std::move(go_further)), m_progress(std::move(progress))
  {
  }
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  // whether the caller has wished to stop already
  bool is_requested() const { return m_is_requested.load(std::memory_order_relaxed); }

  // asks the visitor, and tells it how far the parts are; only for the thread of the caller
  bool ask()
  {
    m_last_question = std::chrono::steady_clock::now();
    if (!is_requested() && m_go_further && !m_go_further())
      m_is_requested = true;
    if (!is_requested() && m_number_of_parts > 0)
      tell(m_begin + (m_end - m_begin) * (std::min)(1., double(m_number_of_ended_parts) / double(m_number_of_parts)),
           least_advance);
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

  // This share is done. Asks whether to go on, too, and throws Interrupted if not. Only for the thread of the caller.
  void report(const double share)
  {
    m_number_of_parts = 0;
    m_begin = share;
    if (!is_requested())
      tell(share, 0);
    if (ask())
      throw Interrupted();
  }

  // What comes now has so many parts, and leads to this share; only for the thread of the caller.
  void begin_parts(const std::size_t number, const double end)
  {
    m_end = end;
    m_number_of_ended_parts = 0;
    m_number_of_parts = number;
  }

  // for any thread
  void end_parts(const std::size_t number) { m_number_of_ended_parts.fetch_add(number, std::memory_order_relaxed); }

private:
  static constexpr double least_advance = 0.01; // of the share, where time and threads decide when it is told

  void tell(const double share, const double least)
  {
    if (!m_progress || !(share >= m_told + least))
      return;
    m_told = share;
    m_progress(share);
  }

  const std::function<bool()> m_go_further;
  const std::function<void(double)> m_progress;
  const std::thread::id m_owner = std::this_thread::get_id();
  std::chrono::steady_clock::time_point m_last_question = std::chrono::steady_clock::now(); // the owner's
  unsigned int m_number_of_calls = 0;                                                       // the owner's
  double m_told = 0, m_begin = 0, m_end = 0;                                                // the owner's
  std::size_t m_number_of_parts = 0;                                                        // the owner's
  std::atomic<std::size_t> m_number_of_ended_parts{0};
  std::atomic<bool> m_is_requested{false};
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_INTERRUPTION_H
