"""docs/gallery.md: the pictures, and what tools/make-gallery --page writes between two marks."""

import datetime
import os
import platform
import re
import shutil
import subprocess
import textwrap
from pathlib import Path

BEGIN = "<!-- tools/make-gallery --page writes what follows: -->\n"
END = "<!-- as far as here. -->\n"
MOST_BYTES = 150_000  # of a picture


class PageError(Exception):
    pass


def machine():
    model = platform.machine()
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = re.sub(r"\(R\)|\(TM\)|CPU|Processor|@.*", "", line.split(":", 1)[1])
            break
    return f"{len(os.sched_getaffinity(0))} cores of {' '.join(model.split())}"


def write_picture(ppm, jpeg):
    """The best JPEG file that is small enough."""
    if not shutil.which("cjpeg"):
        raise PageError("cjpeg is missing: run `tools/setup gallery`")
    for quality in range(94, 60, -2):
        command = ["cjpeg", "-quality", str(quality), "-optimize", "-progressive", ppm]
        picture = subprocess.run(command, capture_output=True, check=True).stdout
        if len(picture) <= MOST_BYTES:
            jpeg.write_bytes(picture)
            return
    raise PageError(f"{ppm} is too large as JPEG")


def title(name):
    return name.replace("-", " ").capitalize()


def row(result):
    report, name = result["report"], result["name"]
    scene, sampling = report["scene"], report["sampling"]
    return [f"[{title(name)}](#{name})", f"{scene['triangles'] + scene['meshTriangles']:,}", f"{scene['spheres']:,}",
            str(scene["lights"]),
            f"{sampling['samplesPerPixel']:.1f}", f"{sampling['mostSamplesPerPixel']:,}",
            f"{sum(report['rays'][kind] for kind in ('camera', 'shadow', 'mirror')) / 1e6:,.0f}",
            f"{result['processorSeconds']:.0f}"]


def written(results):
    """The page's part, in Markdown."""
    lines = []
    for result in results:
        name = result["name"]
        lines += [f"## {title(name)}", "", f"![{title(name)}](gallery/{name}.jpg)", "", result["text"], "",
                  "```sh not run: it takes minutes", f"tools/make-gallery {name}", "```", ""]
    header = ("scene", "triangles", "spheres", "lights", "samples a pixel, mean", "most", "million rays", "CPU seconds")
    lines += ["## What they took", "", "| " + " | ".join(header) + " |", "|---" * len(header) + "|"]
    lines += ["| " + " | ".join(row(result)) + " |" for result in results]
    picture, device = results[0]["report"]["picture"], results[0]["report"]["device"]
    how = (f"By `tools/make-gallery --page`: {picture['width']} x {picture['height']} pixels with "
           f"`{' '.join(results[0]['options'])}`, from scene file to picture file; {machine()}, {device['driver']}, "
           f"{datetime.date.today()}.")
    return "\n".join([*lines, "", *textwrap.wrap(how, 120, break_on_hyphens=False), ""])


def write(docs, results):
    page = docs / "gallery.md"
    text = page.read_text()
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        raise PageError(f"{page} has not the lines between which this writes: {BEGIN}{END}")
    (docs / "gallery").mkdir(exist_ok=True)
    for result in results:
        write_picture(result["picture"], docs / "gallery" / f"{result['name']}.jpg")
    before, rest = text.split(BEGIN)
    page.write_text(before + BEGIN + "\n" + written(results) + "\n" + END + rest.split(END)[1])
