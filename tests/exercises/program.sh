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

printf 'r = 25 cm\n' | "$epure" draw slider-crank-velocity/poles --givens - --format svg -o piped.svg > /dev/null
expect 'givens come from standard input' 0 $?
"$epure" draw slider-crank-velocity/poles --set r=25cm --format svg -o set.svg > /dev/null
expect 'and are those of --set' '' "$(cmp piped.svg set.svg 2>&1)"
rm -f piped.svg set.svg

cat > six-bar.yaml << 'SCENE'
epure: 1
id: six-bar
source: own
links:
  1: {A0: [0, 0], B0: [180 mm, 0], E0: [210 mm, 180 mm]}
  2: {A0 A: 60 mm}
  3: {A: [0, 0], B: [150 mm, 0], C: [90 mm, 100 mm]}
  4: {B0 B: 140 mm}
  5: {C E: 190 mm}
  6: {E0 E: 120 mm}
drive: {link: 2, angle: 50 deg, speed: 120 rpm}
assembly: {B: left of A B0, E: left of C E0}
SCENE
for run in 1 2 3 4 5 6 7 8 9; do
  "$epure" draw six-bar.yaml --format svg --out "scene_$run" > /dev/null
  expect "a mechanism from a file is drawn with the same bytes, run $run" '' "$(diff -rq scene_1 "scene_$run" 2>&1)"
done

"$epure" draw - --format svg --out scene_piped < six-bar.yaml > /dev/null
expect 'a mechanism comes from standard input' 0 $?
expect 'and is that of the file' '' "$(diff -rq scene_1 scene_piped 2>&1)"
"$epure" draw /dev/stdin/velocities --format svg -o - < six-bar.yaml > piped.svg
expect 'so does one sheet of it' '' "$(cmp piped.svg scene_1/six-bar-velocities.svg 2>&1)"
rm -f piped.svg

# A disk's error on reading, as the memory of a process that is not there.
ln -s /proc/self/mem unreadable.yaml
"$epure" check unreadable.yaml > /dev/null 2> said
expect 'a file whose reading fails is exit 2' 2 $?
expect 'and is not called empty' 'epure: unreadable.yaml: the file cannot be read' "$(cat said)"

"$epure" draw all --out all_one > /dev/null
expect 'drawing all exits with 0' 0 $?
"$epure" draw all --out all_two > /dev/null
expect 'drawing all, on all processors, writes the same bytes again' '' "$(diff -r all_one all_two 2>&1)"
"$epure" draw spool-slip/forces -o whole.eps > /dev/null
blocks=$(($(wc -c < whole.eps) / 512 + 1))  # what is kept on the way, in a temporary file, is less
while [ $((blocks = blocks - 1)) -gt 0 ]; do
  code=$({ (ulimit -f "$blocks" && "$epure" draw spool-slip/forces --format eps -o - 2> /dev/null; echo $? >&3) |
    cat > cut.eps; } 3>&1)
  [ "$code" = 3 ] && continue
  expect "an EPS whose temporary file may have $blocks blocks: the exit code" 0 "$code"
  expect "an EPS whose temporary file may have $blocks blocks" '' "$(cmp whole.eps cut.eps 2>&1)"
done
for paper in a4 a3; do
  for language in en it; do
    for what in all scenes; do
      "$epure" draw $what --format svg --paper "$paper" --lang "$language" --out sized > /dev/null
      expect "$what: drawn on $paper, in $language" 0 $?
    done
    expect "no SVG is above 100 kB on $paper, in $language" '' "$(find sized -size +100000c)"
    rm -r sized
  done
done

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

(ulimit -f 4; "$epure" check "$first" --json > large 2> said)
expect 'a standard output that grows too large is exit 3' 3 $?
expect 'and said in one line' 1 "$(grep -c '^epure: ' said)"

# Cairo puts EPS together in a temporary file.
(ulimit -f 4; "$epure" draw "$first" --format eps --out none > said 2>&1)
expect 'a disk too small for EPS is exit 3' 3 $?
expect 'and said in one line' 1 "$(grep -c '^epure: ' said)"
expect 'and nothing is written' '' "$(ls none 2> /dev/null)"

# Little room, most of which the program takes to start. Where it cannot start with it, nothing can be said.
for bytes in 55000000 58000000 61000000 64000000; do
  prlimit --as="$bytes" "$epure" --version > /dev/null 2>&1 || continue
  prlimit --as="$bytes" "$epure" draw "$first" --out none > said 2>&1
  expect "want of room is exit 3 ($bytes)" 3 $?
  expect 'and said in one line' 1 "$(grep -c '^epure: ' said)"
  expect 'and nothing is written' '' "$(ls none 2> /dev/null)"
done

# A sheet needs no more threads than one. Nothing limits those of root.
one_thread() {
  if [ "$(id -u)" = 0 ]; then setpriv --reuid=65534 --regid=65534 --clear-groups prlimit --nproc=1 "$@"
  else prlimit --nproc=1 "$@"; fi
}
if one_thread "$epure" --version > /dev/null 2>&1; then
  "$epure" draw "$first" -o - > drawn
  one_thread "$epure" draw "$first" -o - 2>&1 | cmp - drawn
  expect 'one thread draws the same' 0 $?
fi

swept() { # swept VALUES [OPTIONS]: of slider-crank-velocity
  values=$1
  shift
  "$epure" sweep slider-crank-velocity --over "phi=$values" --quantity v_B,P0_x "$@"
}
swept 0..360/37 > whole 2> said
expect 'a sweep exits with 0' 0 $?
expect 'and tells no progress where there is no terminal' '' "$(cat said)"
for part in 1 2 3; do swept 0..360/37 --part $part/3; done | cmp - whole
expect 'the parts of a sweep are the whole' 0 $?
swept 0..360/1000000 2> said | head -n 3 | cmp -n 100 - whole
expect 'a reader of a sweep that has enough gets the first lines' 0 $?
expect 'and nobody complains of it' '' "$(cat said)"
swept 0..360/37 > /dev/full 2> said
expect 'a sweep to a full standard output is exit 3' 3 $?
expect 'and said in one line' 1 "$(grep -c '^epure: ' said)"
# Not by the function: a shell of its own would get the signal, and epure go on.
"$epure" sweep slider-crank-velocity --over phi=0..360/1000000 --quantity v_B,P0_x -o killed.csv &
killed=$!
sleep 0.3
expect 'a sweep that is not done keeps what it has found out of sight' '' "$(find . -name killed.csv)"
kill -TERM "$killed"
wait "$killed"
expect 'a sweep that is told to end does, by that signal' 143 $?
expect 'and leaves no file behind' '' "$(find . -name 'killed.csv' -o -name '.epure-*')"
if parallel --version 2> /dev/null | grep -q 'GNU parallel'; then
  export epure
  seq 5 | parallel -k -j1 "$epure" sweep slider-crank-velocity --over phi=0..360/37 --quantity v_B,P0_x \
    --part '{}/5' | cmp - whole
  expect 'the parts of a sweep by GNU parallel are the whole' 0 $?
else
  echo 'skipped: there is no GNU parallel here to run the parts of a sweep'
fi

EPURE_LANG=it "$epure" list > italian
"$epure" list --lang it | cmp - italian
expect 'EPURE_LANG stands for --lang' 0 $?
LC_ALL=it_IT.UTF-8 LANG=it_IT.UTF-8 LANGUAGE=it "$epure" list > list_there
"$epure" list | cmp - list_there
expect 'the locale chooses no language' 0 $?

# While sheets are timed there is a scratch folder; a bench that is ended takes it away.
if [ -x "${epure%/*}/epure-floor" ]; then
  mkdir temporary
  TMPDIR=$place/temporary "$epure" bench --seconds 0.001 --out benched > /dev/null 2>&1 &
  bench=$!
  while kill -0 "$bench" 2> /dev/null && [ -z "$(ls temporary)" ]; do sleep 0.02; done
  [ -n "$(ls temporary)" ]
  expect 'a bench has a scratch folder' 0 $?
  kill -TERM "$bench"
  wait "$bench"
  expect 'a bench that is told to end does, by that signal' 143 $?
  expect 'and leaves nothing behind' '' "$(ls temporary)"
fi

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
