#!/usr/bin/env zsh
# complete.zsh FILE LINE: prints what zsh proposes after LINE with the completion in FILE, one proposal a line.
# It types the line and a Tab into a second zsh, in a terminal of its own. That one sources this file too:
#   source complete.zsh inside FILE
if [[ $1 == inside ]]; then
  PROMPT= RPROMPT=
  autoload -Uz compinit && compinit -u -d $2.dump
  # Each proposal is printed behind a mark.
  compadd() {
    if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then
      builtin compadd "$@"
      return
    fi
    local -a proposals
    local one
    builtin compadd -A proposals "$@"
    for one in $proposals; do print -r -- $'\n'"=$one"; done
    builtin compadd "$@"
  }
  finish() { print "\nEND"; exit }
  comppostfuncs=(finish)
  bindkey '^I' complete-word
  source $2
  compdef _xnewell xnewell
  print READY
  return
fi
zmodload zsh/zpty || exit 2
zpty shell zsh -f -i
zpty -w shell "source ${(q)0:A} inside ${(q)1:A}"
while zpty -r shell line && [[ $line != *READY* ]]; do :; done
zpty -w -n shell "$2"$'\t'
while zpty -r shell line && [[ $line != *END* ]]; do
  line=${line%%$'\r'*}
  [[ $line == '='* ]] && print -r -- "${line#?}"
done
zpty -d shell
