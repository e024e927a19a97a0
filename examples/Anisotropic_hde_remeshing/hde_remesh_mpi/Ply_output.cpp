// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Ply_output.h"

#include "../hde_remesh/Failure.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace hde_remesh {

namespace {

constexpr std::uint64_t size_of_vertex = 3 * sizeof(double), size_of_face = 1 + 3 * sizeof(std::int32_t);

[[noreturn]] void fail(const std::string& name, const std::string& reason)
{
  throw Failure("cannot write " + in_quotes(name) + ": " + reason);
}

// beside the file, so that it can be renamed; the same for all processes
std::string part_name(const std::string& file_name)
{
  const std::filesystem::path path(file_name);
  return (path.parent_path() / ("." + path.filename().string() + ".part")).string();
}

template <typename T>
void append(std::vector<char>& bytes, const T value)
{
  const char* begin = reinterpret_cast<const char*>(&value);
  bytes.insert(bytes.end(), begin, begin + sizeof value);
}

} // namespace

Ply_output::Ply_output(const std::string& file_name, const std::uint64_t number_of_vertices,
                       const std::uint64_t number_of_faces)
  : m_name(file_name),
    m_part_name(part_name(file_name)),
    m_number_of_vertices(number_of_vertices),
    m_number_of_faces(number_of_faces)
{
  if (number_of_vertices > std::uint64_t((std::numeric_limits<std::int32_t>::max)()))
    fail(m_name, "it would have " + std::to_string(number_of_vertices) + " vertices, more than its indices can tell apart");
  m_header = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(number_of_vertices) +
             "\nproperty double x\nproperty double y\nproperty double z\nelement face " + std::to_string(number_of_faces) +
             "\nproperty list uchar int vertex_indices\nend_header\n";
}

void Ply_output::check(const std::string& file_name)
{
  std::error_code error;
  if (std::filesystem::exists(file_name, error) && !std::filesystem::is_regular_file(file_name, error))
    fail(file_name, "it is no ordinary file");
  const std::string name = part_name(file_name);
  const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT, 0666);
  if (descriptor < 0)
    fail(file_name, std::strerror(errno));
  close(descriptor);
  unlink(name.c_str());
}

void Ply_output::begin() const
{
  std::ofstream file(m_part_name, std::ios::binary);
  file << m_header;
  file.close();
  if (!file)
    fail(m_name, "the disk may be full");
  const int descriptor = open(m_part_name.c_str(), O_WRONLY);
  const std::uint64_t size = m_header.size() + m_number_of_vertices * size_of_vertex + m_number_of_faces * size_of_face;
  const int error = descriptor < 0 ? errno : posix_fallocate(descriptor, 0, off_t(size)); // a full disk is found here
  if (descriptor >= 0)
    close(descriptor);
  if (error != 0)
    fail(m_name, std::strerror(error));
}

void Ply_output::write(const CGAL::Anisotropic_hde_remeshing::internal::Joined_numbers::Part& part) const
{
  std::vector<char> vertices, faces;
  for (const auto& p : part.points)
    for (int axis = 0; axis < 3; ++axis)
      append(vertices, p[axis]);
  for (const auto& face : part.faces)
  {
    faces.push_back(3);
    for (const std::uint64_t v : face)
      append(faces, std::int32_t(v));
  }
  std::fstream file(m_part_name, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(std::streamoff(m_header.size() + part.first_vertex * size_of_vertex));
  file.write(vertices.data(), std::streamsize(vertices.size()));
  file.seekp(std::streamoff(m_header.size() + m_number_of_vertices * size_of_vertex + part.first_face * size_of_face));
  file.write(faces.data(), std::streamsize(faces.size()));
  file.close();
  if (!file)
    fail(m_name, "the disk may be full");
}

void Ply_output::finish() const
{
  const int descriptor = open(m_part_name.c_str(), O_RDONLY);
  const bool is_flushed = descriptor >= 0 && fsync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0)
    close(descriptor);
  if (!is_flushed)
    fail(m_name, std::strerror(error));
  std::error_code code;
  std::filesystem::rename(m_part_name, m_name, code);
  if (code)
    fail(m_name, code.message());
}

void Ply_output::abandon() const noexcept { unlink(m_part_name.c_str()); }

} // namespace hde_remesh
