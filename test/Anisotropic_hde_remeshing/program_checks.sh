# shellcheck shell=bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Checks of a program, for the tests beside this file, which source it with `program` set: in a folder of their own, which is removed in
# the end.

folder=$(mktemp -d) || exit 2
trap 'chmod -R u+w "$folder"; rm -rf "$folder"' EXIT
cd "$folder" || exit 2
passed=0
failed=0

# check NAME COMMAND...: counts whether the command succeeds
check() {
  local name=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "failed: $name: $*"
    sed 's/^/    /' stderr 2>/dev/null | head -5
  fi
}

# run STATUS ARGUMENTS...: runs the program, its output in stdout and stderr, and compares the exit status
run() {
  local expected=$1
  shift
  "$program" "$@" >stdout 2>stderr
  local status=$?
  [ $status -eq "$expected" ] && return 0
  echo "exit status $status instead of $expected: hde_remesh $*"
  return 1
}

says() { grep -qF -- "$1" stderr; }

# summary: the last command of a test, whose status is that of the test
summary() {
  echo "$passed passed, $failed failed"
  [ $failed -eq 0 ]
}
