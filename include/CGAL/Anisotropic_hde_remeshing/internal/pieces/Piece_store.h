// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_STORE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_STORE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Bytes.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// where the pieces are that nobody works on. What one process puts there, any other one can get after the step.
class Piece_store
{
public:
  virtual ~Piece_store() = default;
  virtual void put(const std::string& key, const Bytes& bytes) = 0;
  // throws if there is nothing
  virtual Bytes get(const std::string& key) const = 0;
  virtual bool has(const std::string& key) const = 0;
  // does nothing if there is nothing
  virtual void erase(const std::string& key) = 0;

  // by this process
  std::size_t bytes_put() const { return m_bytes_put; }
  std::size_t bytes_got() const { return m_bytes_got; }

protected:
  std::size_t m_bytes_put = 0;
  mutable std::size_t m_bytes_got = 0;
};

// for one process
class Memory_store : public Piece_store
{
public:
  void put(const std::string& key, const Bytes& bytes) override
  {
    m_bytes_put += bytes.size();
    m_values[key] = bytes;
  }

  Bytes get(const std::string& key) const override
  {
    const auto found = m_values.find(key);
    if (found == m_values.end())
      throw std::runtime_error("there is no " + key + " among the pieces");
    m_bytes_got += found->second.size();
    return found->second;
  }

  bool has(const std::string& key) const override { return m_values.count(key) > 0; }
  void erase(const std::string& key) override { m_values.erase(key); }

private:
  std::map<std::string, Bytes> m_values;
};

// Files of a folder that all processes see. A file gets its name when it is whole, so a process that is killed leaves none that is
// not.
class Folder_store : public Piece_store
{
public:
  explicit Folder_store(std::filesystem::path folder) : m_folder(std::move(folder))
  {
    std::filesystem::create_directories(m_folder);
  }

  void put(const std::string& key, const Bytes& bytes) override
  {
    const std::filesystem::path path = m_folder / key, part = m_folder / (key + ".part");
    std::filesystem::create_directories(path.parent_path());
    std::ofstream file(part, std::ios::binary);
    file.write(bytes.data(), std::streamsize(bytes.size()));
    file.close();
    if (!file)
    {
      std::error_code ignored;
      std::filesystem::remove(part, ignored);
      throw std::runtime_error("cannot write " + part.string() + ": the disk may be full");
    }
    std::filesystem::rename(part, path);
    m_bytes_put += bytes.size();
  }

  Bytes get(const std::string& key) const override
  {
    const std::filesystem::path path = m_folder / key;
    std::ifstream file(path, std::ios::binary);
    if (!file)
      throw std::runtime_error("cannot read " + path.string());
    Bytes bytes(std::filesystem::file_size(path));
    file.read(bytes.data(), std::streamsize(bytes.size()));
    if (!file)
      throw std::runtime_error("cannot read " + path.string());
    m_bytes_got += bytes.size();
    return bytes;
  }

  bool has(const std::string& key) const override { return std::filesystem::exists(m_folder / key); }

  void erase(const std::string& key) override
  {
    std::error_code ignored;
    std::filesystem::remove(m_folder / key, ignored);
  }

private:
  const std::filesystem::path m_folder;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_STORE_H
