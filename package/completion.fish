# Completion of epure for fish: verbs, options, exercises, sheets, givens and quantities, as they were in the program
# that this file was made with (package/completion.h says what its lines hold).

function __epure_lines
  echo -n '
@lines@
'
end

# __epure_words FIELD...: of the lines that begin with these fields, the next one, and behind a tabulator what it means.
function __epure_words
  __epure_lines | awk -F '\t' '
    BEGIN { for (n = ARGC - 1; ++i <= n;) { field[i] = ARGV[i]; ARGV[i] = "" } }
    { for (i = 1; i <= n; ++i) if ($i != field[i]) next
      print $(n + 1) (NF > n + 1 ? "\t" $NF : "") }' $argv
end

# __epure_of_named KIND: of the exercises on the command line; of all, where none is there.
function __epure_of_named
  set -l ids (__epure_words exercise | cut -f 1)
  set -l named
  for word in (commandline -opc)[3..-1]
    set -l id (string replace -r '/.*' '' -- $word)
    contains -- $id $ids; and set -a named $id
  end
  set -q named[1]; or set named $ids
  for id in $named
    __epure_words $argv[1] $id
  end | sort -u
end

# __epure_joined MARK: what stands on the command line up to its last MARK, before each of the lines read.
function __epure_joined
  set -l before (string match -r ".*$argv[1]" -- (commandline -ct | string replace -r '^--[^=]*=' ''))
  while read -l line
    echo "$before$line"
  end
end

# An "=" behind the word, before what it means.
function __epure_assigned
  while read -l line
    string replace -r '^([^\t]*)' '$1=' -- $line
  end
end

function __epure_names
  set -l verb (commandline -opc)[2]
  switch $verb
    case bench import
      return
    case draw class
      if string match -q '*/*' -- (commandline -ct)
        set -l id (string replace -r '/.*' '' -- (commandline -ct))
        __epure_words sheet $id | __epure_joined /
        return
      end
  end
  __epure_words exercise
  contains -- $verb draw list check booklet; and printf 'all\tevery exercise\n'
end

function __epure_has_verb
  set -l words (commandline -opc)
  set -q words[2]
end

# __epure_is_verb VERB
function __epure_is_verb
  set -l words (commandline -opc)
  set -q words[2]; and test "$words[2]" = $argv[1]
end

function __epure_values # VERB OPTION TYPE
  switch $argv[3]
    case SHEET
      __epure_of_named sheet
    case 'SYMBOL=*'
      __epure_of_named given | __epure_assigned
    case 'NAME=*'
      __epure_of_named quantity | __epure_assigned
    case NAMES
      __epure_of_named quantity | __epure_joined ,
    case FORMATS
      __epure_words value $argv[1] $argv[2] | __epure_joined ,
    case '*'
      __epure_words value $argv[1] $argv[2]
  end
end

complete -c epure -f
complete -c epure -n 'not __epure_has_verb' -a '(__epure_words verb)'
complete -c epure -n 'not __epure_has_verb' -a help -d 'explain a verb'
complete -c epure -n '__epure_is_verb help' -a '(__epure_words verb)'
complete -c epure -n '__epure_has_verb; and not __epure_is_verb help' -a '(__epure_names)'
__epure_lines | string match -e -r '^option\t' | while read -d \t -l kind verb name type meaning
  set -l condition "__epure_is_verb $verb"
  test $verb = -; and set condition 'not __epure_has_verb'
  set -l spelling -s (string sub -s 2 -- $name)
  string match -q -- '--*' $name; and set spelling -l (string sub -s 3 -- $name)
  switch $type
    case -
      complete -c epure -n $condition $spelling -d $meaning
    case FILE
      complete -c epure -n $condition $spelling -d $meaning -r -F
    case DIR
      complete -c epure -n $condition $spelling -d $meaning -x -a '(__fish_complete_directories)'
    case '*'
      complete -c epure -n $condition $spelling -d $meaning -x -a "(__epure_values $verb $name '$type')"
  end
end
