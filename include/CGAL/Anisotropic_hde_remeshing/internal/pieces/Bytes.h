// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_BYTES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_BYTES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_faces.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// what goes from one process to another or into a file, in the order of bytes of the machine
typedef std::vector<char> Bytes;

class Byte_writer
{
public:
  template <typename T>
  Byte_writer& operator<<(const T& value)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values have bytes");
    append(&value, sizeof(T));
    return *this;
  }

  Byte_writer& operator<<(const Vector& v) { return *this << v.x() << v.y() << v.z(); }

  template <typename T>
  Byte_writer& operator<<(const std::vector<T>& values)
  {
    static_assert(std::is_trivially_copyable<T>::value || std::is_same<T, Vector>::value, "only plain values have bytes");
    *this << std::uint64_t(values.size());
    append(values.data(), values.size() * sizeof(T));
    return *this;
  }

  Byte_writer& operator<<(const Piece_faces& f) { return *this << f.names << f.points << f.faces << f.seams; }

  Bytes take() { return std::move(m_bytes); }

private:
  void append(const void* data, const std::size_t size)
  {
    const char* begin = static_cast<const char*>(data);
    m_bytes.insert(m_bytes.end(), begin, begin + size);
  }

  Bytes m_bytes;
};

// throws if there are fewer bytes than are asked for
class Byte_reader
{
public:
  explicit Byte_reader(const Bytes& bytes) : m_bytes(bytes) {}

  template <typename T>
  Byte_reader& operator>>(T& value)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values have bytes");
    take(&value, sizeof(T));
    return *this;
  }

  Byte_reader& operator>>(Vector& v) { return *this >> v.x() >> v.y() >> v.z(); }

  template <typename T>
  Byte_reader& operator>>(std::vector<T>& values)
  {
    static_assert(std::is_trivially_copyable<T>::value || std::is_same<T, Vector>::value, "only plain values have bytes");
    std::uint64_t size = 0;
    *this >> size;
    if (size > (m_bytes.size() - m_next) / sizeof(T))
      throw std::runtime_error("a file of a piece is too short");
    values.resize(size);
    take(values.data(), size * sizeof(T));
    return *this;
  }

  Byte_reader& operator>>(Piece_faces& f) { return *this >> f.names >> f.points >> f.faces >> f.seams; }

private:
  void take(void* to, const std::size_t size)
  {
    if (size > m_bytes.size() - m_next)
      throw std::runtime_error("a file of a piece is too short");
    if (size > 0)
      std::memcpy(to, m_bytes.data() + m_next, size);
    m_next += size;
  }

  const Bytes& m_bytes;
  std::size_t m_next = 0;
};

template <typename T>
Bytes bytes_of(const T& value)
{
  Byte_writer writer;
  writer << value;
  return writer.take();
}

template <typename T>
T from_bytes(const Bytes& bytes)
{
  T value;
  Byte_reader reader(bytes);
  reader >> value;
  return value;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_BYTES_H
