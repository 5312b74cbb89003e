"""A part of a page: between `<!-- NAME: written by COMMAND -->` and `<!-- end of NAME -->`."""

import datetime
import os
import platform
import re
import textwrap
from pathlib import Path


class PageError(Exception):
    pass


def replace(page, name, text):
    """Puts the text, lines of Markdown, between the marks."""
    found = re.compile(rf"(<!-- {name}: written by [^>]*-->\n).*?(<!-- end of {name} -->\n)", re.DOTALL)
    old = page.read_text()
    new, count = found.subn(lambda match: f"{match.group(1)}\n{text.strip()}\n\n{match.group(2)}", old)
    if count != 1:
        raise PageError(f"{page} has not one part `<!-- {name}: written by ... -->` to `<!-- end of {name} -->`, but {count}")
    page.write_text(new)


def markdown_table(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    text = "\n".join("| " + " | ".join(map(str, cells)) + " |" for cells in lines)
    return re.sub(r"\|  (?=\|)", "| ", text.replace("| --- ", "|---").replace("|--- |", "|---|"))


def machine():
    model = platform.machine()
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = re.sub(r"\(R\)|\(TM\)|CPU|Processor|@.*", "", line.split(":", 1)[1])
            break
    return f"{len(os.sched_getaffinity(0))} cores of {' '.join(model.split())}"


def origin(command, *more):
    """The sentence that says where figures come from. More: further facts, such as the driver."""
    text = f"By `{command}`: {', '.join([machine(), *more, str(datetime.date.today())])}."
    return "\n".join(textwrap.wrap(text, 120, break_on_hyphens=False, break_long_words=False))
