# awk -v program=PATH -v date=DATE -v page=PATH -f man_page.awk TEMPLATE
# Writes a manual page: the template, and in place of these lines of it what the program's --help-table and --version
# say (host/command_line/help.hpp has the form).
#   @TITLE@      the page's title line         @ARGUMENTS@    the arguments, a paragraph each
#   @NAME@       what the program is           @OPTIONS@      the options, likewise
#   @SYNOPSIS@   how it is called              @EXIT_STATUS@  the exit codes, which stand after the options

BEGIN {
  readTable("'" program "' --help-table")
  versionCommand = "'" program "' --version"
  versionCommand | getline version
}

$0 == "@TITLE@" { put(".TH " plain(toupper(name)) " 1 " date " \"" version "\" \"User Commands\""); next }
$0 == "@NAME@" { put(plain(name) " \\- " plain(tolower(substr(purpose, 1, 1)) substr(purpose, 2))); next }
$0 == "@SYNOPSIS@" { put(".B " plain(name) "\n" plain(usage)); next }
$0 == "@ARGUMENTS@" { put(paragraphs["argument"]); next }
$0 == "@OPTIONS@" { put(paragraphs["option"]); next }
$0 == "@EXIT_STATUS@" { putExitCodes(); next }
{ put($0) }

function put(text) { print text > page }

function fail(problem) {
  print "man_page.awk: " program ": " problem > "/dev/stderr"
  exit 1
}

function readTable(command,    fields) {
  while ((command | getline line) > 0) {
    split(line, fields, "\t")
    if (fields[1] == "program") name = fields[2]
    else if (fields[1] == "purpose") purpose = fields[2]
    else if (fields[1] == "usage") usage = fields[2]
    else if (fields[1] == "footer") footer = fields[2]
    else if (fields[1] == "argument") addParagraph("argument", "\\fI" plain(fields[2]) "\\fR", fields[5])
    else if (fields[1] == "option") addParagraph("option", marked(fields[2]) taken(fields[3]), fields[5])
    else fail("its --help-table has a line `" fields[1] "`, which is not understood")
  }
  sub(/\.$/, "", purpose)
  if (close(command) != 0 || !("option" in paragraphs) || footer !~ /Exit codes: 0 /)
    fail("its --help-table is not understood")
}

function addParagraph(kind, head, text) {
  paragraphs[kind] = paragraphs[kind] (paragraphs[kind] == "" ? "" : "\n") ".TP\n" head "\n" marked(text)
}

function taken(value) { return value == "-" ? "" : " \\fI" plain(value) "\\fR" }

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
