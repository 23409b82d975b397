#!/bin/sh
# list_flint_names.sh NM OUTPUT FLINT_LIBRARY... -- OUR_LIBRARY...
# Writes a line LATE(name) for each function of FLINT that our libraries call; late_flint.c has flint_cleanup itself.
set -eu
nm=$1 output=$2
shift 2
mkdir -p "$(dirname -- "$output")"
while [ "$1" != -- ]; do
  "$nm" -D --defined-only "$1"
  shift
done | sed -n 's/.* [Ti] \([A-Za-z0-9_]*\).*/\1/p' | sort -u > "$output.theirs"
shift
"$nm" -u "$@" 2> /dev/null | sed -n 's/^ *U \([A-Za-z0-9_]*\)$/\1/p' | sort -u | grep -vxF flint_cleanup |
  grep -xFf "$output.theirs" | sed 's/.*/LATE(&)/' > "$output.new"
rm "$output.theirs"
mv "$output.new" "$output"
