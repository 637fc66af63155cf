#!/bin/sh
# Builds the program in every way that must not matter, each in a folder of its own under build/reproduce, and asks
# `pomona verify` of each whether it gives what is published.
#   scripts/reproduce.sh              all of them; status 1 if one differs, or one that must differ does not
#   scripts/reproduce.sh NAME...      these alone: gcc-O2, clang-O3, threads, ...
#   scripts/reproduce.sh --list       their names
# VERIFY="--all" compares every cut, VERIFY="cherry" those of one template; a tenth unless said. JOBS=2.
# A build that takes minutes is kept: what did not change is not compiled again.
set -u
cd "$(dirname "$0")/.."
root=$(pwd)
folder=$root/build/reproduce
jobs=${JOBS:-$(nproc)}
verify=${VERIFY:-}
program=$root/build/pomona
failed=0
source=$root
unity=ON

same="gcc-O0 gcc-O2 gcc-O3 gcc-v3 clang-O0 clang-O2 clang-O3 clang-v3 threads library place aarch64"
different="fused libm"

say() { printf '%s: %s\n' "$1" "$2"; }

# build NAME COMPILER FLAGS [OPTIONS OF CMAKE...]: the program alone, at $folder/NAME/bin/pomona, with templates beside
# it. The flags come after the preset's own, so that the last of two -O counts; what pomona.cmake says of each source
# comes after them.
build() {
  built=$folder/$1
  compiler=$2
  flags=$3
  shift 3
  mkdir -p "$built/bin"
  log=$built/build.log
  cmake -S "$source" -B "$built/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_CXX_FLAGS="$flags" -DPOMONA_TESTS=OFF -DPOMONA_BENCH=OFF -DPOMONA_WERROR=OFF -DPOMONA_UNITY="$unity" "$@" \
    >"$log" 2>&1 &&
    cmake --build "$built/build" --target pomona -j "$jobs" >>"$log" 2>&1 || { tail -20 "$log"; return 1; }
  cp "$built/build/pomona" "$built/bin/pomona"
  ln -sfn "$root/templates" "$built/templates"
}

# expect_same NAME WORDS...: a run of verify that must find nothing.
expect_same() {
  name=$1
  shift
  # shellcheck disable=SC2086
  if said=$("$@" verify $verify --quiet --json 2>&1); then
    say "$name" "the same"
  else
    say "$name" "DIFFERS: $(printf '%s' "$said" | tail -8 | tr -s '\n ' ' ')"
    failed=1
  fi
}

# expect_different NAME: what must be found, or nothing is proved.
expect_different() {
  # shellcheck disable=SC2086
  "$folder/$1/bin/pomona" verify $verify >"$folder/$1/said.txt" 2>&1
  status=$?
  if [ "$status" -eq 1 ]; then
    say "$1" "found, as it must be: $(tail -1 "$folder/$1/said.txt")"
  else
    say "$1" "NOT FOUND (status $status): verify proves nothing"
    failed=1
  fi
}

# changed NAME FILE SED: the program with one file changed, in a copy of the sources; it must be found.
changed() {
  source=$folder/$1/source
  mkdir -p "$source"
  tar -c cli cmake generator render scenes shaders styles templates docs CMakeLists.txt README.md CHANGELOG.md CITATION.cff LICENSE |
    tar -x -C "$source"
  sed -i -E "$3" "$source/$2"
  if cmp -s "$2" "$source/$2"; then say "$1" "NOTHING WAS CHANGED"; failed=1 source=$root; return; fi
  unity=ON
  if build "$1" g++ "-O3 -DNDEBUG"; then expect_different "$1"; else say "$1" "DOES NOT COMPILE"; failed=1; fi
  source=$root
}

# One compiler and its options: compiler-name FLAGS
compiled() {
  case $1 in gcc-*) compiler=g++ unity=ON ;; *) compiler=clang++ unity=OFF ;; esac
  if build "$1" "$compiler" "$2"; then expect_same "$1" "$folder/$1/bin/pomona"; else say "$1" "DOES NOT COMPILE"; failed=1; fi
}

# Another processor, by a cross compiler and qemu, with Debian's libraries for it in a folder beside.
aarch64() {
  sysroot=$folder/sysroot/root
  scripts/setup.sh aarch64 && scripts/aarch64_sysroot.sh "$folder/sysroot" || { say aarch64 "CANNOT BE TRIED"; failed=1; return; }
  unity=ON
  if build aarch64 aarch64-linux-gnu-g++ "-O3 -DNDEBUG" --toolchain "$root/cmake/aarch64.cmake" -DPOMONA_SYSROOT="$sysroot"; then
    expect_same aarch64 qemu-aarch64-static -L "$sysroot" "$folder/aarch64/bin/pomona"
  else
    say aarch64 "DOES NOT COMPILE"
    failed=1
  fi
}

need_program() {
  [ -x "$program" ] || make build || exit 1
}

run() {
  case $1 in
    *-O0) compiled "$1" "-O0 -DNDEBUG" ;;
    *-O2) compiled "$1" "-O2 -DNDEBUG" ;;
    *-O3) compiled "$1" "-O3 -DNDEBUG" ;;
    *-v3) compiled "$1" "-O3 -DNDEBUG -march=x86-64-v3" ;;
    threads)
      need_program
      kept=$verify
      for count in 1 2 16; do
        verify="$kept --threads $count"
        expect_same "threads $count" env "$program"
      done
      verify=$kept
      ;;
    library)
      # glibc chooses its mathematics and copying by the processor; off, it takes the plain ones.
      need_program
      off="glibc.cpu.hwcaps=-AVX2_Usable,-AVX2,-AVX_Usable,-AVX,-FMA_Usable,-FMA,-FMA4_Usable,-ERMS,-SSE4_2,-SSE4_1"
      expect_same "the C library's fast paths off" env GLIBC_TUNABLES="$off" "$program"
      ;;
    place)
      need_program
      for language in de_DE.UTF-8 tr_TR.UTF-8 C; do
        (cd / && expect_same "locale $language" env -u HOME LC_ALL="$language" TZ=Asia/Kathmandu "$program"; exit $failed) || failed=1
      done
      ;;
    aarch64) aarch64 ;;
    fused)
      # Products and sums in one operation, rounded once.
      changed fused cmake/pomona.cmake 's/-ffp-contract=off/-ffp-contract=fast -mfma/'
      ;;
    libm)
      # The C library's own sine and its kin in place of SLEEF's.
      changed libm generator/base/reproducible.cpp \
        's/Sleef_cinz_(sin|cos|atan2|acos|exp|log|pow|cbrt)d1_u10purec/std::\1/; s/^#include <sleef.h>/#include <sleef.h>\n#include <cmath>/'
      ;;
    *)
      echo "reproduce.sh: error: there is no build \"$1\"; one of: $same $different" >&2
      exit 64
      ;;
  esac
}

if [ "${1:-}" = --list ]; then
  for name in $same $different; do echo "$name"; done
  exit 0
fi
[ $# -gt 0 ] || set -- $same $different
for name in "$@"; do run "$name"; done
exit $failed
