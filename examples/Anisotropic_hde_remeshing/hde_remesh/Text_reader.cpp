// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Text_reader.h"
#include "reading_position.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace hde_remesh {

namespace {

constexpr std::string_view blanks = " \t\v\f";

bool is_digit(const char c) { return c >= '0' && c <= '9'; }

} // namespace

std::string excerpt(const std::string_view word)
{
  std::string result = "'";
  for (const char c : word.substr(0, 40))
    result += c >= ' ' && c <= '~' ? c : '?';
  return result + (word.size() > 40 ? "...'" : "'");
}

Text_reader::Text_reader(const std::string_view text, const Kind kind, const std::size_t position,
                         const std::size_t line_number)
  : m_text(text), m_kind(kind), m_position(position), m_line_number(line_number)
{
}

// without its end, which is passed
std::string_view Text_reader::take_line()
{
  const std::size_t begin = m_position, end = (std::min)(m_text.find_first_of("\n\r", begin), m_text.size());
  m_position = end;
  if (m_position < m_text.size())
    m_position += m_text.compare(end, 2, "\r\n") == 0 ? 2 : 1;
  ++m_line_number;
  if (m_is_position_told)
    reading_position().tell(m_position);
  return m_text.substr(begin, end - begin);
}

bool Text_reader::next_line()
{
  m_words.clear();
  m_next_word = 0;
  bool goes_on = false;
  while ((m_words.empty() || goes_on) && m_position < m_text.size())
  {
    std::string_view line = take_line();
    if (m_kind != PLAIN)
      line = line.substr(0, line.find('#'));
    line = line.substr(0, line.find_last_not_of(blanks) + 1);
    goes_on = m_kind == WITH_CONTINUATIONS && !line.empty() && line.back() == '\\';
    if (goes_on)
      line.remove_suffix(1);
    for (std::size_t begin = line.find_first_not_of(blanks), end; begin < line.size();
         begin = line.find_first_not_of(blanks, end))
    {
      end = (std::min)(line.find_first_of(blanks, begin), line.size());
      m_words.push_back(line.substr(begin, end - begin));
    }
  }
  return !m_words.empty();
}

bool Text_reader::is_done() { return is_line_done() && !next_line(); }

std::size_t Text_reader::number_of_lines_left() const
{
  Text_reader rest(m_text, m_kind, m_position);
  rest.m_is_position_told = false;
  std::size_t number = 0;
  while (rest.next_line())
    ++number;
  return number;
}

void Text_reader::fail(const std::string& expected, const std::string_view found) const
{
  throw Unreadable("line " + std::to_string(m_line_number) + ": expected " + expected +
                       (found.empty() ? ", but the file ends" : ", found " + excerpt(found)),
                   found.empty()        ? Unreadable::END
                   : m_line_number == 1 ? Unreadable::BEGINNING
                                        : Unreadable::ELSEWHERE);
}

void Text_reader::fail_not_finite(const std::string_view word, const std::string& expected) const
{
  throw Unreadable("line " + std::to_string(m_line_number) + ": " + excerpt(word) + " is not a finite number: expected " +
                   expected);
}

bool Text_reader::is_finite(const double value) { return std::isfinite(value); }

bool Text_reader::to_number(const std::string_view word, double& value)
{
  char* end = nullptr;
  value = std::strtod(word.data(), &end);
  return end == word.data() + word.size();
}

bool Text_reader::to_whole_number(const std::string_view word, std::size_t& value)
{
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

// without zeros in front and behind the exponent
void Text_reader::count_digits(const std::string_view word)
{
  int number = 0;
  for (const char c : word)
    if (c == 'e' || c == 'E')
      break;
    else if (is_digit(c) && (number > 0 || c != '0'))
      ++number;
  m_most_digits = (std::max)(m_most_digits, number);
}

double Text_reader::unit_in_last_place(const double largest) const
{
  static constexpr int least_digits = 6; // what programs write as a rule; shorter numbers are taken as exact
  if (m_most_digits < least_digits || !(largest > 0))
    return 0;
  return std::pow(10., std::floor(std::log10(largest)) + 1 - m_most_digits);
}

} // namespace hde_remesh
