// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_TEXT_READER_H
#define HDE_REMESH_TEXT_READER_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hde_remesh {

// why a file cannot be read: where, what was expected there, and what is there
class Unreadable : public std::runtime_error
{
public:
  enum Place
  {
    BEGINNING, // where other kinds of files differ
    ELSEWHERE,
    END // more is expected than there is
  };

  explicit Unreadable(const std::string& reason, const Place place = ELSEWHERE) : std::runtime_error(reason), m_place(place) {}

  Place place() const { return m_place; }

private:
  Place m_place;
};

// "12 of 20", counted from one
inline std::string ordinal(const std::size_t i, const std::size_t number)
{
  return std::to_string(i + 1) + " of " + std::to_string(number);
}

// as a message shows it
std::string excerpt(std::string_view word);

// A text line by line and word by word. Lines end in \n, \r\n or \r; those without a word are passed over. What is expected next
// is told by a callable that is only called where the text has something else.
class Text_reader
{
public:
  enum Kind
  {
    PLAIN,
    WITH_COMMENTS,      // from a # to the end of the line
    WITH_CONTINUATIONS, // and a line that ends in a backslash goes on in the next one
  };

  // the text stays, and has a null character behind its end
  explicit Text_reader(std::string_view text, Kind kind, std::size_t position = 0, std::size_t line_number = 0);

  // the next line; false at the end of the text
  bool next_line();
  const std::vector<std::string_view>& words() const { return m_words; } // of the line

  // the next word of the line, or else of the next line
  template <typename Expected>
  std::string_view word(const Expected& expected)
  {
    if (m_next_word == m_words.size() && !next_line())
      fail(expected(), "");
    return m_words[m_next_word++];
  }

  bool is_line_done() const { return m_next_word == m_words.size(); }
  void skip_line() { m_next_word = m_words.size(); }
  bool is_done(); // after the last word of the text

  std::size_t number_of_lines_left() const;           // with a word, after this one
  std::size_t position() const { return m_position; } // of the character after the line
  std::size_t line_number() const { return m_line_number; }

  // "line 7: expected a, found 'b'", or that the text ends if there is no `found`
  [[noreturn]] void fail(const std::string& expected, std::string_view found) const;

  template <typename Expected>
  double finite_number(const std::string_view word, const Expected& expected)
  {
    double value = 0;
    if (!to_number(word, value))
      fail("a number, " + expected(), word);
    if (!is_finite(value))
      fail_not_finite(word, expected());
    count_digits(word);
    return value;
  }

  template <typename Expected>
  std::size_t whole_number(const std::string_view word, const Expected& expected) const
  {
    std::size_t value = 0;
    if (!to_whole_number(word, value))
      fail(expected(), word);
    return value;
  }

  static bool to_number(std::string_view word, double& value); // that ends where the word ends
  static bool to_whole_number(std::string_view word, std::size_t& value);

  // the unit in the last place of numbers of this size, as far as the finite numbers until now are written; 0 if they are short
  double unit_in_last_place(double largest) const;

private:
  [[noreturn]] void fail_not_finite(std::string_view word, const std::string& expected) const;
  static bool is_finite(double value);
  void count_digits(std::string_view word);
  std::string_view take_line();

  std::string_view m_text;
  Kind m_kind;
  std::size_t m_position, m_line_number;
  std::vector<std::string_view> m_words;
  std::size_t m_next_word = 0;
  bool m_is_position_told = true;
  int m_most_digits = 0;
};

} // namespace hde_remesh

#endif // HDE_REMESH_TEXT_READER_H
