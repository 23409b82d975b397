#!/bin/sh
# Do two folders of drawings, as two systems drew them, show the same? Every PDF and SVG as pixels, and as bytes.
#   sh tests/platforms/same_drawings.sh FOLDER OTHER_FOLDER
# Exits with 1 when a pixel differs or a drawing is in one folder alone. Takes poppler-utils and librsvg2-bin.
set -eu
one=${1:?a folder}
other=${2:?another folder}
for tool in pdftoppm rsvg-convert; do
  command -v "$tool" > /dev/null || { echo "$tool is missing" >&2; exit 2; }
done
place=$(mktemp -d)
trap 'rm -r "$place"' EXIT

drawings() { (cd "$1" && find . -name '*.pdf' -o -name '*.svg') | sort; }
drawings "$one" > "$place/names"
[ -s "$place/names" ] || { echo "nothing is drawn in $one" >&2; exit 2; }
drawings "$other" | diff "$place/names" - || { echo 'the folders do not hold the same drawings'; exit 1; }

# pixels FILE FOLDER: its pages at 100 pixels an inch, FOLDER/page-*.ppm
pixels() {
  mkdir "$2"
  case $1 in
    *.svg)
      rsvg-convert --format pdf --output "$2/drawing.pdf" "$1"
      pdftoppm -r 100 "$2/drawing.pdf" "$2/page"
      ;;
    *) pdftoppm -r 100 "$1" "$2/page" ;;
  esac
}

same_bytes=0 same_pixels=0 all=0
while read -r name; do
  all=$((all + 1))
  cmp -s "$one/$name" "$other/$name" && same_bytes=$((same_bytes + 1))
  pixels "$one/$name" "$place/one"
  pixels "$other/$name" "$place/other"
  if diff -rq --exclude='*.pdf' "$place/one" "$place/other" > "$place/differing"; then
    same_pixels=$((same_pixels + 1))
  else
    echo "$name:"
    for page in "$place"/one/*.ppm; do # how many of the three colours of all pixels differ, and by how much of 255
      # shellcheck disable=SC2015
      [ -e "$place/other/${page##*/}" ] || { echo "  ${page##*/} is in one alone"; continue; }
      cmp -l "$page" "$place/other/${page##*/}" | awk -v page="${page##*/}" '
        function octal(text, i, n) { for (i = 1; i <= length(text); ++i) n = 8 * n + substr(text, i, 1); return n }
        { d = octal($2) - octal($3); if (d < 0) d = -d; if (d > most) most = d }
        END { if (NR) printf "  %s: %d values differ, by %d of 255 at most\n", page, NR, most }'
    done
  fi
  rm -r "$place/one" "$place/other"
done < "$place/names"
echo "$all drawings: $same_pixels the same as pixels, $same_bytes as bytes"
[ "$same_pixels" -eq "$all" ]
