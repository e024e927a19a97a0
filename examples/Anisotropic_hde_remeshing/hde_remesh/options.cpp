// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "options.h"
#include "Command_line.h"
#include "Failure.h"
#include "Option_list.h"
#include "help.h"
#include "kernels.h"

#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>
#include <utility>

#ifndef HDE_REMESH_VERSION
#  define HDE_REMESH_VERSION "of unknown version" // the build system knows it
#endif

namespace hde_remesh {

namespace {

// `value` as a message shows it
template <typename T>
std::string to_text(const T value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

template <typename T>
void require(const char* name, const std::optional<T>& value, const bool holds, const std::string& what)
{
  if (value && !holds)
    throw Failure(std::string(name) + " must be " + what + ", not " + to_text(*value));
}

void require_count(const char* name, const std::optional<long long>& value, const bool zero_is_fine = false)
{
  const long long least = zero_is_fine ? 0 : 1;
  require(name, value, value && *value >= least, zero_is_fine ? "0 or more" : "1 or more");
}

void require_length(const char* name, const std::optional<double>& value, const bool zero_is_fine = false)
{
  const bool holds = value && std::isfinite(*value) && (zero_is_fine ? *value >= 0 : *value > 0);
  require(name, value, holds, zero_is_fine ? "a finite number, 0 or more" : "a finite number above 0");
}

void require_between(const char* name, const std::optional<double>& value, const double least, const double largest)
{
  require(name, value, value && *value >= least && *value <= largest, "from " + to_text(least) + " to " + to_text(largest));
}

void check_values(const Options& o)
{
  require_length("--sigma", o.sigma, true);
  require_length("--absolute-sigma", o.absolute_sigma, true);
  require("--metric", o.metric, o.metric && *o.metric >= 1, "from 1 to inf");
  require_length("--merge", o.merge);
  require_length("--tau", o.tau, true);
  require("--sharp", o.sharp, o.sharp && *o.sharp > 0 && *o.sharp < 180, "above 0 and below 180 degrees");
  require_length("--error", o.error);
  require_length("--absolute-error", o.absolute_error);
  require_length("--length", o.length);
  require("--aspect-ratio", o.aspect_ratio, o.aspect_ratio && *o.aspect_ratio >= 1.2, "1.2 or more");
  require_length("--shape-weight", o.shape_weight, true);
  require_count("--faces", o.faces);
  require_count("--vertices", o.vertices);
  require_count("--patches", o.patches);
  require_length("--overlap", o.overlap, true);
  require_length("--offset", o.offset);
  require_length("--shape", o.shape);
  require_length("--smoothing", o.smoothing, true);
  require_length("--trim", o.trim);
  require_count("--iterations", o.iterations, true);
  require_count("--relaxation-steps", o.relaxation_steps, true);
  require_between("--smoothing-ratio", o.smoothing_ratio, 0, 1);
  require_between("--collapse-ratio", o.collapse_ratio, 0, 1);
  require_between("--split-ratio", o.split_ratio, 1, 100);
  require_count("--threads", o.threads);
}

// words that a shell would not take as they are in quotes
std::string command_line(const int argc, char** argv)
{
  std::string result = "hde_remesh";
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const bool is_plain = !word.empty() && word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                                                  "0123456789_./,:=+-") == std::string::npos;
    result += ' ';
    if (is_plain)
      result += word;
    else
    {
      result += '\'';
      for (const char c : word)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
      result += '\'';
    }
  }
  return result;
}

} // namespace

bool is_function_asked_for(const Options& o)
{
  return o.kernel != "r3" || o.shape || o.patches || o.overlap || o.offset || o.smoothing || o.automatic_smoothing ||
         o.vertices_only || o.smooth_edges;
}

std::string version_text()
{
  std::string text = "hde_remesh " HDE_REMESH_VERSION ", CGAL " CGAL_VERSION_STR;
#ifdef CGAL_LINKED_WITH_TBB
  text += ", parallel";
#else
  text += ", sequential";
#endif
  return text;
}

namespace {

// options that contradict each other, or one of which needs the other
void check_pairs(const CLI::App& app, const Options& o)
{
  static const std::pair<const char*, const char*> contradictions[] = {
      {"--faces", "--vertices"},       {"--faces", "--length"},         {"--vertices", "--length"},
      {"--error", "--length"},         {"--error", "--absolute-error"}, {"--absolute-error", "--length"},
      {"--sigma", "--absolute-sigma"}, {"--metric", "--sigma"},         {"--metric", "--absolute-sigma"},
      {"--metric", "--length"},        {"--field", "--metric"},         {"--field", "--repair"},
      {"--field", "--merge"}};
  for (const auto& [one, other] : contradictions)
    if (app.count(one) > 0 && app.count(other) > 0)
      throw Failure(std::string(one) + " and " + other + " cannot both be given", STATUS_USAGE);
  if (app.count("--tau") > 0 && app.count("--field") == 0)
    throw Failure("--tau needs --field", STATUS_USAGE);
  if (o.adaptive_sigma && !o.field.empty())
    throw Failure("--field and --sigma auto cannot both be given", STATUS_USAGE);
  if (o.shape && !has_shape(o.kernel))
    throw Failure("--shape and --kernel " + o.kernel + " cannot both be given: that kernel has no shape parameter",
                  STATUS_USAGE);
}

void check_files(const Options& o)
{
  if (o.input.empty() || o.output.empty())
    throw Failure(std::string(o.input.empty() ? "IN and OUT are" : "OUT is") + " missing: hde_remesh IN OUT [OPTIONS]",
                  STATUS_USAGE);
}

} // namespace

std::optional<Options> read_command_line(const int argc, char** argv)
{
  Options o;
  o.command_line = command_line(argc, argv);
  CLI::App app("", "hde_remesh");
  const Option_list list(app, o);
  std::vector<std::string> words = Command_line(app, list).checked(argc, argv);
  std::reverse(words.begin(), words.end()); // as CLI11 wants them
  try
  {
    app.parse(words);
  }
  catch (const CLI::CallForHelp&)
  {
    std::cout << short_help(app);
    return std::nullopt;
  }
  catch (const CLI::CallForAllHelp&)
  {
    std::cout << full_help(app);
    return std::nullopt;
  }
  catch (const CLI::Success& request) // the version
  {
    app.exit(request);
    return std::nullopt;
  }
  catch (const CLI::ParseError& error)
  {
    throw Failure(std::string(error.what()) + " (hde_remesh --help explains)", STATUS_USAGE);
  }
  check_files(o);
  check_pairs(app, o);
  check_values(o);
  return o;
}

} // namespace hde_remesh
