// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Writers of mesh files as programs of all kinds write them: formats, their dialects, rounding.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FILE_FORMATS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FILE_FORMATS_H

#include "polygon_soups.h"
#include "shapes.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <random>
#include <string>

namespace file_formats {

using polygon_soups::Polygon_soup;
using shapes::Point_3;

inline Polygon_soup soup_of(const shapes::Mesh& mesh)
{
  Polygon_soup soup;
  for (const auto v : mesh.vertices())
    soup.points.push_back(mesh.point(v));
  for (const auto f : mesh.faces())
  {
    soup.polygons.emplace_back();
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      soup.polygons.back().push_back(std::size_t(v));
  }
  return soup;
}

inline void write_point(std::ostream& out, const Point_3& p) { out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n'; }

// `header` is what stands before the points; the first '#' in it becomes their number, the second that of the faces
inline void write_off(std::ostream& out, const Polygon_soup& soup, const std::string& header = "OFF\n# # 0\n",
                      const int digits = 17)
{
  out.precision(digits);
  bool is_first = true;
  for (const char c : header)
    if (c != '#')
      out << c;
    else
    {
      out << (is_first ? soup.points.size() : soup.polygons.size());
      is_first = false;
    }
  for (const Point_3& p : soup.points)
    write_point(out, p);
  for (const auto& polygon : soup.polygons)
  {
    out << polygon.size();
    for (const std::size_t i : polygon)
      out << ' ' << i;
    out << '\n';
  }
}

// `separator` stands between the corners of a face: " ", or " \\\n" for continued lines
inline void write_obj(std::ostream& out, const Polygon_soup& soup, const std::string& separator = " ", const char* rest = "")
{
  out.precision(17);
  for (const Point_3& p : soup.points)
    write_point(out << "v ", p);
  out << rest;
  for (const auto& polygon : soup.polygons)
  {
    out << "f";
    for (std::size_t i = 0; i < polygon.size(); ++i)
      out << (i == 0 ? std::string(" ") : separator) << polygon[i] + 1;
    out << '\n';
  }
}

// big-endian, indices as unsigned short, lists counted by char
inline void write_ply(std::ostream& out, const Polygon_soup& soup)
{
  out << "ply\nformat binary_big_endian 1.0\nelement vertex " << soup.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << soup.polygons.size()
      << "\nproperty list char ushort vertex_indices\nend_header\n";
  const auto write = [&out](const std::uint64_t bits, const int bytes)
  {
    for (int k = bytes - 1; k >= 0; --k)
      out.put(char((bits >> (8 * k)) & 0xff));
  };
  for (const Point_3& p : soup.points)
    for (const double x : {p.x(), p.y(), p.z()})
    {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      write(bits, 8);
    }
  for (const auto& polygon : soup.polygons)
  {
    write(polygon.size(), 1);
    for (const std::size_t i : polygon)
      write(i, 2);
  }
}

struct Stl_words
{
  std::string solid = "solid s", facet = "facet normal 0 0 1", outer = "outer loop", vertex = "vertex ", end_loop = "endloop",
              end_facet = "endfacet", end_solid = "endsolid s\n";
};

// as text; `rounded` is asked for each corner of each triangle, what its coordinate becomes
template <typename Rounded>
void write_stl_text(std::ostream& out, const Polygon_soup& soup, const Stl_words& words, const Rounded& rounded)
{
  out.precision(9);
  out << words.solid << '\n';
  for (const auto& polygon : soup.polygons)
  {
    out << words.facet << '\n' << words.outer << '\n';
    for (const std::size_t i : polygon)
    {
      const Point_3& p = soup.points[i];
      out << words.vertex << rounded(p.x()) << ' ' << rounded(p.y()) << ' ' << rounded(p.z()) << '\n';
    }
    out << words.end_loop << '\n' << words.end_facet << '\n';
  }
  out << words.end_solid;
}

template <typename Rounded>
void write_stl(std::ostream& out, const Polygon_soup& soup, const Rounded& rounded)
{
  const std::string header(80, ' ');
  const std::uint32_t number = std::uint32_t(soup.polygons.size());
  out << header;
  out.write(reinterpret_cast<const char*>(&number), sizeof number);
  for (const auto& polygon : soup.polygons)
  {
    float record[12] = {};
    for (std::size_t k = 0; k < 3; ++k)
      for (int c = 0; c < 3; ++c)
        record[3 + 3 * k + std::size_t(c)] = float(rounded(soup.points[polygon[k]][c]));
    out.write(reinterpret_cast<const char*>(record), sizeof record);
    out.write("\0\0", 2);
  }
}

inline double exact(const double x) { return x; }

// a third of all numbers becomes the float after or before it
class One_ulp
{
public:
  double operator()(const double x) const
  {
    const float y = float(x), infinity = std::numeric_limits<float>::infinity();
    const auto n = m_random() % 6;
    return n == 0 ? std::nextafter(y, infinity) : n == 1 ? std::nextafter(y, -infinity) : y;
  }

private:
  mutable std::mt19937 m_random{5};
};

// what is near 0 becomes one of the tiny numbers that sines and cosines leave
class Tiny_for_zero
{
public:
  double operator()(const double x) const
  {
    static constexpr double tiny[] = {0, 2e-18, -1.5e-17, 6.1e-17};
    return std::abs(x) < 1e-12 ? tiny[m_random() % 4] : x;
  }

private:
  mutable std::mt19937 m_random{7};
};

} // namespace file_formats

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FILE_FORMATS_H
