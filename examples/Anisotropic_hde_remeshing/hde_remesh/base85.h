// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_BASE85_H
#define HDE_REMESH_BASE85_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hde_remesh {

// Bytes as text: four are five characters, where base 64 has 5.3. The last ones are filled up with zeros. No character means
// something in JSON or HTML: there is no ", no &, no \ and no <.
inline std::string base85(const std::vector<std::uint8_t>& bytes)
{
  static const char digits[] = "#$%'()*+,-./0123456789:;=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[]^_`abcdefghijklmnopqrstuvwxyz";
  std::string result;
  result.reserve((bytes.size() + 3) / 4 * 5);
  for (std::size_t begin = 0; begin < bytes.size(); begin += 4)
  {
    std::uint32_t word = 0;
    for (std::size_t i = begin; i < begin + 4; ++i)
      word = word << 8 | (i < bytes.size() ? bytes[i] : 0u);
    for (std::uint32_t power = 85u * 85 * 85 * 85; power > 0; power /= 85)
      result += digits[word / power % 85];
  }
  return result;
}

} // namespace hde_remesh

#endif // HDE_REMESH_BASE85_H
