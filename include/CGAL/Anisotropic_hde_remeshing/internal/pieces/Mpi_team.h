// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_MPI_TEAM_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_MPI_TEAM_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Task_team.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <cstddef>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// thrown on all ranks alike
struct Failed_step : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// The ranks of a communicator. Each does successive tasks: they are side by side in space, so that it can keep what it has built for
// the last one. All that goes through messages is what tasks return; the pieces are in a store that all ranks see.
class Mpi_team : public Task_team
{
public:
  explicit Mpi_team(const boost::mpi::communicator& communicator) : m_communicator(communicator) {}

  std::vector<Bytes> run(const std::string& step, const std::size_t number_of_tasks, const Task& task) override
  {
    const std::size_t rank = std::size_t(m_communicator.rank()), size = std::size_t(m_communicator.size());
    std::pair<std::string, std::vector<Bytes>> mine; // what failed, and the results
    try
    {
      for (std::size_t i = number_of_tasks * rank / size; i < number_of_tasks * (rank + 1) / size; ++i)
        mine.second.push_back(task(i));
    }
    catch (const std::bad_alloc&)
    {
      mine.first = "there is not enough memory for the step '" + step + "'";
    }
    catch (const std::exception& error)
    {
      mine.first = error.what();
    }
    std::vector<std::pair<std::string, std::vector<Bytes>>> all;
    boost::mpi::all_gather(m_communicator, mine, all);
    std::vector<Bytes> results;
    for (auto& of_rank : all)
    {
      if (!of_rank.first.empty())
        throw Failed_step(of_rank.first);
      for (Bytes& bytes : of_rank.second)
        results.push_back(std::move(bytes));
    }
    for (const Bytes& bytes : mine.second)
      m_bytes_sent += bytes.size() * (size - 1);
    return results;
  }

  // by this rank
  std::size_t bytes_sent() const { return m_bytes_sent; }

private:
  const boost::mpi::communicator& m_communicator;
  std::size_t m_bytes_sent = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_MPI_TEAM_H
