// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <thread>

#include <sys/ioctl.h>
#include <unistd.h>

namespace hde_remesh {

namespace {

// "40 s", "3 min" or "2 h"
std::string duration(const double seconds)
{
  if (seconds < 99.5)
    return std::to_string(static_cast<int>(std::ceil(seconds))) + " s";
  if (seconds < 99.5 * 60)
    return std::to_string(static_cast<int>(std::ceil(seconds / 60))) + " min";
  return std::to_string(static_cast<long>(std::ceil(seconds / 3600))) + " h";
}

std::size_t columns_of_terminal()
{
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

} // namespace

// A thread draws the line: the stages that tell little, as those of CGAL, are seen to go on, too.
class Progress::Display
{
  typedef std::chrono::steady_clock Clock;

public:
  Display() : m_thread([this] { run(); }) {}

  ~Display()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_done = true;
    }
    m_wakened.notify_one();
    m_thread.join();
    clear();
  }

  void stage(const std::string& name, std::function<double()> share)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_name = name;
    m_tell = std::move(share);
    m_share = m_next = 0;
    m_begin = m_time_of_share = Clock::now();
  }

  void rename(const std::string& name)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_name = name;
  }

  void share(const double done, const double next)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_next = (std::min)(1., next > done ? next : 2 * done - m_share);
    m_share = done;
    m_time_of_share = Clock::now();
  }

  void clear()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_name.clear();
    if (m_is_drawn)
      std::cerr << "\r\033[K" << std::flush;
    m_is_drawn = false;
  }

private:
  void run()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    while (!m_wakened.wait_for(lock, std::chrono::milliseconds(100), [this] { return m_is_done; }))
      draw();
  }

  static double seconds(const Clock::duration time) { return std::chrono::duration<double>(time).count(); }

  void draw()
  {
    static constexpr double patience = 0.5; // seconds without a line
    const Clock::time_point now = Clock::now();
    const double elapsed = seconds(now - m_begin);
    if (m_name.empty() || is_stopping() || elapsed < patience)
      return;
    if (m_tell)
    {
      m_share = m_next = m_tell();
      m_time_of_share = now;
    }
    const std::size_t columns = columns_of_terminal();
    std::cerr << "\r\033[K" << line(elapsed, now).substr(0, columns - 1) << std::flush;
    m_is_drawn = true;
  }

  // The share by now, at the pace until the last one was told.
  double share_by(const Clock::time_point now) const
  {
    const double told_after = seconds(m_time_of_share - m_begin);
    const double pace = told_after > 0 ? m_share / told_after : 0;
    return std::clamp(m_share + pace * seconds(now - m_time_of_share), m_share, (std::max)(m_share, m_next));
  }

  std::string line(const double elapsed, const Clock::time_point now) const
  {
    static constexpr int width = 30;
    static constexpr double least_share = 0.01, largest_share = 0.99; // of which an estimate can be made; of what is not done
    const double share = (std::min)(share_by(now), largest_share);
    if (share < least_share)
      return m_name + " ... " + duration(elapsed) + " so far";
    const int filled = static_cast<int>(share * width);
    return "[" + std::string(filled, '#') + std::string(width - filled, '.') + "] " +
           std::to_string(static_cast<int>(share * 100)) + " % " + m_name + ", about " +
           duration(elapsed * (1 - share) / share) + " left";
  }

  std::mutex m_mutex;
  std::condition_variable m_wakened;
  bool m_is_done = false, m_is_drawn = false;
  std::string m_name; // none between stages
  std::function<double()> m_tell;
  double m_share = 0, m_next = 0;
  Clock::time_point m_begin, m_time_of_share;
  std::thread m_thread; // the last one, as it needs all the others
};

Progress::Progress(const bool is_wanted)
{
  if (is_wanted && isatty(STDERR_FILENO) != 0)
    m_display = std::make_unique<Display>();
}

Progress::~Progress() = default;

void Progress::stage(const std::string& name) { stage(name, nullptr); }

void Progress::stage(const std::string& name, std::function<double()> share)
{
  if (m_display)
    m_display->stage(name, std::move(share));
}

void Progress::rename(const std::string& name)
{
  if (m_display)
    m_display->rename(name);
}

void Progress::share(const double done, const double next)
{
  if (m_display)
    m_display->share(done, next);
}

void Progress::clear()
{
  if (m_display)
    m_display->clear();
}

} // namespace hde_remesh
