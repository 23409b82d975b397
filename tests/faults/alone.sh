#!/bin/sh
# No network and no other program: every verb, where the kernel ends a process that asks for one (alone.c).
#   sh alone.sh PATH/TO/epure PATH/TO/libalone.so FOLDER_OF_SCENES
set -u
epure=$(realpath "$1") library=$(realpath "$2")
scenes=$(cd "$3" && pwd) || exit 1
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
cd "$place" || exit 1
failures=0

# That it would be seen.
LD_PRELOAD=$library sh -c '(: ) & wait $!; ls' > said 2>&1
if [ $? -ne 159 ] && ! grep -q 'Bad system call' said; then
  echo "skipped: no filter of system calls is to be had here ($(head -n 1 said))"
  exit 0
fi

printf 'number,name\n1,Ada\n' > roster.csv
printf 'number,v_B\n1,5.2\n' > answers.csv
runs() { # runs EXIT ARGUMENTS: with hostile surroundings
  expected=$1
  shift
  LD_PRELOAD=$library PAGER='touch pwned' EDITOR='touch pwned' BROWSER='touch pwned' http_proxy=http://127.0.0.1:9 \
    "$epure" "$@" > said 2>&1
  code=$?
  if [ "$code" -ne "$expected" ]; then
    echo "FAILED: epure $*: exit $code, not $expected: $(tail -n 1 said)"
    failures=$((failures + 1))
  fi
}
runs 0 --version
runs 0 help draw
runs 0 list --json
runs 0 check slider-crank-velocity four-bar gear-pair
for format in pdf svg png eps tex html; do runs 0 draw velocity-centre --format $format --out o; done
runs 0 draw velocity-centre/velocities --title '$(touch pwned)' --name '`touch pwned`{sheet}' --out o
runs 0 draw "$scenes/quick-return.yaml" --out o
runs 0 draw all --out all
for format in html md tex; do runs 0 report velocity-centre --format $format --out o; done
runs 0 class velocity-centre/velocities --students roster.csv --out o
runs 0 class velocity-centre/velocities --count 1 --format moodle --out o2
runs 0 mark slider-crank-velocity --answers answers.csv
runs 0 sweep slider-crank-velocity --over phi=0..360/200 --quantity v_B -o o/v_B.html
runs 0 booklet velocity-centre --out o
runs 2 import 'https://app.pmksplus.com/?2P.'
runs 2 draw 'http://127.0.0.1:9/scene.yaml'
runs 2 check '|touch pwned'
[ -e pwned ] && echo 'FAILED: something was run' && failures=$((failures + 1))
[ "$failures" -eq 0 ] && echo 'no network, no other program'
[ "$failures" -eq 0 ]
