"""The commands and options in the project's documents."""
import re


def documents(source):
    """Those in which commands and options are looked for. A change log speaks of what was."""
    found = [*source.glob("*.md"), *source.glob("docs/*.md"), *source.glob("scenes/*.md")]
    return sorted(file for file in found if file.name != "CHANGELOG.md")


def blocks(text):
    """(line, what stands after ```, lines) of each block of code; of an indented one None stands there."""
    found, block, fence = [], None, False
    for number, line in enumerate(text.split("\n"), 1):
        if line.startswith("```"):
            fence = not fence
            block = (number, line[3:].strip(), []) if fence else None
            if fence:
                found.append(block)
        elif fence:
            block[2].append(line)
        elif line.startswith("    ") and line.strip():
            if block is None:
                block = (number, None, [])
                found.append(block)
            block[2].append(line[4:])
        elif line.strip():
            block = None
    return found


def spans(text):
    """The code in running text."""
    prose = re.sub(r"^```.*?^```$|^    .*$", "", text, flags=re.DOTALL | re.MULTILINE)
    return [" ".join(span.split()) for span in re.findall(r"`([^`]+)`", prose)]
