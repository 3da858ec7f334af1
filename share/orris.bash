# Bash completion for orris: commands and flags are asked of the program itself, so they never differ.
_orris() {
  local word=${COMP_WORDS[COMP_CWORD]} program=${COMP_WORDS[0]} help
  if [ "$COMP_CWORD" = 1 ]; then
    help=$("$program" --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\).*/\1/p')
    COMPREPLY=($(compgen -W "$help --help --version" -- "$word"))
  elif [[ $word == -* ]]; then
    help=$("$program" "${COMP_WORDS[1]}" --help 2>/dev/null | grep -o -- '--[a-z-]*')
    COMPREPLY=($(compgen -W "$help" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}
complete -o filenames -o default -F _orris orris
