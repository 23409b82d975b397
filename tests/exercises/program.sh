#!/bin/sh
# The program as a shell runs it: what only a process has, its standard streams, its exit code and its locale.
#   sh program.sh PATH/TO/epure
set -u
epure=$1
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
cd "$place" || exit 1
failures=0

expect() { # expect WHAT EXPECTED ACTUAL
  if [ "$2" != "$3" ]; then
    printf 'FAILED: %s\n  expected: %s\n  actual:   %s\n' "$1" "$2" "$3"
    failures=$((failures + 1))
  fi
}

first=$("$epure" list | sed -n '1s/ .*//p')
[ -n "$first" ] || { echo 'FAILED: list shows no exercise'; exit 1; }

for arguments in "list" "list $first" "check $first" "check $first --json" "draw $first -o -" "--help" "--version"; do
  # shellcheck disable=SC2086  # a list of words
  "$epure" $arguments > /dev/full 2> said
  expect "a full standard output is exit 3: $arguments" 3 $?
  expect "and said in one line: $arguments" 1 "$(grep -c '^epure: ' said)"
  # shellcheck disable=SC2086
  "$epure" $arguments >&- 2> said
  expect "a closed standard output is exit 3: $arguments" 3 $?
done
expect 'no file is left behind' said "$(ls)"

"$epure" draw "$first" -o - 2> said | head -c 5 > head
expect 'a reader that has enough gets what it reads' '%PDF-' "$(cat head)"
expect 'and nobody complains' '' "$(cat said)"

"$epure" draw "$first" --out one > written
expect 'drawing exits with 0' 0 $?
expect 'every file named is there' '' "$(while read -r file; do [ -s "$file" ] || echo "$file"; done < written)"
expect 'every file there is named' "$(sort written)" "$(find one -type f | sort)"
LC_ALL=it_IT.UTF-8 "$epure" draw "$first" --out two > /dev/null
expect 'two runs write the same bytes, whatever the locale' '' "$(diff -r one two 2>&1)"

"$epure" draw all --out all_one > /dev/null
expect 'drawing all exits with 0' 0 $?
"$epure" draw all --out all_two > /dev/null
expect 'drawing all, on all processors, writes the same bytes again' '' "$(diff -r all_one all_two 2>&1)"

# Loading FLINT takes a tenth of a sheet's time: where the program can load it late, ordinary sheets do without.
if ! ldd "$epure" | grep -q flint; then
  for sheet in cycloid-involute/cycloid four-bar/poles four-bar-analytic/configurations four-bar-constraints/iterations \
    pin-in-slot/kinematics rivals-polygons/velocity-of-B roulette/path slider-crank-acceleration/polar-diagram \
    slider-crank-velocity/poles velocity-centre/velocities; do
    LD_DEBUG=files "$epure" draw "$sheet" --out late > /dev/null 2> said
    expect "$sheet is drawn without FLINT" 0 "$(grep -c 'calling init:.*flint' said)"
  done
  LD_DEBUG=files "$epure" check "$first" > /dev/null 2> said
  expect 'and FLINT is loaded where it is needed' 1 "$(grep -c 'calling init:.*libflint[.]so' said)"
fi

"$epure" check "$first" --json > report
expect 'checking exits with 0' 0 $?
LC_ALL=it_IT.UTF-8 "$epure" check "$first" --json > report2
expect 'the report is the same in every locale' '' "$(cmp report report2 2>&1)"

"$epure" draw "$first" -o - > straight
ln -s /dev/stdout link.pdf
ln -s link.pdf link_to_link.pdf
for name in /dev/stdout /dev/fd/1 /proc/self/fd/1 /proc/self/../self/fd/1 link.pdf link_to_link.pdf; do
  printf 'keep' > kept
  "$epure" draw "$first" --format pdf -o "$name" >> kept
  expect "$name is standard output" 0 $?
  { printf 'keep'; cat straight; } > expected
  expect "all that is written to $name is the drawing, behind what was there" '' "$(cmp kept expected 2>&1)"
done
expect 'a link to standard output stays one' '/dev/stdout' "$(readlink link.pdf)"

# 80 MB are not enough to draw; where the sanitisers take more than that to start, nothing can be said.
if prlimit --as=83886080 "$epure" --version > /dev/null 2>&1; then
  prlimit --as=83886080 "$epure" draw "$first" --out none > said 2>&1
  expect 'want of room is exit 3' 3 $?
  expect 'and said in one line' 1 "$(grep -c '^epure: ' said)"
  expect 'and nothing is written' '' "$(ls none 2> /dev/null)"
fi

EPURE_LANG=it "$epure" list > italian
"$epure" list --lang it | cmp - italian
expect 'EPURE_LANG stands for --lang' 0 $?
LC_ALL=it_IT.UTF-8 LANG=it_IT.UTF-8 LANGUAGE=it "$epure" list > list_there
"$epure" list | cmp - list_there
expect 'the locale chooses no language' 0 $?

on_terminal() { # on_terminal VARIABLE=VALUE...: how many lines of a check are coloured
  env "$@" script -qec "$epure check $first" /dev/null | grep -c "$(printf '\033')"
}
expect 'no colour in a pipe' 0 "$(TERM=xterm "$epure" check "$first" | grep -c "$(printf '\033')")"
[ "$(on_terminal TERM=xterm NO_COLOR=)" -gt 0 ]
expect 'colours on a terminal' 0 $?
expect 'NO_COLOR is respected' 0 "$(on_terminal TERM=xterm NO_COLOR=1)"
expect 'a dumb terminal gets no colours' 0 "$(on_terminal TERM=dumb)"

[ "$failures" -eq 0 ] && echo 'the program does what it says'
[ "$failures" -eq 0 ]
