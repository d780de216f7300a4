# Completes the words after xnewell in bash: the program proposes them.
_xnewell() {
  local words=("${COMP_WORDS[@]:1:COMP_CWORD}")
  words=("${words[@]//\\/}") words=("${words[@]#[\"\']}") # a name with blanks is quoted
  mapfile -t COMPREPLY < <("${COMP_WORDS[0]/#\~/$HOME}" complete -- "${words[@]}" 2>/dev/null | cut -f1)
  compopt -o filenames 2>/dev/null
}
complete -F _xnewell xnewell
