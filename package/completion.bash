# Completion of epure for bash: verbs, options, exercises, sheets, givens and quantities, as they were in the program
# that this file was made with (package/completion.h says what its lines hold).

_epure_lines() {
  cat << 'end of lines'
@lines@
end of lines
}

# _epure_words FIELD...: of the lines that begin with these fields, the next one.
_epure_words() {
  _epure_lines | awk -F '\t' '
    BEGIN { for (n = ARGC - 1; ++i <= n;) { field[i] = ARGV[i]; ARGV[i] = "" } }
    { for (i = 1; i <= n; ++i) if ($i != field[i]) next; print $(n + 1) }' "$@"
}

# _epure_of_named KIND: of the exercises on the command line; of all, where none is there.
_epure_of_named() {
  local word id named=
  for word in "${COMP_WORDS[@]:2}"; do
    for id in $(_epure_words exercise); do
      [ "${word%%/*}" = "$id" ] && named="$named $id"
    done
  done
  for id in ${named:-$(_epure_words exercise)}; do _epure_words "$1" "$id"; done | sort -u
}

# _epure_offer [-P PREFIX] [-S SUFFIX] WORDS
_epure_offer() {
  local words=${*: -1}
  mapfile -t COMPREPLY < <(compgen -W "$words" "${@:1:$#-1}" -- "$cur")
}

# What a comma stands before already is kept.
_epure_offer_list() {
  local before=
  case $cur in *,*) before=${cur%,*}, cur=${cur##*,} ;; esac
  _epure_offer -P "$before" "$1"
  compopt -o nospace
}

_epure_offer_assignment() {
  _epure_offer -S = "$1"
  compopt -o nospace
}

_epure_offer_names() { # of VERB
  case $1 in
    bench | import) return ;;
    draw | class)
      case $cur in
        */*)
          local id=${cur%%/*}
          cur=${cur#*/}
          _epure_offer -P "$id/" "$(_epure_words sheet "$id")" ;;
        *) _epure_offer "$(_epure_words exercise) all" ;;
      esac ;;
    list | check | booklet) _epure_offer "$(_epure_words exercise) all" ;;
    *) _epure_offer "$(_epure_words exercise)" ;;
  esac
}

_epure() {
  local verb=${COMP_WORDS[1]} cur=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} type words
  # Bash takes "--paper=a3" for three words, and "r=25cm" too, of which nothing can be known.
  if [ "$cur" = = ]; then
    cur=
  elif [ "$before" = = ]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  case ${COMP_WORDS[COMP_CWORD]}$before in =[!-]*) return ;; esac
  [ "${COMP_WORDS[COMP_CWORD - 1]}" = = ] && [ "${before#-}" = "$before" ] && return

  if [ "$COMP_CWORD" = 1 ]; then
    _epure_offer "$(_epure_words verb) help $(_epure_words option -)"
    return
  elif [ "$verb" = help ]; then
    [ "$COMP_CWORD" = 2 ] && _epure_offer "$(_epure_words verb)"
    return
  fi

  type=$(_epure_words option "$verb" "$before")
  words=$(_epure_words value "$verb" "$before")
  case $type in
    '' | -)
      case $cur in
        -*) _epure_offer "$(_epure_words option "$verb")" ;;
        *) _epure_offer_names "$verb" ;;
      esac ;;
    FILE)
      compopt -o filenames
      mapfile -t COMPREPLY < <(compgen -f -- "$cur") ;;
    DIR)
      compopt -o filenames
      mapfile -t COMPREPLY < <(compgen -d -- "$cur") ;;
    SHEET) _epure_offer "$(_epure_of_named sheet)" ;;
    SYMBOL=*) _epure_offer_assignment "$(_epure_of_named given)" ;;
    NAME=*) _epure_offer_assignment "$(_epure_of_named quantity)" ;;
    NAMES) _epure_offer_list "$(_epure_of_named quantity)" ;;
    FORMATS) _epure_offer_list "$words" ;;
    *) _epure_offer "$words" ;;
  esac
}

complete -F _epure epure
