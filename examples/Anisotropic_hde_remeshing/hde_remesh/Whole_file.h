// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_WHOLE_FILE_H
#define HDE_REMESH_WHOLE_FILE_H

#include "Failure.h"
#include "signals.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hde_remesh {

// Writes a file whole or not at all: into a temporary file in the same directory, which takes the name of the file once
// all is on the disk. Whatever goes wrong before that, the file is as it was.
class Whole_file
{
public:
  // fails if the file cannot be written, before there is anything to write
  explicit Whole_file(const std::string& name) : m_name(name)
  {
    namespace fs = std::filesystem;
    std::error_code error;
    m_target = name;
    for (int i = 0; i < 40 && fs::is_symlink(m_target, error); ++i)          // a link stays a link, its target is written
      m_target = m_target.parent_path() / fs::read_symlink(m_target, error); // of which an absolute one is all
    if (fs::exists(m_target, error) && !fs::is_regular_file(m_target, error))
      fail(fs::is_directory(m_target, error) ? "it is a directory" : "it is no ordinary file");
    if (fs::exists(m_target, error) && access(m_target.c_str(), W_OK) != 0)
      fail(std::strerror(errno));
    close(create_temporary());
    remove_temporary();
  }

  // `writer` puts the contents into the stream
  template <typename Writer>
  void write(const Writer& writer) const
  {
    const int descriptor = create_temporary();
    try
    {
      fill_temporary(writer);
      flush_and_rename(descriptor);
    }
    catch (...)
    {
      close(descriptor);
      remove_temporary();
      throw;
    }
    close(descriptor);
    temporary_name().exists = 0;
  }

private:
  [[noreturn]] void fail(const std::string& reason) const
  {
    throw Failure("cannot write " + in_quotes(m_name) + ": " + reason);
  }

  int create_temporary() const
  {
    const std::string name = (m_target.parent_path() / ".hde_remesh.XXXXXX").string();
    Temporary_name& temporary = temporary_name();
    if (name.size() >= sizeof(temporary.name))
      fail(std::strerror(ENAMETOOLONG));
    temporary.name[name.copy(temporary.name, name.size())] = 0;
    const int descriptor = mkstemp(temporary.name);
    if (descriptor < 0)
      fail(std::strerror(errno));
    temporary.exists = 1;
    return descriptor;
  }

  static void remove_temporary()
  {
    unlink(temporary_name().name);
    temporary_name().exists = 0;
  }

  template <typename Writer>
  void fill_temporary(const Writer& writer) const
  {
    errno = 0;
    std::ofstream stream(temporary_name().name, std::ios::binary);
    if (stream)
      writer(stream);
    stream.close();
    if (!stream)
      fail(errno != 0 ? std::strerror(errno) : "the contents could not be written");
  }

  void flush_and_rename(const int descriptor) const
  {
    struct stat old;
    const mode_t mask = umask(0); // the only way to ask for it
    umask(mask);
    const mode_t mode = stat(m_target.c_str(), &old) == 0 ? (old.st_mode & 0777) : (0666 & ~mask);
    if (fchmod(descriptor, mode) != 0 || fsync(descriptor) != 0 || std::rename(temporary_name().name, m_target.c_str()) != 0)
      fail(std::strerror(errno));
  }

  std::string m_name; // as the user wrote it
  std::filesystem::path m_target;
};

} // namespace hde_remesh

#endif // HDE_REMESH_WHOLE_FILE_H
