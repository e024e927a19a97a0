// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Runs hde_remesh in a process of its own, and reads the JSON that it writes.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_PROGRAM_RUN_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_PROGRAM_RUN_H

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Program_run
{
  int status = -1; // that of the shell: 128 and more for signals
  double seconds = 0, megabytes = 0;
  nlohmann::json json;      // none if the program failed
  std::string last_message; // of standard error
};

inline std::string text_of_file(const std::string& name)
{
  std::ifstream in(name);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline std::string last_line(std::string text)
{
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  return text.substr(text.find_last_of('\n') + 1);
}

// with standard output and error in two files
inline void execute(const std::vector<std::string>& arguments, const std::string& output, const std::string& error)
{
  const int out = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const int err = open(error.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  std::vector<char*> pointers;
  for (const std::string& argument : arguments)
    pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  if (out >= 0 && err >= 0 && dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0)
    execv(pointers[0], pointers.data());
  _exit(127);
}

// The program is stopped after some seconds.
inline Program_run run_program(std::vector<std::string> arguments, const std::string& folder, const unsigned int limit)
{
  const std::string output = folder + "/stdout", error = folder + "/stderr", json = folder + "/figures.json";
  std::ofstream(json) << "";
  arguments.insert(arguments.end(), {"--json", json, "--self-intersections"});
  const auto began = std::chrono::steady_clock::now();
  const pid_t process = fork();
  if (process < 0)
    throw std::runtime_error("cannot start a process");
  if (process == 0)
  {
    alarm(limit); // it survives what follows
    execute(arguments, output, error);
  }
  int status = 0;
  rusage usage;
  if (wait4(process, &status, 0, &usage) != process)
    throw std::runtime_error("cannot wait for a process");
  Program_run run;
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  run.megabytes = double(usage.ru_maxrss) * 1024 / 1e6;
  run.last_message = last_line(text_of_file(error));
  if (run.status == 0)
  {
    run.json = nlohmann::json::parse(text_of_file(json));
    run.seconds = 0;
    for (const auto& stage : run.json["seconds"].items()) // what the user needs, without what the benchmark does
      run.seconds += stage.key() == "measuring" ? 0. : stage.value().get<double>();
  }
  return run;
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_PROGRAM_RUN_H
