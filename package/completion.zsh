#compdef epure
# Completion of epure for zsh: verbs, options, exercises, sheets, givens and quantities, as they were in the program
# that this file was made with (package/completion.h says what its lines hold).

_epure_lines() {
  cat << 'end of lines'
@lines@
end of lines
}

# _epure_words FIELD...: of the lines that begin with these fields, the next one, and behind a colon what it means.
_epure_words() {
  _epure_lines | awk -F '\t' '
    BEGIN { for (n = ARGC - 1; ++i <= n;) { field[i] = ARGV[i]; ARGV[i] = "" } }
    { for (i = 1; i <= n; ++i) if ($i != field[i]) next
      print $(n + 1) (NF > n + 1 ? ":" $NF : "") }' "$@"
}

# _epure_offer WHAT WORDS [OPTIONS OF compadd]
_epure_offer() {
  local -a offered=(${(f)2})
  _describe "$1" offered "${@:3}"
}

# _epure_of_named KIND: of the exercises on the command line; of all, where none is there.
_epure_of_named() {
  local -a ids=(${(f)"$(_epure_words exercise)"}) named
  ids=(${ids%%:*})
  local word id
  for word in ${words[3,-1]}; do
    (($ids[(Ie)${word%%/*}])) && named+=(${word%%/*})
  done
  for id in ${named:-$ids}; do _epure_words $1 $id; done | sort -u -t : -k 1,1
}

_epure_offer_names() { # of VERB
  local ids="$(_epure_words exercise)"
  case $1 in
    bench | import) return 1 ;;
    draw | class)
      if compset -P 1 '*/'; then
        _epure_offer sheet "$(_epure_words sheet ${IPREFIX%/})"
      else
        _epure_offer exercise "$ids"$'\nall:every exercise'
      fi ;;
    list | check | booklet) _epure_offer exercise "$ids"$'\nall:every exercise' ;;
    *) _epure_offer exercise "$ids" ;;
  esac
}

_epure() {
  local verb=$words[2] before=$words[CURRENT-1] type of_type
  if ((CURRENT == 2)); then
    _epure_offer verb "$(_epure_words verb)"$'\nhelp:explain a verb'
    [[ $PREFIX == -* ]] && _epure_offer option "$(_epure_words option -)"
    return
  elif [[ $verb == help ]]; then
    ((CURRENT == 3)) && _epure_offer verb "$(_epure_words verb)"
    return
  fi
  if [[ $PREFIX == --*=* ]]; then
    before=${PREFIX%%=*}
    compset -P 1 '*='
  fi

  type=$(_epure_words option $verb $before)
  type=${type%%:*}
  of_type=$(_epure_words value $verb $before)
  case $type in
    '' | -)
      if [[ $PREFIX == -* ]]; then
        _epure_offer option "$(_epure_words option $verb)"
      else
        _epure_offer_names $verb
      fi ;;
    FILE) _files ;;
    DIR) _files -/ ;;
    SHEET) _epure_offer sheet "$(_epure_of_named sheet)" ;;
    SYMBOL=*) [[ $PREFIX != *=* ]] && _epure_offer given "$(_epure_of_named given)" -S = ;;
    NAME=*) [[ $PREFIX != *=* ]] && _epure_offer quantity "$(_epure_of_named quantity)" -S = ;;
    NAMES)
      compset -P '*,'
      _epure_offer quantity "$(_epure_of_named quantity)" -S '' ;;
    FORMATS)
      compset -P '*,'
      _epure_offer format "$of_type" -S '' ;;
    *) [[ -n $of_type ]] && _epure_offer value "$of_type" ;;
  esac
}

_epure "$@"
