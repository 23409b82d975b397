# What zsh offers behind a command line, one a line. It completes only where a line is edited: in a terminal of its own,
# where what adds matches is told to say them too.
#   zsh -f completion.zsh FOLDER_OF_FUNCTIONS 'epure draw '
zmodload zsh/zpty
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
print -r "PS1= fpath=(${(q)1} \$fpath)" > $folder/.zshrc
cat >> $folder/.zshrc << 'end of file'
autoload -Uz compinit
compinit -u -d $ZDOTDIR/dump
compadd() {  # every match that fits, behind what stands on the line already
  if [[ " $* " != *' -O '* && " $* " != *' -D '* && " $* " != *' -A '* ]]; then
    local -a offered_now
    builtin compadd -O offered_now "$@"
    local each
    for each in $offered_now; do print -r -- "match $IPREFIX$each" >> $ZDOTDIR/matches; done
  fi
  builtin compadd "$@"
}
tell() {
  zle list-choices
  print done > $ZDOTDIR/done
}
zle -N tell
bindkey '^T' tell
LISTMAX=10000
print ready > $ZDOTDIR/ready
end of file
wait_for() {  # what the shell says is read and left alone, or it would wait
  for ((tries = 0; tries < 1000; ++tries)); do
    [[ -e $folder/$1 ]] && return
    zpty -r -t edited ignored
    sleep 0.02
  done
}
zpty edited env TERM=vt100 ZDOTDIR=$folder zsh -d -i
wait_for ready
zpty -w -n edited "$2"$'\C-t'
wait_for done
sed 's/^match //' $folder/matches 2> /dev/null
zpty -d edited
