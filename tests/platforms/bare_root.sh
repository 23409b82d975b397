#!/bin/sh
# The two commands of README.md in a bare Debian: makes its root with debootstrap, puts a clone of this checkout in (what
# is committed) and runs them.
#   sh tests/platforms/bare_root.sh bookworm|trixie [NEW_FOLDER]
# As root, on a Debian: the mirror and the settings are those of its apt. Leaves in the folder: root/, what was drawn
# (out/), what was said (log) and the report, which is printed too. Nothing is mounted outside a namespace of its own,
# so the folder can be deleted as it is. Exits with 1 when a command fails or installs what it should not.
# shellcheck disable=SC2016  # what is in single quotes apt or a shell inside expands
set -eu
suite=${1:?bookworm or trixie}
folder=${2:-/var/tmp/epure-$suite}
checkout=$(cd "$(dirname "$0")/../.." && pwd)
keyring=/usr/share/keyrings/debian-archive-keyring.gpg

fail() { printf '%s\n' "$*" >&2; exit 2; }
[ "$(id -u)" -eq 0 ] || fail 'making a root takes root'
command -v debootstrap > /dev/null || fail 'debootstrap is missing'
[ ! -e "$folder" ] || fail "$folder is there already"
mirror=$(apt-get indextargets --format '$(LABEL) $(REPO_URI)' 'Created-By: Packages' | sed -n 's/^Debian //p' | head -n 1)
[ -n "$mirror" ] || fail 'apt here has no mirror of Debian'
[ -z "$(git -C "$checkout" status --porcelain)" ] || echo 'what is not committed is not tried' >&2

# apt-config prints  variable='value'  for a setting that is there.
eval "$(apt-config shell http_proxy Acquire::http::Proxy https_proxy Acquire::https::Proxy)"
export http_proxy="${http_proxy-}" https_proxy="${https_proxy-}"
case $mirror in https:*) certificates=--include=ca-certificates ;; *) certificates= ;; esac

mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
root=$folder/root
report() { printf '%s\n' "$*" | tee -a "$folder/report"; }

# timed WHAT COMMAND...: runs it, reports its seconds, and gives its exit code.
timed() {
  what=$1 began=$(date +%s) code=0
  shift
  printf '== %s\n' "$what" >> "$folder/log"
  "$@" >> "$folder/log" 2>&1 < /dev/null || code=$?
  report "$what: $(($(date +%s) - began)) s, exit $code"
  return "$code"
}

# inside COMMAND: in the clone, with /proc and terminals, and with nothing of the environment here. Ends with all it has
# started.
inside() {
  unshare --mount --pid --fork --kill-child sh -c 'mount -t proc proc "$1/proc" && mkdir -p "$1/dev/pts" &&
    mount -t devpts -o newinstance,ptmxmode=0666 devpts "$1/dev/pts" && ln -sf pts/ptmx "$1/dev/ptmx" && exec env -i HOME=/root \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin chroot "$1" sh -c "cd /epure && $2"' - "$root" "$1"
}

# shellcheck disable=SC2086  # empty, or one word
timed "debootstrap $suite" debootstrap --variant=minbase --keyring="$keyring" $certificates "$suite" "$root" "$mirror" ||
  fail "no root, see $folder/log"
cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
apt-config dump | grep '^Acquire::' | grep -v '^Acquire::IndexTargets' > "$root/etc/apt/apt.conf.d/90as-outside"
git clone --quiet "$checkout" "$root/epure"
report "$(inside '. /etc/os-release; echo "$PRETTY_NAME, $(nproc) processors"'), commit $(git -C "$root/epure" rev-parse --short HEAD)"

failures=0
timed './epure draw all' inside './epure draw all' || failures=1
sed -n "s/^to_test='\(.*\)'.*/\1/p" "$root/epure/epure" | tr ' ' '\n' > "$folder/to_test"
if inside 'apt-mark showmanual' | grep -xF -f "$folder/to_test"; then
  report 'installed without need, as the tests alone take it'
  failures=1
fi
cp -R "$root/epure/out" "$folder/out"
report "$(find "$folder/out" -name '*.pdf' | wc -l) PDF, $(find "$folder/out" -name '*.svg' | wc -l) SVG"
timed './epure test' inside './epure test' || failures=1
grep -E '^[0-9]+% tests passed|^Total Test time|\*\*\*' "$folder/log" | while read -r line; do report "  $line"; done
timed './epure draw all, once more' inside './epure draw all' || failures=1
diff -r "$folder/out" "$root/epure/out" > /dev/null || { report 'the second time draws other bytes'; failures=1; }
report "$(inside 'dpkg-query -W -f="\${db:Status-Status} \${Package} \${Version}\n" $(apt-mark showmanual)' |
  sed -n 's/^installed //p' | grep -E '^(g\+\+|cmake|catch2|.*-dev) ')"
exit "$failures"
