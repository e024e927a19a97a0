// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_TASK_TEAM_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_TASK_TEAM_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Bytes.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Those who do the tasks of a step: one process, or the ranks of a communicator. A task reads what earlier steps have put into the
// store, and nothing of its own step, so it does not matter who does it, nor in which order.
class Task_team
{
public:
  typedef std::function<Bytes(std::size_t)> Task;

  virtual ~Task_team() = default;

  // Runs task(i) for all i below the number, each once. Returns what they return, in their order, to all members of the team. If a task
  // throws, all members throw its message.
  virtual std::vector<Bytes> run(const std::string& step, std::size_t number_of_tasks, const Task& task) = 0;
};

class Team_of_one : public Task_team
{
public:
  std::vector<Bytes> run(const std::string&, const std::size_t number_of_tasks, const Task& task) override
  {
    std::vector<Bytes> results;
    for (std::size_t i = 0; i < number_of_tasks; ++i)
      results.push_back(task(i));
    return results;
  }
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_TASK_TEAM_H
