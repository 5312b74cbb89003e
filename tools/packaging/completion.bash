# Bash completion of lavaray, lavaray-diff and lavaray-merge. It has no list of the options: these, and what goes with
# them, it takes from what the program's --help prints, and the names that an option takes from the message about a
# wrong one.

# Reads the help; prints a line for each option and argument: its names, the first word of what it takes (- is
# nothing), and all of the help's lines about it.
_lavaray_entries() {
  awk '
    function finish() { if (entry != "") print entry; entry = "" }
    /^  [^ ]/ {
      finish()
      takes = /^  [^ ]+ [A-Z]/ && $2 !~ /^(Needs:|Excludes:|REQUIRED)/ ? $2 : "-"
      sub(/[:=].*/, "", takes)
      entry = $1 " " takes " " $0
      next
    }
    /^   / { entry = entry " " $0; next }
    { finish() }
    END { finish() }'
}

# _lavaray_names PROGRAM OPTION: the names that the option takes.
_lavaray_names() {
  local message list='(allowed are |not in \{)([^;}]*)'
  # Without a scene: whatever the option takes, nothing is rendered.
  message=$("$1" "$2" '?' 2>&1 </dev/null)
  [[ $message =~ $list ]] && tr -s ', ' '\n' <<<"${BASH_REMATCH[2]}"
}

# _lavaray_endings NAMES TEXT: the endings of the files that an option or argument takes: those that its text has, or
# else what such files are usually called.
_lavaray_endings() {
  local named
  named=$(grep -oE '[ (]\.[a-z]+' <<<"$2" | tr -d ' (')
  case $named:$1 in
    .*) echo "$named" ;;
    :SCENE) echo .txt ;;
    :PARTS | :--checkpoint | :--resume) echo .film ;;
    :--json) echo .json ;;
  esac
}

# _lavaray_files WORD ENDING...: folders, and the files with these endings; any files where no endings are given.
_lavaray_files() {
  local word=$1 path ending
  shift
  [ $# -gt 0 ] || set -- ''
  compgen -f -- "$word" | while IFS= read -r path; do
    for ending; do
      if [[ $path == *"$ending" || -d ${path/#\~\//$HOME/} ]]; then
        printf '%s\n' "$path"
        break
      fi
    done
  done
}

_lavaray() {
  local program=${COMP_WORDS[0]/#\~\//$HOME/} word=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]}
  local entries names takes text options= arguments= value= endings= replies=
  # Bash takes `--option=word` apart.
  if [ "$word" = = ]; then
    word=
  elif [ "$option" = = ]; then
    option=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  entries=$("$program" --help 2>/dev/null </dev/null | _lavaray_entries)
  while read -r names takes text; do
    if [[ $names != -* ]]; then
      arguments+=" $(_lavaray_endings "$names" "$text")"
      continue
    fi
    options+=" ${names//,/ }"
    if [[ ,$names, == *,"$option",* && $takes != - ]]; then
      value=$takes
      endings=$(_lavaray_endings "$names" "$text")
    fi
  done <<<"$entries"

  local unquoted=${word#[\"\']}
  unquoted=${unquoted//\\/}
  case $value:$word in
    NAME:*) replies=$(compgen -W "$(_lavaray_names "$program" "$option")" -- "$word") ;;
    FILE:*) replies=$(_lavaray_files "$unquoted" $endings) ;;
    DIR:*) replies=$(compgen -d -- "$unquoted") ;;
    ?*:*) ;;
    :-*) replies=$(compgen -W "$options" -- "$word") ;;
    *) replies=$(_lavaray_files "$unquoted" $arguments) ;;
  esac
  COMPREPLY=()
  [ -z "$replies" ] || mapfile -t COMPREPLY <<<"$replies"
  case $value:$word in FILE:* | DIR:* | :[!-]* | :) compopt -o filenames 2>/dev/null ;; esac
}
complete -F _lavaray lavaray lavaray-diff lavaray-merge
