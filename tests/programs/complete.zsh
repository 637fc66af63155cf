# What zsh makes of a line with Tabs in it, typed in a terminal: complete.zsh FOLDER "the line\n"
# FOLDER holds _pomona, and the program is in PATH.
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "fpath=($1 \$fpath); autoload -Uz compinit; compinit -u -D; PS1=; bindkey '^I' complete-word"
# The line is printed, not run; what completion asks of the program is.
zpty -w shell 'pomona() { [[ $1 == list ]] && command pomona $@ || print -r -- "TYPED" "$*" END; }; print -r -- REA""DY'
zpty -r -m shell seen '*READY*'
zpty -w -n shell "$(print $2)"$'\n'
zpty -r -m shell seen '*TYPED*END*'
zpty -d shell
print -r -- ${${seen##*TYPED }%% END*}
