// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_FAILURE_H
#define HDE_REMESH_FAILURE_H

#include <stdexcept>
#include <string>

namespace hde_remesh {

enum Exit_status
{
  STATUS_SUCCESS = 0,
  STATUS_FAILURE = 1,    // the input, a value or the output is unusable
  STATUS_USAGE = 2,      // the command line makes no sense
  STATUS_CANCELLED = 130 // Ctrl-C, as shells count it
};

// what ends the program: one line for the user and the exit status
class Failure : public std::runtime_error
{
public:
  explicit Failure(const std::string& message, const Exit_status status = STATUS_FAILURE)
    : std::runtime_error(message), m_status(status)
  {
  }

  Exit_status status() const { return m_status; }

private:
  Exit_status m_status;
};

inline std::string in_quotes(const std::string& name) { return "'" + name + "'"; }

} // namespace hde_remesh

#endif // HDE_REMESH_FAILURE_H
