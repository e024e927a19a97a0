// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Ply_shares.h"

#include "../hde_remesh/Failure.h"
#include "../hde_remesh/Text_reader.h"
#include "../hde_remesh/ply_header.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <unordered_map>

namespace hde_remesh {

namespace {

constexpr std::uint64_t largest_header = 1 << 20; // bytes

std::size_t size_of(const Ply_type type)
{
  switch (type)
  {
  case Ply_type::INT8:
  case Ply_type::UINT8:
    return 1;
  case Ply_type::INT16:
  case Ply_type::UINT16:
    return 2;
  case Ply_type::FLOAT64:
    return 8;
  default:
    return 4;
  }
}

template <typename T>
T number_at(const std::string& bytes, const std::size_t position)
{
  T value;
  std::memcpy(&value, bytes.data() + position, sizeof value);
  return value;
}

bool is_index(const Ply_type type) { return type == Ply_type::INT32 || type == Ply_type::UINT32; }

} // namespace

Ply_shares::Ply_shares(const std::string& file_name, const std::uint64_t faces_of_share)
  : m_file_name(file_name), m_faces_of_share(faces_of_share)
{
  std::ifstream file(m_file_name, std::ios::binary);
  if (!file)
    fail("it cannot be opened");
  const std::uint64_t size = std::filesystem::file_size(m_file_name);
  std::string head((std::min)(size, largest_header), ' ');
  file.read(head.data(), std::streamsize(head.size()));
  Ply_header header;
  try
  {
    header = read_ply_header(head, size);
  }
  catch (const Unreadable& unreadable)
  {
    fail(unreadable.what());
  }
  if (header.format != Ply_format::BINARY_LITTLE_ENDIAN)
    fail("only binary_little_endian files can be read in shares; hde_remesh converts others");
  std::uint64_t position = header.end;
  for (const Ply_element& element : header.elements)
  {
    std::size_t record = 0;
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
    int coordinates = 0;
    bool has_list = false;
    for (const Ply_property& property : element.properties)
    {
      if (property.size_type)
      {
        if (!is_face || has_list || !is_index(property.type) || size_of(*property.size_type) > 4 ||
            (property.name != "vertex_indices" && property.name != "vertex_index"))
          fail("its element '" + element.name + "' has the list '" + property.name +
               "': all but the 32-bit indices of the faces' vertices must have one size");
        has_list = true;
        m_list = record;
        m_size_of_size = size_of(*property.size_type);
        record += m_size_of_size + 3 * size_of(property.type);
        continue;
      }
      const std::size_t axis = property.name.size() == 1 ? std::string("xyz").find(property.name) : std::string::npos;
      if (is_vertex && axis != std::string::npos)
      {
        const bool is_float = property.type == Ply_type::FLOAT32;
        if ((!is_float && property.type != Ply_type::FLOAT64) || (coordinates > 0 && is_float != m_has_floats))
          fail("its coordinates must be all of type float or all of type double");
        m_has_floats = is_float;
        m_coordinates[axis] = record;
        ++coordinates;
      }
      record += size_of(property.type);
    }
    if (is_vertex)
    {
      if (coordinates != 3)
        fail("its vertices need x, y and z");
      m_first_byte_of_vertices = position;
      m_number_of_vertices = element.number;
      m_size_of_vertex = record;
    }
    else if (is_face)
    {
      if (!has_list)
        fail("its faces need vertex_indices");
      m_first_byte_of_faces = position;
      m_number_of_faces = element.number;
      m_size_of_face = record;
    }
    if (element.number > 0 && record > (size - position) / element.number)
      fail("it is too short for its " + std::to_string(element.number) + " elements '" + element.name +
           "', if all are triangles");
    position += element.number * record;
  }
  if (m_number_of_faces == 0)
    fail("it has no faces");
}

void Ply_shares::fail(const std::string& problem) const
{
  throw Failure("cannot read " + in_quotes(m_file_name) + ": " + problem);
}

std::size_t Ply_shares::number_of_shares() const { return (m_number_of_faces + m_faces_of_share - 1) / m_faces_of_share; }

std::uint64_t Ply_shares::first_face(const std::size_t share) const
{
  return (std::min)(share * m_faces_of_share, m_number_of_faces);
}

std::string Ply_shares::bytes(std::ifstream& file, const std::uint64_t from, const std::uint64_t size) const
{
  std::string result(size, 0);
  file.seekg(std::streamoff(from));
  file.read(result.data(), std::streamsize(size));
  if (!file)
    fail("it ends before byte " + std::to_string(from + size));
  return result;
}

std::array<std::uint64_t, 3> Ply_shares::triangle(const std::string& record, const std::size_t position,
                                                  const std::uint64_t number) const
{
  std::uint64_t size = 0;
  std::memcpy(&size, record.data() + position + m_list, m_size_of_size); // little endian
  if (size != 3)
    fail("face " + std::to_string(number) + " has " + std::to_string(size) + " vertices, not 3");
  std::array<std::uint64_t, 3> result{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    result[k] = number_at<std::uint32_t>(record, position + m_list + m_size_of_size + 4 * k);
    if (result[k] >= m_number_of_vertices)
      fail("face " + std::to_string(number) + " has the vertex " + std::to_string(result[k]) + ", but there are only " +
           std::to_string(m_number_of_vertices));
  }
  if (result[0] == result[1] || result[1] == result[2] || result[2] == result[0])
    fail("face " + std::to_string(number) + " has a vertex twice");
  return result;
}

Ply_shares::Piece_faces Ply_shares::read(const std::size_t share) const
{
  std::ifstream file(m_file_name, std::ios::binary);
  if (!file)
    fail("it cannot be opened");
  const std::uint64_t first = first_face(share), number = first_face(share + 1) - first;
  const std::string records = bytes(file, m_first_byte_of_faces + first * m_size_of_face, number * m_size_of_face);
  std::vector<std::array<std::uint64_t, 3>> triangles;
  Piece_faces result;
  for (std::uint64_t i = 0; i < number; ++i)
  {
    triangles.push_back(triangle(records, i * m_size_of_face, first + i));
    result.names.insert(result.names.end(), triangles.back().begin(), triangles.back().end());
  }
  std::sort(result.names.begin(), result.names.end());
  result.names.erase(std::unique(result.names.begin(), result.names.end()), result.names.end());
  for (const auto& t : triangles)
  {
    std::array<std::uint32_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k)
      face[k] = std::uint32_t(std::lower_bound(result.names.begin(), result.names.end(), t[k]) - result.names.begin());
    result.faces.push_back(face);
  }
  read_points(file, result);
  return result;
}

// reads vertices that are close together in the file at once
void Ply_shares::read_points(std::ifstream& file, Piece_faces& faces) const
{
  static constexpr std::uint64_t largest_gap = 64, largest_run = 1 << 16;
  faces.points.reserve(faces.names.size());
  for (std::size_t i = 0; i < faces.names.size();)
  {
    std::size_t end = i + 1;
    while (end < faces.names.size() && faces.names[end] - faces.names[end - 1] <= largest_gap &&
           faces.names[end] - faces.names[i] < largest_run)
      ++end;
    const std::uint64_t first = faces.names[i];
    const std::string run =
        bytes(file, m_first_byte_of_vertices + first * m_size_of_vertex, (faces.names[end - 1] - first + 1) * m_size_of_vertex);
    for (; i < end; ++i)
    {
      CGAL::Anisotropic_hde_remeshing::internal::Vector p;
      for (int axis = 0; axis < 3; ++axis)
      {
        const std::size_t position = (faces.names[i] - first) * m_size_of_vertex + m_coordinates[std::size_t(axis)];
        p[axis] = m_has_floats ? double(number_at<float>(run, position)) : number_at<double>(run, position);
      }
      if (!p.allFinite())
        fail("a coordinate of vertex " + std::to_string(faces.names[i]) + " is not finite");
      faces.points.push_back(p);
    }
  }
}

} // namespace hde_remesh
