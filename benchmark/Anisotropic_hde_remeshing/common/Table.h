// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_TABLE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_TABLE_H

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// numbers with three digits, counts with all
template <typename T>
std::string text(const T& value)
{
  std::ostringstream stream;
  stream << std::setprecision(std::is_floating_point<T>::value ? 3 : 6) << value;
  return stream.str();
}

// Rows of text, printed in columns: the first one flush left, the others flush right.
class Table
{
public:
  explicit Table(const std::string& title) : m_title(title) {}

  template <typename... Cells>
  void add(const Cells&... cells)
  {
    m_rows.push_back({text(cells)...});
  }

  void print() const
  {
    std::vector<std::size_t> widths;
    for (const std::vector<std::string>& row : m_rows)
    {
      widths.resize((std::max)(widths.size(), row.size()), 0);
      for (std::size_t k = 0; k < row.size(); ++k)
        widths[k] = (std::max)(widths[k], row[k].size());
    }
    std::cout << '\n' << m_title << '\n';
    for (const std::vector<std::string>& row : m_rows)
    {
      for (std::size_t k = 0; k < row.size(); ++k)
        std::cout << "  " << (k == 0 ? std::left : std::right) << std::setw(int(widths[k])) << row[k];
      std::cout << '\n';
    }
    std::cout << std::flush;
  }

  // the same as comma-separated values; cells have neither commas nor quotation marks
  void write_csv(const std::string& file) const
  {
    std::ofstream out(file);
    for (const std::vector<std::string>& row : m_rows)
      for (std::size_t k = 0; k < row.size(); ++k)
        out << row[k] << (k + 1 < row.size() ? ',' : '\n');
    if (!out.flush())
      throw std::runtime_error("cannot write " + file);
  }

private:
  std::string m_title;
  std::vector<std::vector<std::string>> m_rows;
};

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_TABLE_H
