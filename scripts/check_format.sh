#!/usr/bin/env bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Fails if clang-format would change a source file, and says where. Usage: scripts/check_format.sh [--fix]
# Other versions than 14, that of Debian 12, format otherwise: without it the exit status is 77, for a test that is skipped.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

program=$(command -v clang-format-14 || command -v clang-format || true)
if [[ -z $program ]] || ! "$program" --version | grep -q 'version 14\.'; then
  found=${program:+; this is $("$program" --version)}
  echo "The format is not checked: that takes clang-format 14, which Debian 12 has${found}" >&2
  exit 77
fi
how=(--dry-run -Werror)
[[ ${1:-} != --fix ]] || how=(-i)
find include examples test benchmark doc -name '*.h' -print0 -o -name '*.cpp' -print0 | xargs -0 "$program" "${how[@]}"
