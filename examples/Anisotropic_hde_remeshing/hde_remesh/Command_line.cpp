// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Command_line.h"
#include "Failure.h"
#include "Text_reader.h"
#include "nearest_word.h"

#include <algorithm>

namespace hde_remesh {

namespace {

bool is_number(const std::string& word)
{
  double value;
  return Text_reader::to_number(word, value);
}

} // namespace

const CLI::Option* Command_line::find(const std::string& name) const { return m_app.get_option_no_throw(name); }

bool Command_line::is_option(const std::string& word) const
{
  return word.size() > 1 && word[0] == '-' && (find(word.substr(0, word.find('='))) || !is_number(word));
}

void Command_line::fail_unknown(const std::string& name) const
{
  std::vector<std::string> names;
  for (const CLI::Option* option : m_app.get_options([](const CLI::Option* o) { return !o->get_positional(); }))
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  const std::string nearest = nearest_word(name.substr((std::min)(name.find_first_not_of('-'), name.size())), names);
  throw Failure("unknown option " + name +
                    (nearest.empty() ? ": hde_remesh --help-all names all" : ": did you mean --" + nearest + "?"),
                STATUS_USAGE);
}

// `next` is the word behind it, if there is one
void Command_line::add_option(const std::string& word, const char* next)
{
  const std::size_t end = (std::min)(word.find('='), word.size());
  const std::string name = word.substr(0, end);
  const CLI::Option* const option = find(name);
  if (!option)
    fail_unknown(name);
  if (option->get_items_expected_max() == 0)
  {
    if (end < word.size())
      throw Failure(name + " takes no value", STATUS_USAGE);
    m_words.push_back(name);
    return;
  }
  if (!m_given.insert(option).second)
    throw Failure(name + " is given twice", STATUS_USAGE);
  m_takes_next = end == word.size();
  if (m_takes_next && (!next || is_option(next)))
    throw Failure(name + " needs " + m_list.need_of(name), STATUS_USAGE);
  const std::string value = m_takes_next ? next : word.substr(end + 1);
  if (value.empty())
    m_list.fail(name, value);
  m_words.push_back(name + "=" + value);
}

void Command_line::add_file(const std::string& word)
{
  if (++m_number_of_files > 2)
    throw Failure("IN and OUT are given: " + in_quotes(word) + " is one file too many", STATUS_USAGE);
  m_words.push_back(word);
}

std::vector<std::string> Command_line::checked(const int argc, char** argv)
{
  bool are_files = false; // from -- on
  for (int i = 1; i < argc; ++i)
    if (const std::string word = argv[i]; m_takes_next)
      m_takes_next = false;
    else if (!are_files && word == "--")
      are_files = true;
    else if (!are_files && is_option(word))
      add_option(word, i + 1 < argc ? argv[i + 1] : nullptr);
    else
      add_file(word);
  return m_words;
}

} // namespace hde_remesh
