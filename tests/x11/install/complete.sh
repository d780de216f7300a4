#!/usr/bin/env bash
# complete.sh SHELL PREFIX LINE: prints what a shell proposes after LINE, in the folder of the project's data, with the
# completion that is installed in PREFIX: sorted, one proposal a line, folders without their slash. Exit status: the
# shell's.
set -o pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd) shell=$1 prefix=$2 line=$3 home=$PWD/home
export PATH=$prefix/bin:$PATH
cd "$here/../../../data" || exit
case $shell in
  bash)
    source "$prefix/share/bash-completion/completions/xnewell" || exit
    read -ra COMP_WORDS <<<"$line"  # an equals sign is a word
    [[ $line != *' ' ]] || COMP_WORDS+=('')
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
    _xnewell
    printf '%s\n' "${COMPREPLY[@]}"
    ;;
  zsh) zsh -f "$here/complete.zsh" "$prefix/share/zsh/site-functions/_xnewell" "$line" ;;
  fish) HOME=$home fish --no-config -c "source '$prefix/share/fish/vendor_completions.d/xnewell.fish'; and complete -C '$line'" ;;
esac | cut -f 1 | sed 's|/$||; /^$/d' | sort -u
