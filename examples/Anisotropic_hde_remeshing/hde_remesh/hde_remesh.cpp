// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// hde_remesh IN OUT: the package as a program. `hde_remesh --help` says what it does.

#include "Element_figures.h"
#include "Failure.h"
#include "Format.h"
#include "Report.h"
#include "Stopwatch.h"
#include "Whole_file.h"
#include "describe.h"
#include "help.h"
#include "measure.h"
#include "mesh_file.h"
#include "mesh_of_points.h"
#include "options.h"
#include "progress.h"
#include "read_mesh.h"
#include "remesh.h"
#include "report_page.h"
#include "signals.h"

#include <CGAL/assertions_behaviour.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace hde_remesh {

namespace {

void tell(const Options& options, const char* kind, const std::string& text)
{
  if (!options.quiet)
    std::cerr << "hde_remesh: " << kind << ": " << text << std::endl;
}

void note(const Options& options, const std::string& text) { tell(options, "note", text); }
void warn(const Options& options, const std::string& text) { tell(options, "warning", text); }

// that a file which an option names, if it does, can be written and is neither IN nor OUT
void check_file_beside(const char* option, const std::string& name, const Options& options)
{
  if (name.empty())
    return;
  if (name == options.input || name == options.output)
    throw Failure(std::string(option) + " names the file " + in_quotes(name) + ", which is IN or OUT", STATUS_USAGE);
  const Whole_file file(name);
}

// all that can be known to go wrong before the long computation
void check_files(const Options& options)
{
  const Format input = format_of(options.input), output = format_of(options.output);
  if (!is_read(input))
    throw Failure("IN is " + in_quotes(options.input) + ": files of this format are only written");
  if (!is_written(output))
    throw Failure("OUT is " + in_quotes(options.output) + ": files of this format are only read, as they have no faces");
  if (options.arrays && !holds_arrays(output))
    throw Failure("--arrays needs OUT to be a .ply or a .vtp file, not " + in_quotes(options.output), STATUS_USAGE);
  const Whole_file file(options.output);
  check_file_beside("--json", options.json == "-" ? "" : options.json, options);
  check_file_beside("--report", options.report, options);
  if (!options.report.empty() && options.report == options.json)
    throw Failure("--report and --json name the same file " + in_quotes(options.json), STATUS_USAGE);
}

// With V vertices, b of them on boundaries, and the Euler characteristic c, a triangle mesh has 2 V - 2 c - b faces.
// The number of boundary vertices goes with the square root of that of the faces.
std::size_t faces_for_vertices(const long long number_of_vertices, const Hde::Topology_measures& input)
{
  const double least = 4;
  double faces = static_cast<double>(input.number_of_faces);
  for (int i = 0; i < 20; ++i)
  {
    const double boundary =
        static_cast<double>(input.number_of_boundary_edges) * std::sqrt(faces / static_cast<double>(input.number_of_faces));
    faces = 2 * static_cast<double>(number_of_vertices) - 2 * static_cast<double>(input.euler_characteristic) - boundary;
    faces = (std::max)(least, faces);
  }
  return static_cast<std::size_t>(faces);
}

double range_of_field(const Mesh& mesh)
{
  const Field field = *field_of(mesh);
  double least = (std::numeric_limits<double>::max)(), largest = -least;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    least = (std::min)(least, field[v]);
    largest = (std::max)(largest, field[v]);
  }
  if (!(largest > least))
    throw Failure("the field has the value " + std::to_string(largest) + " at all vertices");
  return largest - least;
}

Sizes sizes_of(const Options& options, const Mesh& mesh)
{
  Sizes sizes;
  const double d = diagonal(mesh);
  sizes.sigma = options.absolute_sigma.value_or(options.sigma.value_or(0.01) * d);
  if (options.absolute_error)
    sizes.error = options.absolute_error;
  else if (options.error)
    sizes.error = *options.error * d;
  if (!options.field.empty())
    sizes.tau = options.tau.value_or(0.1) * d / range_of_field(mesh);
  if (options.length)
    sizes.edge_length = options.length;
  else if (options.vertices)
    sizes.number_of_faces = faces_for_vertices(*options.vertices, measure_topology(mesh));
  else if (options.faces || !sizes.error)
    sizes.number_of_faces =
        options.faces ? static_cast<std::size_t>(*options.faces) : static_cast<std::size_t>(mesh.number_of_faces());
  sizes.scheme = scheme_of(sizes, options, mesh);
  return sizes;
}

void check_not_cancelled()
{
  if (is_cancelled())
    throw Failure(cancelled_text(), STATUS_CANCELLED);
}

void write_beside(const std::string& file_name, const std::string& text)
{
  try
  {
    Whole_file(file_name).write([&](std::ostream& stream) { stream << text; });
  }
  catch (const Failure& failure)
  {
    throw Failure(std::string(failure.what()) + " (the mesh is written)");
  }
}

// with colours and other numbers of points, where OUT has a place for them
void write_mesh(const Checked_mesh& input, const Remeshed& remeshed, const Options& options, Report& report, Progress& progress)
{
  static constexpr double cost_of_arrays = 10, cost_of_file = 1; // measured on the bunny
  Steps steps(progress, "writing", {options.arrays ? cost_of_arrays : 0, cost_of_file});
  Soup soup = soup_of_mesh(remeshed.mesh);
  if (options.arrays)
    add_arrays(figures_of_elements(remeshed.mesh, remeshed.function, remeshed.result.sigma, input.mesh), soup);
  if (holds_arrays(format_of(options.output)))
    carry_to(soup, input.points, report);
  else if (!input.points.vertex_arrays.empty())
    report.warnings.push_back("OUT has no place for colours and other numbers of the points: PLY and VTP files have");
  steps.next();
  write_soup(soup, options.output);
  steps.next();
  is_output_written() = 1;
}

void write_page(const Report& report, const Mesh& input, const Remeshed& remeshed, const Options& options, Progress& progress)
{
  const double faces_before = static_cast<double>(input.number_of_faces()),
               faces_after = static_cast<double>(remeshed.mesh.number_of_faces());
  Steps steps(progress, "writing the page", {faces_before, faces_after, 0.5 * (faces_before + faces_after)});
  const double sigma = remeshed.result.sigma;
  const Measured_elements before{input, figures_of_elements(input, remeshed.function, sigma, remeshed.mesh)};
  steps.next();
  const Measured_elements after{remeshed.mesh, figures_of_elements(remeshed.mesh, remeshed.function, sigma, input)};
  steps.next();
  write_beside(options.report, report_page(report, options.command_line, before, after));
  steps.next();
}

void print(const Report& report, const Options& options)
{
  if (options.json == "-")
    std::cout << to_json(report);
  else if (!options.json.empty())
    write_beside(options.json, to_json(report));
  if (!options.quiet && options.json != "-")
    print_table(report, options.details, std::cout);
  if (!std::cout.flush())
    throw Failure("cannot write to the standard output (the mesh is written)");
}

// whether the table is on the terminal that the warnings would be on
bool is_verdict_seen(const Options& options)
{
  return !options.quiet && options.json != "-" && isatty(STDOUT_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
}

void run(const Options& all_options)
{
  Report report;
  Progress progress(!all_options.quiet);
  const auto end_stage = [&](const char* name, const double seconds) { report.stages.emplace_back(name, seconds); };

  check_files(all_options);
  Checked_mesh input = read_mesh(all_options, report, progress);
  const Options options = report.points ? without_noise(all_options) : all_options;
  progress.clear();
  for (const std::string& text : report.notes)
    note(options, text);

  Sizes sizes = sizes_of(options, input.mesh);
  const Remeshed remeshed = remesh(input.mesh, sizes, options, progress);
  check_not_cancelled();
  if (remeshed.function.has_values())
  {
    end_stage("smooth function", remeshed.function_seconds);
    end_stage("projection", remeshed.result.projection_seconds);
  }
  end_stage("remeshing", remeshed.result.remeshing_seconds);

  Stopwatch stopwatch;
  write_mesh(input, remeshed, options, report, progress);
  end_stage("output", remeshed.result.output_seconds + stopwatch.lap());

  if (options.quiet && options.json.empty() && options.report.empty())
    return; // no one would hear of it
  describe(options, input, sizes, remeshed, report, progress);
  end_stage("measuring", stopwatch.lap());
  if (!options.report.empty())
    write_page(report, input.mesh, remeshed, options, progress);
  progress.clear();
  if (!is_verdict_seen(options)) // which has them, too
    for (const std::string& warning : report.warnings)
      warn(options, warning);
  print(report, options);
}

#ifdef CGAL_LINKED_WITH_TBB
// as long as it lives, no more threads than asked for
std::optional<tbb::global_control> limit_of_threads(const Options& options)
{
  std::optional<tbb::global_control> limit;
  if (options.threads)
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(*options.threads));
  return limit;
}
#endif

int report_failure(const std::string& message, const int status)
{
  std::string line = message; // in one line, whatever a library has to say
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::cerr << "hde_remesh: " << line << std::endl;
  return status;
}

void be_silent(const char*, const char*, const char*, int, const char*) {}

} // namespace

} // namespace hde_remesh

int main(int argc, char** argv)
{
  using namespace hde_remesh;
  CGAL::set_error_handler(be_silent); // what CGAL throws is reported below, in one line
  CGAL::set_warning_handler(be_silent);
  install_signal_handlers();
  if (argc == 1)
  {
    std::cerr << usage();
    return STATUS_USAGE;
  }
  try
  {
    const std::optional<Options> options = read_command_line(argc, argv);
    if (!options)
      return STATUS_SUCCESS;
#ifdef CGAL_LINKED_WITH_TBB
    const std::optional<tbb::global_control> limit = limit_of_threads(*options);
#else
    if (options->threads)
      note(*options, "built without threads: --threads is ignored");
#endif
    run(*options);
    return STATUS_SUCCESS;
  }
  catch (const Failure& failure)
  {
    return report_failure(failure.what(), failure.status());
  }
  catch (const std::bad_alloc&)
  {
    return report_failure("there is not enough memory", STATUS_FAILURE);
  }
  catch (const std::exception& error)
  {
    return report_failure(error.what(), STATUS_FAILURE);
  }
}
