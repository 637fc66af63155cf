#!/bin/sh
# Installs the Debian packages of the named groups of scripts/packages.txt that are missing.
#   scripts/setup.sh build test
# Touches nothing, and asks for no rights, when all are there.
set -eu
here=$(dirname "$0")

# Prints "package program" lines of one group, comments taken off.
packages_of() {
  sed -e 's/[[:space:]]*#.*//' -e '/^[[:space:]]*$/d' "$here/packages.txt" |
    awk -v group="[$1]" '/^\[/ { inside = ($0 == group); next } inside { print }'
}

is_there() {
  if [ -n "$2" ] && command -v "$2" >/dev/null 2>&1; then return 0; fi
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Collect what is missing.
missing=
for group in "$@"; do
  listed=$(packages_of "$group")
  if [ -z "$listed" ]; then
    echo "setup: error: scripts/packages.txt has no group \"$group\"" >&2
    exit 64
  fi
  while read -r package program; do
    is_there "$package" "$program" || missing="$missing $package"
  done <<LIST
$listed
LIST
done
[ -z "$missing" ] && exit 0

# Find a way to install it.
if ! command -v apt-get >/dev/null 2>&1; then
  echo "setup: error: this is not Debian; install what these packages hold yourself:$missing" >&2
  exit 69
fi
as_root=
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null 2>&1; then
    echo "setup: error: Debian packages are missing, and neither root nor sudo is at hand to install them." >&2
    echo "  Ask for: apt-get install --no-install-recommends$missing" >&2
    exit 69
  fi
  as_root=sudo
fi

# Install quietly; the log is shown if it fails.
echo "setup: installing$missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() { $as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600 "$@" >>"$log" 2>&1; }
apt update || true # a stale or foreign source must not stop what the others can give
# shellcheck disable=SC2086
if ! apt install -y --no-install-recommends $missing </dev/null; then
  cat "$log" >&2
  echo "setup: error: apt-get could not install$missing (see above)" >&2
  exit 69
fi
