# What tests of the command line have in common; they source it.
failures=0
checks=0

# expect CODES TEXT COMMAND...: the command exits with one of CODES, separated by |, and prints TEXT, an extended
# regular expression, to stderr; an empty TEXT matches anything.
expect() {
  local codes=$1 text=$2
  shift 2
  "$@" >stdout 2>stderr
  local actual=$?
  checks=$((checks + 1))
  if ! [[ "$actual" =~ ^($codes)$ ]] || { [ -n "$text" ] && ! grep -qE -- "$text" stderr; }; then
    failures=$((failures + 1))
    echo "FAILED: $*: exit code $actual, expected $codes; stderr, expected /$text/:"
    cat stderr
  fi
}

# holds TEXT COMMAND...: the command succeeds.
holds() {
  local what=$1
  shift
  checks=$((checks + 1))
  if ! "$@" >/dev/null 2>&1; then
    failures=$((failures + 1))
    echo "FAILED: $what"
  fi
}
