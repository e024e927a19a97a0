// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_SIGNALS_H
#define HDE_REMESH_SIGNALS_H

#include <climits>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <string>

#include <unistd.h>

// What happens at Ctrl-C and at SIGTERM: no temporary file stays, and the remeshing can be left in order.

namespace hde_remesh {

// Names that a signal handler can read: plain memory, as a handler must not allocate.
struct Temporary_name
{
  char name[PATH_MAX] = "";
  volatile std::sig_atomic_t exists = 0;
};

inline Temporary_name& temporary_name()
{
  static Temporary_name name;
  return name;
}

inline volatile std::sig_atomic_t& is_listening() // whether somebody looks at `is_cancelled()`
{
  static volatile std::sig_atomic_t flag = 0;
  return flag;
}

inline volatile std::sig_atomic_t& is_cancelled()
{
  static volatile std::sig_atomic_t flag = 0;
  return flag;
}

inline volatile std::sig_atomic_t& is_output_written()
{
  static volatile std::sig_atomic_t flag = 0;
  return flag;
}

inline volatile std::sig_atomic_t& is_stopping() // whether a handler has the last word
{
  static volatile std::sig_atomic_t flag = 0;
  return flag;
}

// the words of what ends the program at Ctrl-C, wherever it is
inline const char* cancelled_text()
{
  return is_output_written() ? "cancelled; the mesh is written" : "cancelled; nothing was written";
}

extern "C" inline void write_of_handler(const char* text)
{
  const ssize_t ignored = write(STDERR_FILENO, text, std::strlen(text));
  static_cast<void>(ignored);
}

extern "C" inline void handle_signal(const int signal_number)
{
  if (signal_number == SIGINT && is_listening() && !is_cancelled())
  {
    is_cancelled() = 1; // a second Ctrl-C ends the program at once
    return;
  }
  if (temporary_name().exists)
    unlink(temporary_name().name);
  is_stopping() = 1;
  if (isatty(STDERR_FILENO))
    write_of_handler("\r\033[K"); // over the line of the progress
  write_of_handler("hde_remesh: ");
  if (signal_number == SIGINT)
    write_of_handler(cancelled_text());
  else
    write_of_handler(is_output_written() ? "stopped by a signal; the mesh is written"
                                         : "stopped by a signal; nothing was written");
  write_of_handler("\n");
  std::signal(signal_number, SIG_DFL); // whoever waits for this program learns what ended it
  std::raise(signal_number);
}

inline void install_signal_handlers()
{
  // construct them now: a handler must not be the first to ask
  temporary_name();
  is_listening() = 0;
  is_cancelled() = 0;
  is_output_written() = 0;
  is_stopping() = 0;
  std::signal(SIGINT, handle_signal);
  std::signal(SIGTERM, handle_signal);
  if (std::signal(SIGHUP, handle_signal) == SIG_IGN) // started by nohup
    std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow is a failed write, which is reported
}

} // namespace hde_remesh

#endif // HDE_REMESH_SIGNALS_H
