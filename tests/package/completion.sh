#!/bin/bash
# What a shell offers, in the shells that are there: each is asked the same, and must answer the same.
#   bash completion.sh FOLDER_OF_DOCUMENTS FOLDER_OF_THIS_FILE
set -u
documents=$1 here=$2
failures=0

# offered SHELL 'epure draw --pa': what it offers behind that, one a line, sorted.
offered() { "offered_by_$1" "$2" | sed 's/[ =]*$//' | sort -u; }

offered_by_bash() {
  bash --norc --noprofile -c '
    compopt() { :; }  # needs a completion under way
    . "$1"
    # As bash does it: "=" is a word of its own.
    read -ra COMP_WORDS <<< "${2//=/ = }"
    [[ $2 == *[\ =] ]] && COMP_WORDS+=("")
    COMP_LINE=$2 COMP_POINT=${#2} COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
    _epure
    printf "%s\n" "${COMPREPLY[@]}"' - "$documents/bash-completion/completions/epure" "$1"
}
offered_by_fish() { HOME=/nonexistent fish --no-config -c "source '$documents/fish/vendor_completions.d/epure.fish'; complete -C '$1'" 2> /dev/null | cut -f 1; }
offered_by_zsh() { zsh -f "$here/completion.zsh" "$documents/zsh/site-functions" "$1"; }

# expect SHELL LINE NAME...: these, and no more, are offered; "..." among them: also others.
expect() {
  local shell=$1 line=$2 found missing
  shift 2
  found=$(offered "$shell" "$line")
  if [[ $* == *...* ]]; then
    missing=$(comm -13 <(echo "$found") <(printf '%s\n' "${@/.../}" | sed '/^$/d' | sort -u))
  else
    missing=$(diff <(echo "$found") <(printf '%s\n' "$@" | sort -u))
  fi
  [ -z "$missing" ] && return
  printf 'FAILED: %s, "%s": expected %s, offered %s\n' "$shell" "$line" "$*" "$(echo "$found" | paste -s -d ' ' | cut -c 1-300)"
  failures=$((failures + 1))
}

for shell in bash zsh fish; do
  if ! command -v "$shell" > /dev/null; then
    echo "skipped: $shell is not here"
    continue
  fi
  expect $shell 'epure ' list draw check report booklet class mark sweep import bench help ...
  expect $shell 'epure report slider-crank-velocity --format ' html md tex
  expect $shell 'epure booklet velocity-' velocity-centre
  expect $shell 'epure dr' draw
  expect $shell 'epure help sw' sweep
  expect $shell 'epure draw four-bar-' four-bar-analytic four-bar-constraints four-bar-with-coupler-point
  expect $shell 'epure check al' all
  expect $shell 'epure draw slider-crank-velocity/' slider-crank-velocity/poles slider-crank-velocity/polodes ...
  expect $shell 'epure draw slider-crank-velocity/polar' slider-crank-velocity/polar-diagram
  expect $shell 'epure draw --pa' --paper
  expect $shell 'epure draw --paper ' a3 a4
  expect $shell 'epure class four-bar --format ' moodle pdf
  expect $shell 'epure check --arithmetic b' bounded
  expect $shell 'epure draw pin-in-slot --lang ' en it
  expect $shell 'epure draw slider-crank-velocity --set ph' phi
  expect $shell 'epure sweep slider-crank-velocity --over ' r n phi ...
  expect $shell 'epure check slider-crank-velocity --sheet pole' poles
  expect $shell 'epure check velocity-centre --measured v_' v_A v_A_x v_A_y ...
  expect $shell 'epure sweep slider-crank-velocity --quantity v_B,omega_' v_B,omega_3 ...
  expect $shell 'epure list --j' --json
done

[ "$failures" -eq 0 ] && echo 'shells offer what epure knows'
[ "$failures" -eq 0 ]
