// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The package for meshes that no memory holds: on one machine or many, in pieces. See options.cpp, or --help.

#include "Ply_output.h"
#include "Ply_shares.h"
#include "options.h"

#include "../hde_remesh/Failure.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Checkpointed_team.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Joined_numbers.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Mpi_team.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Pieces_remesher.h>

#include <boost/mpi/environment.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

#include <sys/resource.h>

namespace hde_remesh {

namespace {

namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

constexpr std::uint64_t faces_of_share = 1000000;

// of this process, in bytes
double peak_memory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * double(usage.ru_maxrss);
}

double processor_seconds()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) + 1e-6 * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

// Tells on rank 0 which step has begun, and how many tasks it has. Measures the processor time of this rank in tasks: while it waits
// for others, MPI keeps the processor busy.
class Telling_team : public internal::Task_team
{
public:
  Telling_team(internal::Task_team& team, const bool speaks) : m_team(team), m_speaks(speaks) { m_timer.start(); }

  std::vector<internal::Bytes> run(const std::string& step, const std::size_t number_of_tasks, const Task& task) override
  {
    if (m_speaks)
      std::cerr << "hde_remesh_mpi: " << std::lround(m_timer.time()) << " s: " << step << ", " << number_of_tasks << " tasks"
                << std::endl;
    return m_team.run(step, number_of_tasks,
                      [&](const std::size_t i)
                      {
                        const double before = processor_seconds();
                        internal::Bytes result = task(i);
                        m_seconds_in_tasks += processor_seconds() - before;
                        return result;
                      });
  }

  double seconds_in_tasks() const { return m_seconds_in_tasks; }

private:
  internal::Task_team& m_team;
  const bool m_speaks;
  CGAL::Real_timer m_timer;
  double m_seconds_in_tasks = 0;
};

void print_round(const char* name, const std::size_t number, const internal::Region_report& report)
{
  std::printf("%-10s %8zu %14llu %14llu %10llu %12.1f %12.1f\n", name, number,
              static_cast<unsigned long long>(report.number_of_faces_before),
              static_cast<unsigned long long>(report.number_of_faces),
              static_cast<unsigned long long>(report.number_of_cells_built), report.function_seconds, report.remeshing_seconds);
}

void print_table(const internal::Pieces_result& result, const std::vector<double>& memory, const std::vector<double>& seconds,
                 const double bytes_sent, const double bytes_of_files)
{
  std::printf("%-10s %8s %14s %14s %10s %12s %12s\n", "round", "regions", "faces before", "after", "functions", "seconds for",
              "remeshing");
  print_round("pieces", result.number_of_pieces, result.of_pieces);
  print_round("bands", result.number_of_bands, result.of_bands);
  print_round("corners", result.number_of_corners, result.of_corners);
  const auto print_topology = [](const char* name, const internal::Joint_topology& t)
  {
    std::printf("%-7s %llu vertices, %llu faces, %llu components, %llu boundary loops, Euler characteristic %lld\n", name,
                static_cast<unsigned long long>(t.number_of_vertices), static_cast<unsigned long long>(t.number_of_faces),
                static_cast<unsigned long long>(t.number_of_components),
                static_cast<unsigned long long>(t.number_of_boundary_loops), static_cast<long long>(t.euler_characteristic));
  };
  print_topology("input:", result.before);
  print_topology("result:", result.after);
  std::printf("sigma %g, 6D length of edges %g, %zu cells\n", result.sigma, result.target_edge_length, result.number_of_cells);
  double sum = 0;
  for (const double s : seconds)
    sum += s;
  std::printf(
      "ranks: %zu, at most %.2f GB of memory, processor time in tasks %.1f s, imbalance %.2f; %.3g MB in messages, %.3g MB in "
      "files\n",
      memory.size(), *std::max_element(memory.begin(), memory.end()) * 1e-9, sum,
      *std::max_element(seconds.begin(), seconds.end()) * double(seconds.size()) / sum, bytes_sent * 1e-6,
      bytes_of_files * 1e-6);
}

// A folder of the caller's is kept, and must be of the same run.
class Run_folder
{
public:
  Run_folder(const Options& options, const boost::mpi::communicator& world)
    : m_is_kept(!options.folder.empty()), m_is_owner(world.rank() == 0)
  {
    const std::filesystem::path output(options.output);
    m_path = m_is_kept ? std::filesystem::path(options.folder)
                       : output.parent_path() / ("." + output.filename().string() + ".pieces");
    std::string problem;
    if (m_is_owner)
      try
      {
        begin(options);
      }
      catch (const std::exception& error)
      {
        problem = error.what();
      }
    boost::mpi::broadcast(world, problem, 0);
    if (!problem.empty())
      throw Failure(problem);
  }

  // No rank is at a task any more, as all have the results of the last step, or have failed in the same one.
  ~Run_folder()
  {
    std::error_code ignored;
    if (m_is_owner && !m_is_kept)
      std::filesystem::remove_all(m_path, ignored);
  }
  Run_folder(const Run_folder&) = delete;
  Run_folder& operator=(const Run_folder&) = delete;

  const std::filesystem::path& path() const { return m_path; }

private:
  void begin(const Options& options) const
  {
    if (!m_is_kept)
      std::filesystem::remove_all(m_path); // of a run that was killed
    internal::Folder_store store(m_path);
    const std::string text = description_of(options);
    const internal::Bytes bytes(text.begin(), text.end());
    if (store.has("run") && store.get("run") != bytes)
    {
      const internal::Bytes other = store.get("run");
      throw Failure("the folder " + in_quotes(m_path.string()) +
                    " has the pieces of another run: " + std::string(other.begin(), other.end()));
    }
    if (!store.has("run") && !std::filesystem::is_empty(m_path))
      throw Failure("the folder " + in_quotes(m_path.string()) + " is not empty and has no pieces of a run");
    store.put("run", bytes);
  }

  std::filesystem::path m_path;
  const bool m_is_kept, m_is_owner;
};

void write(const std::string& file_name, const internal::Pieces_result& result, const internal::Piece_store& store,
           internal::Task_team& team)
{
  const internal::Joined_numbers numbers(result.counts);
  const Ply_output output(file_name, numbers.number_of_vertices(), numbers.number_of_faces());
  const auto by_one = [&](const char* step, const auto& task)
  {
    team.run(step, 1,
             [&](std::size_t)
             {
               task();
               return internal::Bytes();
             });
  };
  try
  {
    by_one("begin_file", [&] { output.begin(); });
    team.run("write_file", result.holders.size(),
             [&](const std::size_t i)
             {
               output.write(numbers.part(i, internal::from_bytes<internal::Piece_faces>(store.get(result.holders[i]))));
               return internal::Bytes();
             });
    by_one("finish_file", [&] { output.finish(); });
  }
  catch (...)
  {
    output.abandon();
    throw;
  }
}

void check_result(const internal::Joint_topology& before, const internal::Joint_topology& after)
{
  if (!after.is_joined || after.number_of_components != before.number_of_components ||
      after.number_of_boundary_loops != before.number_of_boundary_loops ||
      after.euler_characteristic != before.euler_characteristic)
    throw Failure("the pieces do not fit together any more, which is an error of this program; nothing was written");
}

void run(const Options& options, const boost::mpi::communicator& world)
{
  const bool speaks = world.rank() == 0 && !options.is_quiet;
  if (std::filesystem::path(options.output).extension() != ".ply")
    throw Failure("OUT is " + in_quotes(options.output) + ": only .ply files can be written");
  internal::Mpi_team ranks(world);
  std::optional<Ply_shares> input;
  ranks.run("open", std::size_t(world.size()), // each rank has one task
            [&](const std::size_t i)
            {
              input.emplace(options.input, faces_of_share);
              if (i == 0)
                Ply_output::check(options.output);
              return internal::Bytes();
            });
  const Run_folder folder(options, world);
  internal::Folder_store store(folder.path());
  Telling_team telling(ranks, speaks);
  internal::Checkpointed_team team(telling, store);

  internal::Pieces_request request;
  request.sigma = options.absolute_sigma;
  request.relative_sigma = options.sigma;
  request.target_edge_length = options.length;
  request.number_of_target_faces = options.number_of_faces;
  request.faces_of_piece = options.faces_of_piece;
  request.faces_of_cell = options.faces_of_cell;
  request.memory_of_functions = options.memory / 2;
  typedef CGAL::Parallel_if_available_tag Concurrency_tag;
  const auto np = params::number_of_iterations(10);
  const auto np_of_function = params::close_holes(false);
  internal::Pieces_remesher<Concurrency_tag, std::decay_t<decltype(np)>, std::decay_t<decltype(np_of_function)>> remesher(
      *input, team, store, request, np, np_of_function);
  const internal::Pieces_result result = remesher();
  check_result(result.before, result.after);
  write(options.output, result, store, telling);

  const double figures[] = {peak_memory(), telling.seconds_in_tasks(), double(ranks.bytes_sent()),
                            double(store.bytes_put() + store.bytes_got())};
  std::vector<double> all;
  boost::mpi::all_gather(world, figures, 4, all);
  if (!speaks)
    return;
  std::vector<double> memory, seconds;
  double bytes_sent = 0, bytes_of_files = 0;
  for (std::size_t rank = 0; rank < std::size_t(world.size()); ++rank)
  {
    memory.push_back(all[4 * rank]);
    seconds.push_back(all[4 * rank + 1]);
    bytes_sent += all[4 * rank + 2];
    bytes_of_files += all[4 * rank + 3];
  }
  print_table(result, memory, seconds, bytes_sent, bytes_of_files);
}

} // namespace

} // namespace hde_remesh

int main(int argc, char** argv)
{
  using namespace hde_remesh;
  namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
  const boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled, false);
  const boost::mpi::communicator world;
  Options options;
  const int status = parse(argc, argv, world.rank() == 0, options);
  if (status >= 0)
    return status;
#ifdef CGAL_LINKED_WITH_TBB
  std::unique_ptr<tbb::global_control> limit;
  if (options.threads > 0)
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
#endif
  // What fails in a task fails on all ranks in the same step, with the same message. Rank 0 tells it.
  std::string problem;
  try
  {
    run(options, world);
  }
  catch (const std::bad_alloc&) // between two steps, where the others wait for this rank
  {
    std::cerr << "hde_remesh_mpi: there is not enough memory on rank " << world.rank() << "; smaller pieces need less"
              << std::endl;
    environment.abort(STATUS_FAILURE);
  }
  catch (const internal::Failed_step& failed)
  {
    problem = failed.what();
    world.barrier(); // mpirun ends all ranks when the first of them fails, but rank 0 removes files
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  if (problem.empty())
    return STATUS_SUCCESS;
  if (world.rank() == 0)
    std::cerr << "hde_remesh_mpi: " << problem << std::endl;
  return STATUS_FAILURE;
}
