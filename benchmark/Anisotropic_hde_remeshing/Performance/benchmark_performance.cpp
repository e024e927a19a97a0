// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Time, memory and quality of the whole method beside CGAL's isotropic_remeshing, which has neither an implicit surface nor
// anisotropy, on the same input to about as many faces, in the same run:
//
//   benchmark_performance [--output DIRECTORY] [--sections cases,million,growth,threads] [--largest FACES]
//                         MESH:FACES:SIGMA[:ASKED]...
//
// SIGMA is a fraction of the diagonal D, ASKED the ratio of the times that is asked for. The first mesh also serves the other
// sections: `million` and `growth` resample it to a million faces, and from 20,000 to `--largest`, and halve these; `threads`
// compares one and two threads. The tables are printed, and written to DIRECTORY as CSV.

#include "Measurement.h"
#include "Table.h"
#include "exact_surfaces.h"
#include "scans.h"
#include "threads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace shapes;

struct Options
{
  std::string output;
  std::string sections = "cases,million,growth,threads";
  double largest = 2e6;
  std::vector<std::string> meshes;

  bool wants(const std::string& section) const { return ("," + sections + ",").find("," + section + ",") != std::string::npos; }
};

Options parse(const std::vector<std::string>& arguments)
{
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const bool has_value = i + 1 < arguments.size();
    if (arguments[i] == "--output" && has_value)
      options.output = arguments[++i];
    else if (arguments[i] == "--sections" && has_value)
      options.sections = arguments[++i];
    else if (arguments[i] == "--largest" && has_value)
      options.largest = std::stod(arguments[++i]);
    else
      options.meshes.push_back(arguments[i]);
  }
  if (options.meshes.empty() || options.meshes[0][0] == '-')
    throw std::invalid_argument("usage: benchmark_performance [--output DIRECTORY] [--sections cases,million,growth,threads] "
                                "[--largest FACES] MESH:FACES:SIGMA[:ASKED]...");
  return options;
}

struct Asked_case : Case
{
  std::string ratio; // asked for
};

Asked_case read_case(const std::string& argument)
{
  std::istringstream fields(argument);
  std::string file, faces, sigma;
  Asked_case c;
  std::getline(fields, file, ':');
  std::getline(fields, faces, ':');
  std::getline(fields, sigma, ':');
  std::getline(fields, c.ratio);
  c.name = file.substr(file.find_last_of('/') + 1);
  c.input = read_scan(file);
  c.number_of_target_faces = std::stoul(faces);
  c.relative_sigma = std::stod(sigma);
  return c;
}

void add_header(Table& table)
{
  table.add("input", "faces", "result", "sigma/D", "function [s]", "remeshing [s]", "isotropic [s]", "its faces", "ratio",
            "asked", "memory [MB]", "its memory", "KB a face", "lengths in [.7;1.41]", "mean angle", "rms/D", "its rms/D",
            "folds");
}

// memory a face of input and result
void add(Table& table, const Case& c, const Measurement& m, const std::string& asked)
{
  table.add(c.name, c.input.number_of_faces(), m.number_of_faces, c.relative_sigma, m.function_seconds, m.remeshing_seconds,
            m.isotropic_seconds, m.isotropic_faces, m.ratio(), asked, m.megabytes, m.isotropic_megabytes,
            1000 * m.megabytes / double(c.input.number_of_faces() + m.number_of_faces),
            text(100 * m.embedding.share_within_sqrt_2) + "%", m.embedding.minimum_angle_mean, m.relative_rms, m.isotropic_rms,
            m.embedding.number_of_folded_faces);
  std::cerr << '.' << std::flush; // it goes on
}

void finish(const Table& table, const Options& options, const std::string& name)
{
  std::cerr << '\n';
  table.print();
  if (!options.output.empty())
    table.write_csv(options.output + "/" + name + ".csv");
}

void run_cases(const Options& options)
{
  static constexpr int number_of_runs = 5;
  Table table("Cases: medians of 5 runs");
  add_header(table);
  for (const std::string& argument : options.meshes)
  {
    const Asked_case c = read_case(argument);
    const double length = isotropic_length(c.input, c.number_of_target_faces);
    add(table, c, measure(c, length, number_of_runs, [&] { return Rbf_function(c.input); }), c.ratio);
  }
  Case c;
  c.name = "ellipsoid; own function";
  c.input = ellipsoid(6);
  c.number_of_target_faces = 9996;
  c.relative_sigma = 0.15;
  const double length = isotropic_length(c.input, c.number_of_target_faces);
  add(table, c, measure(c, length, number_of_runs, [] { return Ellipsoid_function(); }), "0.7");
  finish(table, options, "cases");
}

// The length is right for the first and a good guess for the others: it depends on the size little.
class Resampled_scans
{
public:
  explicit Resampled_scans(const Mesh& scan) : m_scan(scan), m_function(scan) {}

  Measurement measure_half(const std::size_t number_of_faces, Case& c)
  {
    c.name = "resampled";
    c.input = resampled_scan(m_scan, m_function, number_of_faces);
    c.number_of_target_faces = c.input.number_of_faces() / 2;
    const double length = m_factor * length_of_edges(c.input, c.number_of_target_faces);
    const Measurement m = measure(c, length, 1, [&] { return Rbf_function(c.input); });
    m_factor *= std::sqrt(double(m.isotropic_faces) / double(c.number_of_target_faces));
    return m;
  }

  void calibrate(const std::size_t number_of_faces)
  {
    const Mesh mesh = resampled_scan(m_scan, m_function, number_of_faces);
    m_factor = isotropic_length(mesh, number_of_faces / 2) / length_of_edges(mesh, number_of_faces / 2);
  }

private:
  const Mesh& m_scan;
  const Rbf_function m_function;
  double m_factor = 1;
};

void run_million(const Options& options, const Mesh& scan)
{
  Resampled_scans scans(scan);
  scans.calibrate(60000);
  Table table("A million faces to half of them; 1.0 KB a face asked");
  add_header(table);
  Case c;
  const Measurement m = scans.measure_half(1000000, c);
  add(table, c, m, "0.9");
  finish(table, options, "million");
}

void run_growth(const Options& options, const Mesh& scan)
{
  Resampled_scans scans(scan);
  scans.calibrate(20000);
  Table table("Growth: time and memory a face of input and result, halved from 20000 faces on");
  table.add("faces", "result", "us a face", "isotropic [us]", "ratio", "KB a face", "isotropic [KB]", "rms/D",
            "isotropic rms/D");
  double least = 1e300, largest = 0;
  for (double size = 20000; size <= options.largest * 1.01; size *= std::sqrt(10.))
  {
    Case c;
    const Measurement m = scans.measure_half(std::size_t(size), c);
    const double faces = double(c.input.number_of_faces() + m.number_of_faces);
    const double time = 1e6 * m.seconds() / faces;
    least = (std::min)(least, time);
    largest = (std::max)(largest, time);
    table.add(c.input.number_of_faces(), m.number_of_faces, time,
              1e6 * m.isotropic_seconds / double(c.input.number_of_faces() + m.isotropic_faces), m.ratio(),
              1000 * m.megabytes / faces, 1000 * m.isotropic_megabytes / faces, m.relative_rms, m.isotropic_rms);
    std::cerr << '.' << std::flush;
  }
  finish(table, options, "growth");
  std::cout << "  largest over least time a face: " << text(largest / least) << "; asked 1.3" << std::endl;
}

int main(int argc, char* argv[])
{
  try
  {
    const Options options = parse(std::vector<std::string>(argv + 1, argv + argc));
    if (options.wants("cases"))
      run_cases(options);
    const Asked_case first = read_case(options.meshes.front());
    if (options.wants("threads"))
      finish(threads_table(first), options, "threads");
    if (options.wants("million"))
      run_million(options, first.input);
    if (options.wants("growth"))
      run_growth(options, first.input);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
