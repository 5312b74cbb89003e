#!/usr/bin/env python3
"""documents_test.py SOURCE: whether what the project's Markdown files link to, beside each other and within, is there, and
whether the parts that a tool writes have their marks, the tool, its command and the date."""

import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
source = Path(sys.argv[1]).resolve()


def prose(file):
    """The file's lines without those of code blocks, and without code in them."""
    text = re.sub(r"^```.*?^```$", "", file.read_text(), flags=re.DOTALL | re.MULTILINE)
    return [line for line in text.split("\n") if not line.startswith("    ")]


def anchors(file):
    """What GitHub makes of the file's headings."""
    heads = [line.lstrip("#").strip() for line in prose(file) if re.match("#+ ", line)]
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


documents = [*source.glob("*.md"), *source.glob("docs/*.md"), *source.glob("scenes/*.md"), *source.glob("tools/*/*.md")]
links = 0
broken = []
for document in documents:
    for target in re.findall(r"\]\(([^)\s]+)\)", "\n".join(prose(document))):
        if re.match(r"https?:", target):
            continue
        links += 1
        path, _, anchor = target.partition("#")
        file = (document.parent / path).resolve() if path else document
        if not file.exists() or not file.is_relative_to(source):
            broken.append(f"{document.relative_to(source)}: {target}: there is no such file")
        elif anchor and anchor not in anchors(file):
            broken.append(f"{document.relative_to(source)}: {target}: there is no such heading")
    if document.parent == source / "docs" and document.name not in (source / "README.md").read_text():
        reached = any(document.name in other.read_text() for other in source.glob("docs/*.md") if other != document)
        if not reached:
            broken.append(f"{document.relative_to(source)}: neither the README nor another document links to it")
parts = 0
for document in documents:
    text = document.read_text()
    for name, tool in re.findall(r"<!-- ([\w-]+): written by (\S+)", text):
        parts += 1
        written = re.search(rf"<!-- {name}: written by [^>]*-->\n(.*?)<!-- end of {name} -->\n", text, re.DOTALL)
        if not (source / tool).is_file():
            broken.append(f"{document.relative_to(source)}: {name}: there is no {tool}")
        if not written or not re.search(r"\nBy\s`[^`]+`:[^|]*\d{4}-\d\d-\d\d\.\n", written.group(1)):
            broken.append(f"{document.relative_to(source)}: {name}: no end, or not by which command and when")
if parts < 2:
    broken.append(f"only {parts} parts written by tools were found")
if links < 30:
    broken.append(f"only {links} links were found")
print("\n".join(broken) or f"{links} links and {parts} parts written by tools in {len(documents)} documents")
sys.exit(bool(broken))
