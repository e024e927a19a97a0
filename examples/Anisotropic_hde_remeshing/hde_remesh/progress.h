// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_PROGRESS_H
#define HDE_REMESH_PROGRESS_H

#include "signals.h"

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>

#include <chrono>
#include <iostream>
#include <string>

#include <unistd.h>

namespace hde_remesh {

// One line on a terminal that says what is being done and how far it is. Nothing if the standard error is no terminal.
class Progress
{
  typedef std::chrono::steady_clock Clock;

public:
  explicit Progress(const bool is_wanted) : m_is_shown(is_wanted && isatty(STDERR_FILENO) != 0) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void stage(const std::string& name)
  {
    m_stage = name;
    show(name + " ...");
  }

  void share(const double done)
  {
    const Clock::time_point now = Clock::now();
    if (!m_is_shown || now - m_last < std::chrono::milliseconds(100))
      return;
    m_last = now;
    const int width = 40, filled = static_cast<int>(done * width);
    show("[" + std::string(filled, '#') + std::string(width - filled, '.') + "] " +
         std::to_string(static_cast<int>(done * 100)) + "% " + m_stage);
  }

  void clear() { show(""); }

private:
  void show(const std::string& text)
  {
    if (m_is_shown)
      std::cerr << "\r\033[K" << text << std::flush;
  }

  bool m_is_shown;
  std::string m_stage;
  Clock::time_point m_last;
};

// shows the progress of the remeshing and ends it at Ctrl-C
struct Progress_visitor : CGAL::Anisotropic_hde_remeshing::Remeshing_visitor
{
  explicit Progress_visitor(Progress& bar) : bar(&bar) {}

  void stage_started(const CGAL::Anisotropic_hde_remeshing::Stage stage)
  {
    typedef CGAL::Anisotropic_hde_remeshing::Stage Stage;
    bar->stage(stage == Stage::IMPLICIT_FUNCTION ? "smooth function"
               : stage == Stage::PROJECTION      ? "projecting"
               : stage == Stage::REMESHING       ? "remeshing"
                                                 : "copying");
  }

  void progress(const double share) { bar->share(share); }

  bool go_further() { return !is_cancelled(); }

  Progress* bar;
};

} // namespace hde_remesh

#endif // HDE_REMESH_PROGRESS_H
