#!/usr/bin/env python3
"""structure_test.py [--table] [--root DIR]: whether files and parameter lists are short enough to be read at once.

Fails by name where a C++ source file of host, tests or tools has more than 300 lines, a header or shader more than 150,
or a function of C++ or GLSL more than six parameters. --table prints what there is in place of judging it: for every
folder its files and lines, the largest files, the longest functions and the longest parameter lists. DIR is another
checkout to look at, also one from before this test.
"""
import argparse
import collections
import pathlib
import re
import sys

SOURCE_LINES, HEADER_LINES, PARAMETERS = 300, 150, 6
SOURCES, HEADERS = {".cpp"}, {".hpp", ".h", ".glsl", ".comp"}
FOLDERS = ("host", "shaders", "tests", "tools")
# Files and functions that may be longer, with the reason.
EXCEPTIONS = {
    "shaders/interface.h": "as long as the layout that host and shader share",
}

Function = collections.namedtuple("Function", "file line name parameters lines")

# Comments, literals and preprocessor lines, in which brackets mean nothing. Literals first: they may hold `//`.
IGNORED = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|//[^\n]*|/\*.*?\*/'
                     r'|^[ \t]*#(?:\\\n|[^\n])*', re.DOTALL | re.MULTILINE)
DIGIT_SEPARATOR = re.compile(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])")
# Words in front of a bracket that is no list of parameters.
NO_FUNCTION = {"alignas", "decltype", "explicit", "if", "layout", "noexcept", "requires", "static_assert"}
TYPE_OR_NAMESPACE = re.compile(r"^(?:\s|typedef\b|inline\b|\[\[.*?\]\])*(?:enum|struct|class|union|namespace|extern)\b")


def blanked(text):
    """The text with what IGNORED matches replaced by blanks, line by line as it was."""
    text = DIGIT_SEPARATOR.sub("0", text)
    return IGNORED.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def closing(text, start):
    """The position of the bracket that closes the one at `start`; the text's end where none does."""
    depth = 0
    for match in re.compile(r"[(){}\[\]]").finditer(text, start):
        depth += 1 if match.group() in "({[" else -1
        if depth == 0:
            return match.start()
    return len(text) - 1


def without_templates(text):
    """The text with each <...> of a template blanked, which may hold commas and brackets."""
    text = re.sub(r"operator\s*(?:<=>|<<=?|>>=?|<=?|>=?|->)", lambda match: match.group()[:8].ljust(len(match.group()), "_"),
                  text)
    text = re.sub(r"->|<=|>=|<<", "  ", text)
    while True:
        shorter = re.sub(r"<[^<>]*>", lambda match: " " * len(match.group()), text)
        if shorter == text:
            return text
        text = shorter


def count_parameters(text):
    text = without_templates(text)
    if text.strip() in ("", "void"):
        return 0
    depth, count = 0, 1
    for letter in text:
        depth += (letter in "({[") - (letter in ")}]")
        count += letter == "," and depth == 0
    return count


def signature(head):
    """Name, position and parameters of the function that `head` declares; None where it declares none."""
    text = without_templates(head)
    for match in re.finditer(r"(operator\s*(?:\(\s*\)|[^\s\w(]+)|[\w~]+)\s*\(", text):
        name = match.group(1)
        if name in NO_FUNCTION:
            continue
        if re.search(r"(?<![=!<>])=(?!=)", text[: match.start()]):
            return None  # the value of a variable
        end = closing(text, match.end() - 1)
        return name, match.start(), count_parameters(head[match.end() : end])
    return None


def functions(text, name):
    """The functions that a file declares or defines, and the lambdas in them."""
    text = blanked(text)
    found = []

    def line_of(position):
        return text.count("\n", 0, position) + 1

    def add(start, end, body_end):
        what = signature(text[start:end])
        if what and not re.fullmatch(r"[A-Z][A-Z0-9_]*", what[0]):  # macros, other than tests
            at = line_of(start + what[1])
            found.append(Function(name, at, what[0], what[2], line_of(body_end) - at + 1 if body_end else 0))
        elif what and body_end:
            at = line_of(start + what[1])
            found.append(Function(name, at, " ".join(text[start:end].split())[-60:], 0, line_of(body_end) - at + 1))

    def lambdas(start, end):
        for match in re.compile(r"\]\s*\(").finditer(text, start, end):
            close = closing(text, match.end() - 1)
            if re.match(r"\s*(?:mutable|noexcept|->[^{;]*|\s)*\{", text[close + 1 : close + 200]):
                found.append(Function(name, line_of(match.start()), "a lambda",
                                      count_parameters(text[match.end() : close]), 0))

    start = at = 0
    boundary = re.compile(r"[{};(]")
    while match := boundary.search(text, at):
        position, letter = match.start(), match.group()
        at = position + 1
        if letter == "(":
            at = closing(text, position) + 1
        elif letter == "}":
            start = at
        elif letter == ";":
            add(start, position, None)
            start = at
        else:
            head = text[start:position]
            opens = TYPE_OR_NAMESPACE.match(re.sub(r"template\s*", "", without_templates(head))) and "(" not in head
            if opens or re.search(r"\bnamespace(\s+[\w:]+)?\s*$", head):
                start = at  # its members follow
                continue
            end = closing(text, position)
            initialises = re.search(r"\)\s*(?:noexcept\s*)?:(?!:)", head) and re.search(r"[\w>]\s*$", head)
            if initialises:
                at = end + 1  # of a constructor's member, the body is still to come
                continue
            if signature(head):
                add(start, position, end)
                start = end + 1
            lambdas(position, end)
            at = end + 1
    return found


SAMPLE = """
namespace a { struct Store { int x = f(1, 2, 3, 4, 5, 6, 7);
  explicit Store(int a, std::map<int, int> b = {}) : x{a}, y(b) { g(1); }
  void operator()(int a, int b, int c) const; static constexpr int kN[] = {1, 2}; }; }
template <typename A, typename B> auto seven(A a, B b, int c, int d, int e, int f, std::function<void(int, int)> g) {
  const auto eight = [&](int a, int b, int c, int d, int e, int f, int g, int h) { return ","; };  // (a, b)
}
layout(local_size_x = 8, local_size_y = 8) in;
bool hit(Ray ray, inout float t) { if (t > 1) { return false; } }
int none(void);
"""
SAMPLE_SIGNATURES = {("Store", 2), ("operator()", 3), ("seven", 7), ("a lambda", 8), ("hit", 2), ("none", 0)}


def files_of(root):
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in SOURCES | HEADERS and file.is_file():
                yield file, str(file.relative_to(root))


def print_table(lines, found):
    folders = collections.defaultdict(list)
    for name, count in lines.items():
        folders[str(pathlib.Path(name).parent)].append(count)
    print(f"{'folder':<28} files  lines  largest")
    for folder, counts in sorted(folders.items()):
        print(f"{folder:<28} {len(counts):5}  {sum(counts):5}  {max(counts):7}")
    print(f"{'all':<28} {len(lines):5}  {sum(lines.values()):5}")
    for what, suffixes in (("source", SOURCES), ("header or shader", HEADERS)):
        largest = sorted(((count, name) for name, count in lines.items() if pathlib.Path(name).suffix in suffixes),
                         reverse=True)
        print(f"largest {what} files:", ", ".join(f"{name} {count}" for count, name in largest[:4]))
    longest = sorted(found, key=lambda function: -function.lines)[:4]
    print("longest functions:", ", ".join(f"{f.name} {f.lines} ({f.file}:{f.line})" for f in longest))
    most = sorted(found, key=lambda function: -function.parameters)[:4]
    print("most parameters:", ", ".join(f"{f.name} {f.parameters} ({f.file}:{f.line})" for f in most))
    print(f"{len(found)} signatures, {sum(f.parameters > PARAMETERS for f in found)} of more than {PARAMETERS} "
          f"parameters; {sum(f.lines > 50 for f in found)} functions of more than 50 lines")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--table", action="store_true")
    arguments = parser.parse_args()

    lines, found = {}, []
    for file, name in files_of(arguments.root):
        text = file.read_text(errors="replace")
        lines[name] = text.count("\n")
        found += functions(text, name)
    if arguments.table:
        print_table(lines, found)
        return 0
    faults = []
    sample = {(function.name, function.parameters) for function in functions(SAMPLE, "sample")}
    if sample != SAMPLE_SIGNATURES:
        faults.append(f"of the sample this test reads {sorted(sample)}, expected are {sorted(SAMPLE_SIGNATURES)}")
    for name, count in lines.items():
        limit = SOURCE_LINES if pathlib.Path(name).suffix in SOURCES else HEADER_LINES
        if count > limit and name not in EXCEPTIONS:
            faults.append(f"{name}: {count} lines, allowed are {limit}")
    for function in found:
        if function.parameters > PARAMETERS and f"{function.file} {function.name}" not in EXCEPTIONS:
            faults.append(f"{function.file}:{function.line}: {function.name} has {function.parameters} parameters, "
                          f"allowed are {PARAMETERS}")
    for exception in EXCEPTIONS:
        if exception.split()[0] not in lines:
            faults.append(f"{exception}: an exception for a file that is not there")
    for fault in faults:
        print(f"FAILED: {fault}")
    print(f"{len(lines)} files, {len(found)} signatures, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
