#!/bin/sh
# The version, which CMakeLists.txt states, in the files that repeat it.
#   sh versions.sh SOURCE_FOLDER VERSION PATH/TO/epure
set -u
source=$1 version=$2 epure=$3
failures=0
fail() {
  printf 'FAILED: %s\n' "$*"
  failures=$((failures + 1))
}

grep -qxF "version: $version" "$source/CITATION.cff" || fail "CITATION.cff is not of $version"
[ "$(sed -n 's/^## \([^ ]*\).*/\1/p' "$source/CHANGELOG.md" | head -n 1)" = "$version" ] ||
  fail "CHANGELOG.md does not begin with $version"
[ "$("$epure" --version | head -n 1)" = "epure $version" ] || fail 'the program says another version'
for library in FLINT GMP MPFR CGAL Eigen Boost Cairo HarfBuzz fmt CLI11 nlohmann-json; do
  "$epure" --version | grep -q "$library"'[^0-9a-z]*[0-9][0-9]*\.[0-9]' || fail "no version of $library"
done

[ "$failures" -eq 0 ] && echo 'one version everywhere'
[ "$failures" -eq 0 ]
