#!/usr/bin/env bash
# man_test.sh PROGRAMS PAGES: the manual pages that were built have no errors, and all of what the programs'
# tables of options say; so has --help.
# Exits with 77 (skipped) where there is no groff to show a page.
set -u
programs=$1 pages=$2
if ! command -v groff >/dev/null; then
  echo "skipped: groff is missing"
  exit 77
fi
failures=0
checks=0

# holds WHAT COMMAND...: the command succeeds.
holds() {
  checks=$((checks + 1))
  "${@:2}" >/dev/null && return
  failures=$((failures + 1))
  echo "FAILED: $1"
}

# prints_nothing COMMAND...
prints_nothing() {
  local printed
  printed=$("$@" 2>&1)
  [ -z "$printed" ] || { printf '%s\n' "$printed" >&2; return 1; }
}

for program in lavaray lavaray-diff lavaray-merge; do
  page=$pages/$program.1
  holds "$program.1 is compressed as it is" diff <(gzip -dc "$page.gz") "$page"
  holds "$program.1 has no errors" prints_nothing groff -man -ww -z -Tutf8 "$page"
  if command -v mandoc >/dev/null; then
    holds "$program.1 has no errors by mandoc" prints_nothing mandoc -T lint -W warning "$page"
  fi
  # One word a line, as words are broken and blanks put in between them to fill the lines.
  words=$(groff -man -Tascii -P-bcou -rLL=10000n -rHY=0 "$page" | tr -s ' \n' '\n')
  holds "$program.1 keeps no placeholder" test -z "$(grep '^@' <<<"$words")"
  holds "$program.1 has the version" grep -qxF "$("$programs/$program" --version | cut -d' ' -f2)" <<<"$words"

  table=$("$programs/$program" --help-table)
  # fields KIND NUMBER: that field of each line of the kind.
  fields() { awk -F'\t' -v kind="$1" -v number="$2" '$1 == kind { print $number }' <<<"$table"; }
  options=$(fields option 2 | tr -d ' ' | tr ',' '\n')
  holds "$program has options" test "$(wc -w <<<"$options")" -gt 4
  for option in $options; do
    holds "$program.1 has $option" grep -qE -- "^$option,?$" <<<"$words"
  done
  # What the table says, word for word.
  text=$(tr '\n' ' ' <<<"$words")
  descriptions=$(fields option 5; fields argument 5)
  codes=$(fields footer 2 | sed 's/.*Exit codes//' | grep -oE '[:,] [0-9]+ [a-z]+' | cut -c3-)
  holds "$program has exit codes" test "$(wc -l <<<"$codes")" -gt 3
  while IFS= read -r part; do
    holds "$program.1 has: $part" grep -qF -- " $part" <<<"$text"
  done <<<"$descriptions"$'\n'"$codes"
  # The help is the same table, broken into lines.
  help=$("$programs/$program" --help)
  holds "$program --help has lines of at most 80 columns" test -z "$(grep -E '.{81}' <<<"$help")"
  help=$(tr -s ' \n' ' ' <<<"$help")
  while IFS=$'\t' read -r kind names takes allowed description; do
    [ "$kind" = option ] || continue
    [ "$takes" = - ] || names+=" $takes"
    holds "$program --help has: $names $description" grep -qF -- " $names $description " <<<"$help "
  done <<<"$table"
done

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
