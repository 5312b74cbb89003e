# awk -v program=PATH -v date=DATE -v page=PATH -f man_page.awk TEMPLATE
# Writes a manual page: the template, and in place of these lines of it what the program's --help and --version say.
#   @TITLE@      the page's title line         @ARGUMENTS@    the arguments, a paragraph each
#   @NAME@       what the program is           @OPTIONS@      the options, likewise
#   @SYNOPSIS@   how it is called              @EXIT_STATUS@  the exit codes, which stand after the options
# The help is CLI11's: what the program does, `Usage:`, then entries in sections. An entry's head, in column 3, is names
# and what goes with them; its text begins in column 31 of the same line or, where the head is longer, of the next.

BEGIN {
  readHelp("'" program "' --help")
  versionCommand = "'" program "' --version"
  versionCommand | getline version
}

$0 == "@TITLE@" { put(".TH " plain(toupper(name)) " 1 " date " \"" version "\" \"User Commands\""); next }
$0 == "@NAME@" { put(plain(name) " \\- " plain(tolower(substr(purpose, 1, 1)) substr(purpose, 2))); next }
$0 == "@SYNOPSIS@" { put(".B " plain(name) "\n" plain(usage)); next }
$0 == "@ARGUMENTS@" { putEntries("Positionals:"); next }
$0 == "@OPTIONS@" { putEntries("Options:"); next }
$0 == "@EXIT_STATUS@" { putExitCodes(); next }
{ put($0) }

function put(text) { print text > page }

function fail(problem) {
  print "man_page.awk: " program ": " problem > "/dev/stderr"
  exit 1
}

function readHelp(command,    line, section) {
  while ((command | getline line) > 0) {
    if (line ~ /^Usage: /) readUsage(line)
    else if (usage == "") purpose = joined(purpose, line)
    else if (line ~ /^(Positionals|Options):$/) section = line
    else if (line ~ /^  /) readEntryLine(section, line)
    else footer = joined(footer, line)
  }
  sub(/\.$/, "", purpose)
  if (close(command) != 0 || entries["Options:"] == 0 || footer !~ /Exit codes: 0 /) fail("its --help is not understood")
}

function readUsage(line,    words) {
  split(line, words, " ")
  name = words[2]
  usage = substr(line, length("Usage: " name " ") + 1)
  sub(/\[OPTIONS\]/, "[options]", usage)
}

function readEntryLine(section, line,    n) {
  if (substr(line, 1, 30) ~ /^ +$/) {
    n = entries[section]
    text[section, n] = joined(text[section, n], substr(line, 31))
    return
  }
  n = ++entries[section]
  head[section, n] = substr(line, 3)
  if (match(head[section, n], /  +/)) {
    text[section, n] = substr(head[section, n], RSTART + RLENGTH)
    head[section, n] = substr(head[section, n], 1, RSTART - 1)
  }
}

function joined(a, b) { return a == "" || b == "" ? a b : a " " b }

function putEntries(section,    i) {
  for (i = 1; i <= entries[section]; ++i) {
    put(".TP")
    if (section == "Options:") putOption(head[section, i], text[section, i])
    else putArgument(head[section, i], text[section, i])
  }
}

function putOption(head, text,    names, notes) {
  names = head
  sub(/ .*/, "", names)
  gsub(/,/, ", ", names)
  notes = readHead(head)
  put(marked(names) (value == "" ? "" : " \\fI" plain(value) "\\fR"))
  put(marked(joined(withStop(text), notes)))
}

function putArgument(head, text) {
  readHead(head)
  sub(/ .*/, "", head)
  put("\\fI" plain(head) "\\fR")
  put(marked(joined(withStop(text), excluded)))
}

# Reads the head from its end, where CLI11 puts what it checks: `value` is what the option takes, or nothing. Returns
# the sentences that say what is allowed.
function readHead(head,    needed, preset, allowed, required) {
  value = substr(head, index(head " ", " ") + 1)
  excluded = take(" ?Excludes: .*$") ? listed("Not with", substr(word, index(word, ":") + 2)) : ""
  needed = take(" ?Needs: .*$") ? listed("Only with", substr(word, index(word, ":") + 2)) : ""
  take(" x [0-9]+$")  # so many values, which the name of the value shows
  required = take(" ?REQUIRED$") ? "Must be given." : ""
  preset = take("=[^ ]*$") ? "Default: " substr(word, 2) "." : ""
  if (take(":[A-Z]+ in \\[.*\\]$")) allowed = range(word)
  else if (take(":NONNEGATIVE$")) allowed = "At least 0."
  else if (take(":POSITIVE$")) allowed = "Above 0."
  else if (take(":[{].*[}]$")) allowed = listed("One of", substr(word, 3, length(word) - 3))
  return joined(joined(required, allowed), joined(preset, joined(needed, excluded)))
}

# Moves what the pattern matches from `value` to `word`.
function take(pattern) {
  if (!match(value, pattern)) return 0
  word = substr(value, RSTART, RLENGTH)
  value = substr(value, 1, RSTART - 1) substr(value, RSTART + RLENGTH)
  return 1
}

function listed(beginning, words) {
  gsub(/[ ,]+/, ", ", words)
  return beginning " " words "."
}

function range(check) {
  sub(/^:U?INT in /, "An integer ", check)
  sub(/^:[A-Z]+ in /, "A number ", check)
  sub(/\[/, "from ", check)
  sub(/ - /, " to ", check)
  sub(/\]$/, ".", check)
  return check
}

function putExitCodes(    codes, parts, n, i) {
  if (index(footer, "Exit codes: ") > 1) put(marked(substr(footer, 1, index(footer, " Exit codes: ") - 1)))
  codes = footer
  sub(/.*Exit codes: /, "", codes)
  sub(/\.$/, "", codes)
  n = split(codes, parts, /, /)
  for (i = 1; i <= n; ++i) {
    if (parts[i] ~ /^[0-9]/) {
      put(".TP\n" substr(parts[i], 1, index(parts[i], " ") - 1))
      sub(/^[0-9]+ /, "", parts[i])
    }
    # Where no code follows, the comma was one of the meaning's own.
    put(plain(parts[i]) (i < n && parts[i + 1] !~ /^[0-9]/ ? "," : ""))
  }
}

function withStop(text) { return text == "" || text ~ /[.!?]$/ ? text : text "." }

# Text as roff shows it; a line of it must not begin with a dot or a quote, which make it a request.
function plain(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  if (text ~ /^[.']/) text = "\\&" text
  return text
}

# The same with the names of options in bold.
function marked(text,    result) {
  text = " " plain(text)
  while (match(text, /[ ,(]\\-(\\-)?[a-z][a-z\\-]*/)) {
    result = result substr(text, 1, RSTART) "\\fB" substr(text, RSTART + 1, RLENGTH - 1) "\\fR"
    text = substr(text, RSTART + RLENGTH)
  }
  return substr(result text, 2)
}
