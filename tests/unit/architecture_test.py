#!/usr/bin/env python3
"""Whether the drawing in docs/architecture.md is what CMake draws of its targets.

architecture_test.py BUILD [--update]: compares it with BUILD/rooms.mmd, or puts that into the document.
"""
import pathlib
import sys

DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "architecture.md"
BEGIN, END = "```mermaid\n", "```\n"


def main():
    drawing = (pathlib.Path(sys.argv[1]) / "rooms.mmd").read_text()
    text = DOCUMENT.read_text()
    before, begin, rest = text.partition(BEGIN)
    held, end, after = rest.partition(END)
    if not begin or not end:
        sys.exit(f"{DOCUMENT} has no block that begins with {BEGIN.strip()}")
    if sys.argv[2:] == ["--update"]:
        DOCUMENT.write_text(before + begin + drawing + end + after)
    elif held != drawing:
        sys.exit(f"{DOCUMENT} does not hold what CMake draws:\n{drawing}\nRun {sys.argv[0]} {sys.argv[1]} --update")


if __name__ == "__main__":
    main()
