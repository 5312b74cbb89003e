#!/usr/bin/env python3
"""document_options_test.py PROGRAMS SOURCE: whether the documents and the programs know the same options, and what else
the documents say of them. (man_test.sh and completion_test.sh hold the manual pages and the completion against the same
tables.)"""
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, demand, finish
from documents import blocks, documents, spans

programs, source = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
# The page that has all options of the program, and what its options are in by now.
PAGES = {"lavaray": "command-line.md", "lavaray-diff": "comparing-images.md", "lavaray-merge": "farm.md"}
OPTION = re.compile(r"(?<![\w-])--?[a-z][a-z-]*(?![\w-])")


def help_table(program):
    """{option: what its help says} and the text below."""
    lines = subprocess.run([programs / program, "--help-table"], capture_output=True, text=True, check=True).stdout.split("\n")
    rows = [line.split("\t") for line in lines]
    options = {name: row for row in rows if row[0] == "option" for name in row[1].split(", ")}
    demand(len(options) > 4, f"{program} has options")
    return options, next(row[1] for row in rows if row[0] == "footer")


def named(text):
    return {name for name in OPTION.findall(text)}


def first_column(page, heading):
    """Of the table that begins with this row."""
    lines = page[page.index(heading):].split("\n")[2:]
    end = next(i for i, line in enumerate(lines) if not line.startswith("|"))
    return [line.split(" | ")[0].strip("| ") for line in lines[:end]], [" | ".join(line.split(" | ")[1:]) for line in lines[:end]]


def codes(text):
    """Of a sentence such as `Exit codes: 0 fine, ..., 6 not enough memory`."""
    sentence = text[text.index("Exit codes: "):]
    return set(re.findall(r"(?<![\w.])(\d+)(?= [a-z]|, \d+| and \d+| or \d+)", sentence[:sentence.index("memory") + 120]))


tables, footers = {}, {}
for program in PAGES:
    tables[program], footers[program] = help_table(program)

# lavaray's table of options has all and no other, and the names that an option allows.
page = (source / "docs/command-line.md").read_text()
keys, texts = first_column(page, "| option | meaning |")
documented = named(" ".join(keys))
alone = set(tables["lavaray"]) - {"--help", "--quiet", "--verbose"}  # their short names stand there
check(alone <= documented, f"command-line.md has not {alone - documented}")
check(documented <= set(tables["lavaray"]), f"command-line.md has {documented - set(tables['lavaray'])}, lavaray has not")
for key, text in zip(keys, texts):
    for option in named(key):
        takes, allowed = tables["lavaray"].get(option, ["", "", "-", "-"])[2:4]
        for name in allowed.split(", ") if "NAME" in takes else []:
            check(name == "-" or re.search(rf"\b{name}\b", text), f"command-line.md does not say that {option} may be {name}")
check(codes(page) == codes(footers["lavaray"]), f"exit codes: {codes(page)}, of --help {codes(footers['lavaray'])}")
for program, name in PAGES.items():
    text = (source / "docs" / name).read_text()
    missing = {option for option in tables[program] if len(option) > 2} - named(text) - {"--help", "--version", "--quiet",
                                                                                          "--verbose", "--output"}
    check(not missing, f"{name} does not name {missing} of {program}")

# Every option that any document names is one of the program that it is given to.
tools = "\n".join(file.read_text(errors="ignore") for folder in ("tools", "tests", "findings")
                  for file in source.glob(f"{folder}/**/*") if file.is_file() and file.suffix in ("", ".py", ".cpp", ".sh"))
every = set().union(*tables.values())
looked_at = 0
for document in documents(source):
    text = document.read_text()
    commands = [line for _, kind, lines in blocks(text) if kind is None or kind.startswith("sh") for line in lines]
    for command in [*spans(text), *commands]:
        for part in re.split(r" \| |; | && ", command.split(" # ")[0]):
            part = re.sub(r"^(sudo |nice |[A-Z_]+=\S* )+", "", part)
            part, _, further = part.partition(" -- ")
            own = part.split(" ")[0]
            if own in tables:
                allowed = set(tables[own])
            elif own.startswith(("-", "tools/", "tests/")):
                allowed = every | {name for name in named(part) if f"{name}" in tools}
            else:
                continue  # another program's, or no command
            for name in named(part):
                looked_at += 1
                check(name in allowed or name in ("-h", "-R", "-L"), f"{document.name}: `{part}`: there is no {name}")
check(looked_at > 80, f"options in the documents: {looked_at}")
print(f"{looked_at} options in {len(documents(source))} documents")
finish()
