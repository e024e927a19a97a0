// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_BASE64_H
#define HDE_REMESH_BASE64_H

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <string>
#include <vector>

namespace hde_remesh {

// the bytes of the values, which are little endian where the program runs, as everywhere today
template <typename T>
std::string base64(const std::vector<T>& values)
{
  typedef boost::archive::iterators::base64_from_binary<boost::archive::iterators::transform_width<const char*, 6, 8>>
      Characters;
  const char* begin = reinterpret_cast<const char*>(values.data());
  const std::size_t size = values.size() * sizeof(T);
  std::string result(Characters(begin), Characters(begin + size));
  result.append((3 - size % 3) % 3, '=');
  return result;
}

} // namespace hde_remesh

#endif // HDE_REMESH_BASE64_H
