#!/bin/sh
# Makes a folder with what the program needs of Debian for aarch64: headers and libraries, and the C library to run it
# by qemu.
#   scripts/aarch64_sysroot.sh FOLDER
# Nothing is installed and no rights are asked for: apt-get keeps lists and packages in FOLDER, too, as if no package
# were there yet, and finds what the libraries of scripts/packages.txt depend on. 170 MB are fetched, 900 MB lie there
# afterwards.
set -eu
cd "$(dirname "$0")/.."
mkdir -p "$1"
folder=$(cd "$1" && pwd)
root=$folder/root

# The group build's libraries; its tools are this machine's own.
wanted=$(awk '/^\[/ { inside = ($0 == "[build]"); next } inside && $1 ~ /-dev$/ { print $1 }' scripts/packages.txt)
if [ "$(cat "$folder/wanted" 2>/dev/null)" = "$wanted" ]; then exit 0; fi

# dpkg's own list is empty, so that all that is depended on is fetched.
rm -rf "$root" "$folder/wanted"
mkdir -p "$folder/state/lists/partial" "$folder/cache/archives/partial"
: >"$folder/state/status"
apt() {
  apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o APT::Sandbox::User="$(id -un)" -o Debug::NoLocking=1 \
    -o Dir::State="$folder/state" -o Dir::State::status="$folder/state/status" -o Dir::Cache="$folder/cache" "$@"
}
apt update >"$folder/log" 2>&1 || true # a stale or foreign source must not stop what the others can give
# shellcheck disable=SC2086
apt install -y --no-install-recommends --download-only $wanted >>"$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 69; }

# /lib is a link to /usr/lib, as in every Debian 12; packages still name both.
mkdir -p "$root/usr/lib"
ln -s usr/lib "$root/lib"
for package in "$folder"/cache/archives/*.deb; do
  dpkg-deb --fsys-tarfile "$package" | tar -x -C "$root" --keep-directory-symlink --no-same-owner
done

# Links to /lib/... would lead to this machine's libraries.
find "$root/usr/lib" -type l -lname '/*' | while read -r link; do
  ln -sfn "$root$(readlink "$link")" "$link"
done
# What update-alternatives would choose when they are installed.
for library in blas lapack; do
  ln -sf "$library/lib$library.so.3" "$root/usr/lib/aarch64-linux-gnu/lib$library.so.3"
done
printf '%s\n' "$wanted" >"$folder/wanted"
