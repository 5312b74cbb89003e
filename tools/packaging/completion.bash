# Bash completion of lavaray, lavaray-diff and lavaray-merge. It has no list of the options: these, and what goes with
# them, it takes from what the program's --help-table prints (host/command_line/help.hpp has the form).

# _lavaray_endings NAMES TEXT: the endings of the files that an option or argument takes: those that its text has, or
# else what such files are usually called.
_lavaray_endings() {
  local named
  named=$(grep -oE '[ (]\.[a-z]+' <<<"$2" | tr -d ' (')
  case $named:$1 in
    .*) echo "$named" ;;
    :SCENE) echo .txt ;;
    :PARTS | :--checkpoint | :--resume) echo .film ;;
    :--json | :--from) echo .json ;;
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
  local kind names takes allowed text options= arguments= value= choices= endings= replies=
  # Bash takes `--option=word` apart.
  if [ "$word" = = ]; then
    word=
  elif [ "$option" = = ]; then
    option=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  while IFS=$'\t' read -r kind names takes allowed text; do
    if [ "$kind" = argument ]; then
      arguments+=" $(_lavaray_endings "$names" "$text")"
      continue
    fi
    [ "$kind" = option ] || continue
    options+=" ${names//,/}"
    if [[ " $names," == *" $option,"* && $takes != - ]]; then
      value=$takes
      choices=${allowed//,/}
      endings=$(_lavaray_endings "$names" "$text")
    fi
  done < <("$program" --help-table 2>/dev/null </dev/null)

  local unquoted=${word#[\"\']}
  unquoted=${unquoted//\\/}
  case $value:$word in
    # Names parted by commas: the last one.
    NAMES:*) replies=$(compgen -P "${word%"${word##*,}"}" -W "$choices" -- "${word##*,}") ;;
    NAME:*) replies=$(compgen -W "$choices" -- "$word") ;;
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
