#!/bin/sh
# The manual page and the completions, given to the programs that read them.
#   pages.sh build/pomona FOLDER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
program=$1
folder=$2
mkdir -p "$folder"
cd "$folder"
for kind in man bash zsh fish; do "$program" pages $kind >"$kind"; done
PATH=$(dirname "$program"):$PATH
export PATH

fail() { echo "pages: error: $1" >&2; exit 1; }

# groff warns of everything, and has nothing to say.
warnings=$(groff -ww -man -Tutf8 -P-cbou man 2>&1 >man.txt)
[ -z "$warnings" ] || fail "groff: $warnings"
grep -q -e "--knife" man.txt || fail "the manual page has lost its hyphens"

# fish.
fish -n fish
[ "$(fish -c 'source fish; complete -C "pomona cut tomato --quality "' | cut -f1 | tr '\n' ' ')" = "draft final reference " ] || fail "fish: --quality"
[ "$(fish -c 'source fish; complete -C "pomona grow toma"' | cut -f1)" = tomato ] || fail "fish: templates"

# zsh.
zsh -n zsh
mkdir -p functions
cp zsh functions/_pomona
typed=$(timeout 60 zsh -f "$here/complete.zsh" functions 'pomona cut toma\t --quality ref\t --knife wedg\t')
[ "$typed" = "cut tomato --quality reference --knife wedges:" ] || fail "zsh: $typed"
