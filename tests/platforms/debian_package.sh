#!/bin/sh
# A package of the program, installed in a bare Debian made by debootstrap and tried there as a user without rights.
#   sh tests/platforms/debian_package.sh bookworm|trixie PATH/TO/epure_VERSION_ARCHITECTURE.deb [NEW_FOLDER]
# As root, on a Debian: the mirror and the settings are those of its apt. Prints what it saw; exits with 1 when something
# does not work. The folder can be deleted as it is.
# shellcheck disable=SC2016  # what is in single quotes apt or a shell inside expands
set -eu
suite=${1:?bookworm or trixie} package=${2:?a package} root=${3:-/var/tmp/epure-package-$1}

fail() { printf '%s\n' "$*" >&2; exit 2; }
[ "$(id -u)" -eq 0 ] || fail 'making a root takes root'
mirror=$(apt-get indextargets --format '$(LABEL) $(REPO_URI)' 'Created-By: Packages' | sed -n 's/^Debian //p' | head -n 1)
eval "$(apt-config shell http_proxy Acquire::http::Proxy https_proxy Acquire::https::Proxy)"
export http_proxy="${http_proxy-}" https_proxy="${https_proxy-}"
case $mirror in https:*) certificates=--include=ca-certificates ;; *) certificates= ;; esac
# shellcheck disable=SC2086  # empty, or one word
[ -d "$root/usr" ] || debootstrap --variant=minbase $certificates "$suite" "$root" "$mirror" > /dev/null || fail "no root in $root"
cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
apt-config dump | grep '^Acquire::' | grep -v '^Acquire::IndexTargets' > "$root/etc/apt/apt.conf.d/90as-outside"
cp "$package" "$root/tmp/epure.deb"

inside() {
  unshare --mount --pid --fork --kill-child sh -c 'mount -t proc proc "$1/proc" && exec env -i HOME=/tmp TERM=dumb \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin chroot "$1" sh -c "$2"' - "$root" "$1"
}
inside 'apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends /tmp/epure.deb' \
  > "$root/tmp/installed" 2>&1 || { tail -n 20 "$root/tmp/installed"; exit 1; }

inside 'set -eu
  missing() { echo "wrong: $1"; exit 1; }
  as_user() { setpriv --reuid=1000 --regid=1000 --clear-groups "$@"; }
  rm -rf /tmp/user && mkdir -p /tmp/user && chown 1000:1000 /tmp/user && cd /tmp/user
  epure --version
  as_user epure draw all --out out > written
  pdf=$(grep -c "[.]pdf$" written) svg=$(grep -c "[.]svg$" written)
  echo "$pdf PDF, $svg SVG"
  [ "$pdf" -ge 25 ] && [ "$svg" -ge 142 ] || missing "drawings"
  as_user epure check all --quiet
  as_user epure check scenes --quiet
  as_user epure list --json > list.json
  as_user epure bench --seconds 0.1 --out out > /dev/null
  test -s out/bench.pdf || missing "the drawing of the bench"
  for page in epure epure-draw; do
    zcat /usr/share/man/man1/$page.1.gz | grep -q "SH EXAMPLES" || missing "the page of $page"
  done
  for file in bash-completion/completions/epure zsh/site-functions/_epure fish/vendor_completions.d/epure.fish \
    doc/epure/copyright; do
    test -s /usr/share/$file || missing "$file"
  done
  if ldd /usr/bin/epure | grep "not found"; then missing "a library"; fi
  apt-get remove -y epure > /dev/null 2>&1
  if test -e /usr/share/epure; then missing "the removal: something stays"; fi
  echo "removed without a trace"'
