// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CHECKPOINTED_TEAM_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CHECKPOINTED_TEAM_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_store.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Task_team.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Notes in the store what each task has returned, when all that it puts there is there. A run that is begun again with the same store
// does only what is not done yet.
class Checkpointed_team : public Task_team
{
public:
  Checkpointed_team(Task_team& team, Piece_store& store) : m_team(team), m_store(store) {}

  std::vector<Bytes> run(const std::string& step, const std::size_t number_of_tasks, const Task& task) override
  {
    return m_team.run(step, number_of_tasks,
                      [&](const std::size_t i)
                      {
                        const std::string key = "done/" + step + "/" + std::to_string(i);
                        if (m_store.has(key))
                        {
                          ++m_number_of_resumed;
                          return m_store.get(key);
                        }
                        const Bytes result = task(i);
                        m_store.put(key, result);
                        return result;
                      });
  }

  // tasks that had been done before
  std::size_t number_of_resumed() const { return m_number_of_resumed; }

private:
  Task_team& m_team;
  Piece_store& m_store;
  std::size_t m_number_of_resumed = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CHECKPOINTED_TEAM_H
