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
[ "$(fish -c 'source fish; complete -C "pomona farm s"' | cut -f1 | tr '\n' ' ')" = "slurm status " ] || fail "fish: commands in commands"
[ "$(fish -c 'source fish; complete -C "pomona farm slurm --ta"' | cut -f1)" = --tasks ] || fail "fish: their options"

# bash.
completed() { bash --norc -c 'source ./bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _pomona 2>/dev/null; echo "${COMPREPLY[*]}"' - "$@"; }
[ "$(completed pomona farm '')" = "slurm commands status" ] || fail "bash: commands in commands"
[ "$(completed pomona farm slurm --ta)" = --tasks ] || fail "bash: their options"
[ "$(completed pomona cut toma)" = tomato ] || fail "bash: templates"

# zsh.
zsh -n zsh
mkdir -p functions
cp zsh functions/_pomona
typed=$(timeout 60 zsh -f "$here/complete.zsh" functions 'pomona cut toma\t --quality ref\t --knife wedg\t')
[ "$typed" = "cut tomato --quality reference --knife wedges:" ] || fail "zsh: $typed"
typed=$(timeout 60 zsh -f "$here/complete.zsh" functions 'pomona farm sl\t small\t --dry\t')
[ "$typed" = "farm slurm small_batch --dry-run" ] || fail "zsh: $typed"
