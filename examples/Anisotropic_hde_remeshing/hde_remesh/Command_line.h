// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_COMMAND_LINE_H
#define HDE_REMESH_COMMAND_LINE_H

#include "Option_list.h"

#include <CLI/CLI.hpp>

#include <set>
#include <string>
#include <vector>

namespace hde_remesh {

// The words of a command line, checked before CLI11 sees them: its messages do not say what was meant, and it takes -inf for an option.
class Command_line
{
public:
  Command_line(const CLI::App& app, const Option_list& list) : m_app(app), m_list(list) {}

  // Each option with its value as one word, the files as they are. Fails if an option is not known, is given twice, or misses its
  // value.
  std::vector<std::string> checked(int argc, char** argv);

private:
  const CLI::Option* find(const std::string& name) const;
  bool is_option(const std::string& word) const;
  void add_option(const std::string& word, const char* next);
  void add_file(const std::string& word);
  [[noreturn]] void fail_unknown(const std::string& name) const;

  const CLI::App& m_app;
  const Option_list& m_list;
  std::vector<std::string> m_words;
  std::set<const CLI::Option*> m_given;
  std::size_t m_number_of_files = 0;
  bool m_takes_next = false; // whether the next word is the value of an option
};

} // namespace hde_remesh

#endif // HDE_REMESH_COMMAND_LINE_H
