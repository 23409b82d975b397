#!/bin/sh
# A program of one's own that uses the library, from an installed prefix that was moved since: by find_package and by
# pkg-config. Expected numbers: the same linkage in mpmath, 50 digits (intersection of the two bars' lines).
#   sh library.sh CMAKE BUILD_FOLDER EXAMPLE_FOLDER C++_COMPILER
set -u
cmake=$1 build=$2 example=$3 compiler=$4
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
failures=0

expect() { # expect WHAT EXPECTED ACTUAL
  if [ "$2" != "$3" ]; then
    printf 'FAILED: %s\n  expected: %s\n  actual:   %s\n' "$1" "$2" "$3"
    failures=$((failures + 1))
  fi
}
must() { # must WHAT COMMAND...: out of sight unless it fails
  what=$1
  shift
  "$@" > "$place/said" 2>&1 && return
  printf 'FAILED: %s\n' "$what"
  cat "$place/said"
  exit 1
}

try() { # try WHAT PROGRAM
  expect "$1: the pole at 60 degrees" '0.7863096460351342 1.3619282574143523' \
    "$("$2" | sed 's/.* = \([^ ]*\) m, proved.*/\1/' | paste -s -d ' ')"
  expect "$1: bounds that are proved" 2 "$("$2" | grep -c 'proved between .* and .* (Deep')"
  expect "$1: a pole at infinity is proved" 'P0_x: none, crank and rocker are parallel (Exact)' "$("$2" 90deg | head -n 1)"
  "$2" 90m > /dev/null 2> "$place/said"
  expect "$1: a wrong unit is refused" 2 $?
  expect "$1: and said in one line" 1 "$(grep -c '^pole: ' "$place/said")"
}

must 'installing the library' "$cmake" --install "$build" --component library --prefix "$place/before"
mv "$place/before" "$place/prefix"
expect 'nothing installed knows where it was built' '' "$(grep -rlF -e "$build" -e "$place/before" \
  --include='*.cmake' --include='*.pc' --include='*.h' "$place/prefix")"

must 'find_package' "$cmake" -G Ninja -S "$example" -B "$place/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$place/prefix" \
  -DCMAKE_CXX_COMPILER="$compiler"
must 'building by find_package' "$cmake" --build "$place/build"
try find_package "$place/build/pole"
options=$(grep -rhe '^CXX_FLAGS' -e '^  FLAGS' "$place/build" --include=flags.make --include=build.ninja)
case $options in
  *-frounding-math*) ;;
  *) expect 'find_package brings the option that intervals need' '-frounding-math' "$options" ;;
esac

PKG_CONFIG_PATH=$(dirname "$(find "$place/prefix" -name epure.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046  # a list of words
must 'building by pkg-config' "$compiler" -O0 "$example/pole.cpp" -o "$place/pole" $(pkg-config --cflags --libs epure)
try pkg-config "$place/pole"
case $(pkg-config --cflags epure) in
  *-frounding-math*) ;;
  *) expect 'pkg-config brings the option that intervals need' '-frounding-math' "$(pkg-config --cflags epure)" ;;
esac

[ "$failures" -eq 0 ] && echo 'the library is one that others can use'
[ "$failures" -eq 0 ]
