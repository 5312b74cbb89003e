#!/usr/bin/env python3
"""documents_test.py SOURCE: whether what the project's Markdown files link to, beside each other and within, is there."""

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
if links < 30:
    broken.append(f"only {links} links were found")
print("\n".join(broken) or f"{links} links in {len(documents)} documents")
sys.exit(bool(broken))
