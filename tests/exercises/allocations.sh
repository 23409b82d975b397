#!/bin/sh
# One allocation fails, of those of the constants that are made before main and of those after: the program ends as for
# want of memory, or does without.
#   sh allocations.sh PATH/TO/epure PATH/TO/fails_one_malloc.so
set -u
epure=$1
fails_one_malloc=$2
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
cd "$place" || exit 1
"$epure" list > whole || exit 1
failures=0
wanted=0
n=1
while [ "$n" -lt 1500 ]; do
  FAILS_AT=$n LD_PRELOAD=$fails_one_malloc "$epure" list > listed 2> said
  ended=$?
  if [ "$ended" -eq 3 ]; then
    wanted=$((wanted + 1))
    [ "$(cat said)" = 'epure: there is not enough memory for this' ] || ended=3:$(cat said)
  elif [ "$ended" -eq 0 ]; then
    cmp -s whole listed || ended='0, and another list'
  fi
  [ "$n" -lt 200 ] && [ "$ended" = 133 ] && ended=3 # GLib's own, before anything of ours: it traps
  case $ended in
    0 | 3) ;;
    *)
      printf 'FAILED: allocation %s: exit %s\n' "$n" "$ended"
      failures=$((failures + 1))
      ;;
  esac
  n=$((n + 17))
done
[ "$wanted" -gt 20 ] || {
  printf 'FAILED: only %s of the allocations were missed\n' "$wanted"
  failures=$((failures + 1))
}
[ "$failures" -eq 0 ]
