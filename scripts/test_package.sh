#!/bin/sh
# Installs a .deb in a new, bare Debian 12, in a folder, and runs the README's commands there.
#   scripts/test_package.sh build/package/pomona_0.6.0_amd64.deb /tmp/root
# Needs root, debootstrap, and this machine's own sources of packages (apt). The folder must not be there; it stays.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
package=$1
root=$2

[ "$(id -u)" -eq 0 ] || { echo "test_package: error: needs root: debootstrap and chroot do" >&2; exit 77; }
if [ -e "$root" ]; then echo "test_package: error: $root is there already" >&2; exit 73; fi

# A bare Debian, from where this machine's comes.
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Codename: bookworm' 'Component: main' | head -n 1)
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 || { tail "$root.log" >&2; exit 1; }
du -sm "$root" | sed 's/\t.*/ MB: the bare system/'

# The package, and whatever it says it needs; nothing that it only recommends.
cp "$package" "$root/pomona.deb"
[ ! -f /etc/resolv.conf ] || cp /etc/resolv.conf "$root/etc/resolv.conf"
inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive HOME=/root "$@"; }
inside apt-get -qq install -y --no-install-recommends /pomona.deb >>"$root.log" 2>&1 || { tail "$root.log" >&2; exit 1; }
du -sm "$root" | sed 's/\t.*/ MB: with the package and what it depends on/'

# The README's commands, with the installed program.
commands=$(sed -n 's/ *#.*//; s/^build\/pomona /pomona /p' "$here/../README.md" | sed 's/scenes\/salad.toml/salad/')
echo "$commands" >"$root/commands.sh"
[ "$(echo "$commands" | wc -l)" -ge 5 ] || { echo "test_package: error: the README has no commands" >&2; exit 1; }
echo "$commands"
inside sh -euc 'mkdir /made; cd /made; . /commands.sh' >>"$root.log"
for file in $(echo "$commands" | sed -n 's/.* -o //p'); do
  [ -s "$root/made/$file" ] || { echo "test_package: error: $file was not made" >&2; exit 1; }
  ls -l "$root/made/$file" | awk '{ print $5, $9 }'
done

# Its Python, with what the package recommends for it.
sed -n '/^```python$/,/^```$/ { /^```/d; p }' "$here/../README.md" >"$root/made/wedges.py"
inside apt-get -qq install -y --no-install-recommends python3-numpy >>"$root.log" 2>&1
inside sh -euc 'cd /made; rm wedges.glb; python3 wedges.py' >>"$root.log"
[ -s "$root/made/wedges.glb" ] || { echo "test_package: error: Python has not made wedges.glb" >&2; exit 1; }
inside test -s /usr/share/man/man1/pomona.1 # minbase keeps manual pages
inside apt-get -qq remove -y pomona >>"$root.log" 2>&1
if inside test -e /usr/share/pomona; then echo "test_package: error: removing it leaves /usr/share/pomona" >&2; exit 1; fi
