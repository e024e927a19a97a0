#!/bin/bash
# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# Each call of SOURCE that ends with a message in a comment must be one error with this message, and nothing else an error.
#   test_wrong_types.sh SOURCE COMMAND..., which compiles it

if [ $# -lt 2 ] || [ ! -f "$1" ]; then
  echo "usage: $0 SOURCE COMMAND..." >&2
  exit 2
fi
source=$1
shift
folder=$(mktemp -d) || exit 2
trap 'rm -rf "$folder"' EXIT

if LC_ALL=C "$@" >"$folder/output" 2>&1; then
  echo "it compiles: $source"
  exit 1
fi
grep ': error: ' "$folder/output" | sed 's/.*: error: //' >"$folder/errors"
sed -n 's/.*; \/\/ //p' "$source" >"$folder/messages"
failed=0
while IFS= read -r message; do
  # the first error with this message, which is then crossed out
  line=$(grep -nF -m1 -- "$message" "$folder/errors" | cut -d: -f1)
  if [ -z "$line" ]; then
    echo "no error says: $message"
    failed=$((failed + 1))
  else
    sed -i "${line}d" "$folder/errors"
  fi
done < <(awk '{ print length($0) "\t" $0 }' "$folder/messages" | sort -rn | cut -f2-) # longer ones first: one may begin another
while IFS= read -r error; do
  echo "an error too many: $error"
  failed=$((failed + 1))
done <"$folder/errors"
echo "$(wc -l <"$folder/messages") wrong calls, $failed failures"
[ "$failed" -eq 0 ] && [ -s "$folder/messages" ]
