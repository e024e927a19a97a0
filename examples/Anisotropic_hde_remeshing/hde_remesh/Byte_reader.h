// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_BYTE_READER_H
#define HDE_REMESH_BYTE_READER_H

#include "Text_reader.h"
#include "reading_position.h"

#include <boost/endian/conversion.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace hde_remesh {

// Numbers from the bytes of a file. What is expected next is told by a callable that is only called where the file ends.
class Byte_reader
{
public:
  Byte_reader(const std::string_view bytes, const bool is_big_endian, const std::size_t position)
    : m_bytes(bytes), m_is_big_endian(is_big_endian), m_position(position)
  {
  }

  template <typename Number, typename Expected>
  Number number(const Expected& expected)
  {
    typedef std::conditional_t<sizeof(Number) == 1, std::uint8_t,
                               std::conditional_t<sizeof(Number) == 2, std::uint16_t,
                                                  std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>>>
        Bits;
    if (m_bytes.size() - m_position < sizeof(Number))
      throw Unreadable("byte " + std::to_string(m_position) + ": expected " + std::string(expected()) + ", but the file ends",
                       Unreadable::END);
    Bits bits;
    std::memcpy(&bits, m_bytes.data() + m_position, sizeof(Number));
    m_position += sizeof(Number);
    reading_position().tell(m_position);
    bits = m_is_big_endian ? boost::endian::big_to_native(bits) : boost::endian::little_to_native(bits);
    Number value;
    std::memcpy(&value, &bits, sizeof(Number));
    return value;
  }

  template <typename Number, typename Expected>
  double finite_number(const Expected& expected)
  {
    const double value = static_cast<double>(number<Number>(expected));
    if (!std::isfinite(value))
      fail_at(m_position - sizeof(Number), std::string(expected()) + ", found " + std::to_string(value));
    return value;
  }

  std::size_t position() const { return m_position; }
  std::size_t number_left() const { return m_bytes.size() - m_position; }

  // counted from zero, as in a dump
  [[noreturn]] void fail(const std::string& expected) const { fail_at(m_position, expected); }
  [[noreturn]] static void fail_at(const std::size_t position, const std::string& expected)
  {
    throw Unreadable("byte " + std::to_string(position) + ": expected " + expected);
  }

private:
  std::string_view m_bytes;
  bool m_is_big_endian;
  std::size_t m_position;
};

} // namespace hde_remesh

#endif // HDE_REMESH_BYTE_READER_H
