#!/bin/sh
# The pages of the manual as groff sets them, for every verb, in both languages.
#   sh manual.sh FOLDER_OF_DOCUMENTS PATH/TO/epure
set -u
documents=$1 epure=$2
failures=0

fail() {
  printf 'FAILED: %s\n' "$*"
  failures=$((failures + 1))
}
# The page on 80 columns, without the marks of bold and underlined letters.
set_page() { groff -K utf8 -man -T utf8 -ww -b -P -cbou "$1"; }

verbs=$("$epure" help | sed -n '/^Usage/,/^  -/s/^  \([a-z][a-z]*\)  .*/\1/p')
[ "$(echo "$verbs" | wc -w)" -ge 7 ] || fail "too few verbs: $verbs"
for page in epure $(for verb in $verbs; do echo "epure-$verb"; done); do
  for folder in man/man1 man/it/man1; do
    file=$documents/$folder/$page.1
    text=$(set_page "$file" 2>&1 > /dev/null)
    [ -z "$text" ] || fail "groff warns of $file: $text"
  done
  set_page "$documents/man/man1/$page.1" 2> /dev/null | grep -q 'EXIT STATUS' || fail "$page has no exit codes"
  set_page "$documents/man/it/man1/$page.1" 2> /dev/null | grep -q 'STATO DI USCITA' || fail "$page: no Italian"
done
[ "$(find "$documents/man" -name '*.1' | wc -l)" -eq $((2 * ($(echo "$verbs" | wc -w) + 1))) ] || fail 'a page too many'

# What --help says stands in the manual, word by word, whatever the lines.
words() { tr -s ' \n' '\n' | sed 's/[‐−]/-/g' | paste -s -d ' '; }
for verb in $verbs; do
  page=$(groff -K utf8 -man -T utf8 -rHY=0 -rLL=2000n -P -cbou "$documents/man/man1/epure-$verb.1" | words)
  for option in $("$epure" help "$verb" | sed -n 's/^  --*\([a-z][a-z-]*\).*/\1/p'); do
    case $page in *"-$option"*) ;; *) fail "epure-$verb says nothing of $option" ;; esac
  done
  example=$("$epure" help "$verb" | sed -n '/^Examples/,$s/^  \(epure .*\)/\1/p' | head -n 1 | words)
  case $page in *"$example"*) ;; *) fail "epure-$verb lacks the example: $example" ;; esac
done

[ "$failures" -eq 0 ] && echo 'the manual is set without a warning'
[ "$failures" -eq 0 ]
