#!/usr/bin/env bash
# completion_test.sh PROGRAMS COMPLETION SCRATCH: what bash offers for a command line, by the completion file.
set -u
programs=$1 completion=$2 scratch=$3
rm -rf "$scratch" && mkdir -p "$scratch/folder" && cd "$scratch" || exit 1
touch scene.txt 'my scene.txt' mesh.obj picture.png picture.pfm picture.exr part.film report.json page.html folder/inner.txt
PATH=$programs:$PATH
source "$completion"
failures=0
checks=0

# offers LINE EXPECTED...: for the last word of LINE, whose words are parted by spaces, exactly these are offered.
offers() {
  local line=$1 expected actual
  shift
  read -ra COMP_WORDS <<<"$line"
  [[ $line == *' ' ]] && COMP_WORDS+=('')
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  local registered
  registered=$(complete -p "${COMP_WORDS[0]}") || registered=
  "$(sed 's/.*-F \([^ ]*\) .*/\1/' <<<"$registered")"
  expected=$(printf '%s\n' "$@" | sort)
  actual=$(printf '%s\n' "${COMPREPLY[@]}" | sort)
  checks=$((checks + 1))
  if [ "$actual" != "$expected" ]; then
    failures=$((failures + 1))
    printf 'FAILED: "%s" offers\n%s\nexpected\n%s\n' "$line" "$actual" "$expected"
  fi
}

# The options of each program are those of its table.
for program in lavaray lavaray-diff lavaray-merge; do
  options=$("$program" --help-table | awk -F'\t' '$1 == "option" { print $2 }' | tr -d ' ' | tr ',' '\n')
  [ "$(wc -w <<<"$options")" -gt 4 ] || { echo "FAILED: $program --help-table has few options: $options"; exit 1; }
  offers "$program -" $options
  offers "$program x --" $(grep -e -- <<<"$options")
done
offers 'lavaray --vie' --view
offers 'lavaray --watch --shad' --shaders
offers 'lavaray --no-such'

# Names: those that the program allows.
offers 'lavaray --sampler ' sobol random
offers 'lavaray --sampler r' random
offers 'lavaray --sampler = r' random
offers 'lavaray --sampler =' sobol random
offers 'lavaray scene.txt --view s' samples shadow
offers 'lavaray --filter ' box tent gaussian blackman-harris
offers 'lavaray --layers ' normal depth object samples error
offers 'lavaray --layers depth,n' depth,normal
offers 'lavaray --layers = depth,object,s' depth,object,samples
views=$(lavaray --view x 2>&1 | sed -n 's/.*allowed are \([^;]*\);.*/\1/p' | tr -d ,)
offers 'lavaray --view ' $views
for view in $views; do
  checks=$((checks + 1))
  lavaray --view "$view" 2>&1 | grep -q 'SCENE is missing' && continue
  failures=$((failures + 1))
  echo "FAILED: the view $view is offered, but not allowed"
done

# Files
offers 'lavaray ' scene.txt 'my scene.txt' folder
offers 'lavaray --stats s' scene.txt
offers 'lavaray my\' 'my scene.txt'
offers 'lavaray "my' 'my scene.txt'
offers 'lavaray folder/' folder/inner.txt
offers 'lavaray scene.txt -o ' picture.png picture.pfm picture.exr part.film folder
offers 'lavaray scene.txt --output = pic' picture.png picture.pfm picture.exr
offers 'lavaray --resume ' part.film folder
offers 'lavaray --checkpoint p' part.film
offers 'lavaray --json ' report.json folder
offers 'lavaray --shaders ' folder
offers 'lavaray-diff ' picture.png picture.pfm picture.exr folder
offers 'lavaray-diff picture.png pic' picture.png picture.pfm picture.exr
offers 'lavaray-diff a.png b.png -o ' picture.png picture.pfm picture.exr folder
offers 'lavaray-diff a.png b.png --report ' page.html folder
offers 'lavaray-diff --from ' report.json folder
offers 'lavaray-merge part.film ' part.film folder
offers 'lavaray-merge -o p' picture.png picture.pfm picture.exr

# Numbers and the like are not guessed; what takes nothing is followed by an argument.
offers 'lavaray --width '
offers 'lavaray --crop 1'
offers 'lavaray --device '
offers 'lavaray --normalize ' scene.txt 'my scene.txt' folder

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
