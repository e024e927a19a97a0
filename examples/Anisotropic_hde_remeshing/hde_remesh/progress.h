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

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hde_remesh {

// One line on a terminal: what is being done, how far it is, and how long it takes yet. Nothing is shown if the standard error is no
// terminal, or if a stage is over within half a second.
class Progress
{
public:
  explicit Progress(bool is_wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // a stage begins, of which nothing is done
  void stage(const std::string& name);

  // a stage begins that others tell the share of, whenever they are asked
  void stage(const std::string& name, std::function<double()> share);

  // the stage goes on under another name
  void rename(const std::string& name);

  // The share of the stage that is done, from 0 to 1, and the share that will be done at the next call. The bar goes on to that at the
  // pace until now. If it is not known, the next step is taken to be as large as the last one.
  void share(double done, double next = 0);

  void clear();

private:
  class Display;
  std::unique_ptr<Display> m_display; // none if nothing is to be shown
};

// A stage of a few steps, of which each takes about a known part of the time.
class Steps
{
public:
  Steps(Progress& progress, const std::string& name, std::vector<double> costs)
    : m_progress(progress), m_costs(std::move(costs))
  {
    for (const double cost : m_costs)
      m_all += cost;
    m_progress.stage(name);
    tell();
  }

  // the step is done
  void next()
  {
    if (m_number_done < m_costs.size())
      m_done += m_costs[m_number_done++];
    tell();
  }

private:
  void tell()
  {
    const double of_next = m_number_done < m_costs.size() ? m_costs[m_number_done] : 0;
    m_progress.share(m_done / m_all, (m_done + of_next) / m_all);
  }

  Progress& m_progress;
  std::vector<double> m_costs;
  double m_all = 0, m_done = 0;
  std::size_t m_number_done = 0;
};

// shows the progress of the remeshing, or of the making of a function, and ends it at Ctrl-C
struct Progress_visitor : CGAL::Anisotropic_hde_remeshing::Remeshing_visitor
{
  explicit Progress_visitor(Progress& bar) : bar(&bar) {}

  void stage_started(const CGAL::Anisotropic_hde_remeshing::Stage stage)
  {
    typedef CGAL::Anisotropic_hde_remeshing::Stage Stage;
    bar->rename(stage == Stage::IMPLICIT_FUNCTION ? "building the function"
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
