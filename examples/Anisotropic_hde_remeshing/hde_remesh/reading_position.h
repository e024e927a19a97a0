// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_READING_POSITION_H
#define HDE_REMESH_READING_POSITION_H

#include <atomic>
#include <cstddef>

namespace hde_remesh {

// How far a reader is in the text of a file: the readers tell it, and the line of the progress asks for it in its own time.
class Reading_position
{
public:
  void begin(const std::size_t number_of_bytes)
  {
    m_number_read = 0;
    m_number_of_bytes = number_of_bytes;
  }

  void tell(const std::size_t number_read) { m_number_read.store(number_read, std::memory_order_relaxed); }

  // from 0 to 1
  double share() const
  {
    const std::size_t all = m_number_of_bytes;
    return all == 0 ? 0 : static_cast<double>(m_number_read) / static_cast<double>(all);
  }

private:
  std::atomic<std::size_t> m_number_read{0}, m_number_of_bytes{0};
};

inline Reading_position& reading_position()
{
  static Reading_position position;
  return position;
}

} // namespace hde_remesh

#endif // HDE_REMESH_READING_POSITION_H
