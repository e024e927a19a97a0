// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "page_mesh.h"
#include "Shown_mesh.h"
#include "base85.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hde_remesh {

namespace {

typedef nlohmann::ordered_json Json;

// numbers of some bits each, the highest bit first, one after the other
class Packed_numbers
{
public:
  explicit Packed_numbers(const int bits) : m_bits(bits) {}

  void push_back(const std::uint32_t number)
  {
    for (int i = m_bits - 1; i >= 0; --i)
    {
      if (m_number_of_bits % 8 == 0)
        m_bytes.push_back(0);
      m_bytes.back() = static_cast<std::uint8_t>(m_bytes.back() | (number >> i & 1u) << (7 - m_number_of_bits % 8));
      ++m_number_of_bits;
    }
  }

  Json to_json() const { return {{"bits", m_bits}, {"count", m_number_of_bits / m_bits}, {"text", base85(m_bytes)}}; }

private:
  int m_bits;
  std::size_t m_number_of_bits = 0;
  std::vector<std::uint8_t> m_bytes;
};

// a simplified mesh may reach a little beyond the box: such a point is put on its side
void append(Packed_numbers& numbers, const Point_3& p, const CGAL::Bbox_3& box)
{
  static constexpr double largest = 0xffffff;
  const double side = (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  for (int i = 0; i < 3; ++i)
  {
    const double steps = (p[i] - (box.min)(i)) / side * largest;
    numbers.push_back(static_cast<std::uint32_t>(std::lround((std::max)(0., (std::min)(steps, largest)))));
  }
}

Json points(const std::vector<Point_3>& of_mesh, const CGAL::Bbox_3& box)
{
  Packed_numbers numbers(24);
  for (const Point_3& p : of_mesh)
    append(numbers, p, box);
  return numbers.to_json();
}

Json faces(const Soup& soup)
{
  int bits = 1;
  while ((soup.points.size() - 1) >> bits > 0)
    ++bits;
  Packed_numbers numbers(bits);
  for (const std::vector<std::size_t>& face : soup.faces)
    for (const std::size_t v : face)
      numbers.push_back(static_cast<std::uint32_t>(v));
  return numbers.to_json();
}

// The last code stands for what is not finite: a degenerate face has no aspect ratio.
Json codes(const Face_figure& figure, const std::vector<std::size_t>& faces)
{
  static constexpr std::uint32_t largest = 0xfffe, not_finite = 0xffff;
  const auto place = [&](const double x) { return figure.is_logarithmic ? std::log(x) : x; };
  double low = 0, high = 0;
  bool has_any = false;
  for (const std::size_t f : faces)
    if (const double x = place(figure.values[f]); std::isfinite(x))
    {
      low = has_any ? (std::min)(low, x) : x;
      high = has_any ? (std::max)(high, x) : x;
      has_any = true;
    }
  Packed_numbers numbers(16);
  for (const std::size_t f : faces)
  {
    const double x = place(figure.values[f]);
    const double share = high > low ? (x - low) / (high - low) : 0;
    numbers.push_back(std::isfinite(x) ? static_cast<std::uint32_t>(std::lround(share * largest)) : not_finite);
  }
  return {{"low", low}, {"high", high}, {"logarithmic", figure.is_logarithmic}, {"codes", numbers.to_json()}};
}

Json curves(const Mesh& mesh, const CGAL::Bbox_3& box)
{
  const Creases creases = creases_of(mesh);
  Packed_numbers numbers(24);
  for (const Mesh::Edge_index e : mesh.edges())
    if (creases.is_crease[e] || mesh.is_border(e))
      for (const int i : {0, 1})
        append(numbers, mesh.point(mesh.vertex(e, i)), box);
  return numbers.to_json();
}

} // namespace

Json page_mesh(const Mesh& mesh, const CGAL::Bbox_3& box, const std::vector<Face_figure>& figures,
               const std::size_t largest_number_of_faces)
{
  const Shown_mesh shown = shown_mesh(mesh, largest_number_of_faces);
  Json json = {{"number_of_faces", shown.number_of_faces},
               {"number_of_shown_faces", shown.soup.faces.size()},
               {"is_simplified", shown.is_simplified()},
               {"points", points(shown.soup.points, box)},
               {"faces", faces(shown.soup)},
               {"curves", curves(mesh, box)}};
  for (const Face_figure& figure : figures)
    json["figures"][figure.key] = codes(figure, shown.origins);
  return json;
}

} // namespace hde_remesh
