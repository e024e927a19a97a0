// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_OPTION_LIST_H
#define HDE_REMESH_OPTION_LIST_H

#include "options.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hde_remesh {

// The options of the program, with their groups and what the help says of them. Reading a value throws a Failure if the text is none.
class Option_list
{
public:
  Option_list(CLI::App& app, Options& options);

  // what a value of the option is: "a number or auto"
  const std::string& need_of(const std::string& option) const { return m_needs.at(option); }

  // that the text is no value of the option
  [[noreturn]] void fail(const std::string& option, const std::string& text) const;

private:
  typedef std::function<bool(const std::string&)> Reader; // whether the text is a value

  void add(const std::string& option, const char* value, const std::string& need, const char* meaning, const Reader& read);
  void add_number(const std::string& option, const char* value, std::optional<double>& target, const char* meaning);
  void add_number_or_auto(const std::string& option, std::optional<double>& target, bool& is_automatic, const char* meaning);
  void add_count(const std::string& option, std::optional<long long>& target, const char* meaning);
  void add_text(const std::string& option, const char* value, const std::string& need, std::string& target,
                const char* meaning);
  void add_choice(const std::string& option, const std::vector<std::string>& choices, std::string& target, const char* meaning);
  void add_flag(const std::string& option, bool& target, const char* meaning);

  void add_sizes();
  void add_embedding();
  void add_remeshing();
  void add_input();
  void add_points();
  void add_function();
  void add_output();
  void add_help();

  CLI::App& m_app;
  Options& m_options;
  std::string m_group;
  std::map<std::string, std::string> m_needs;
};

} // namespace hde_remesh

#endif // HDE_REMESH_OPTION_LIST_H
