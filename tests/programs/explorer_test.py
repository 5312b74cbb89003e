#!/usr/bin/env python3
"""explorer_test.py PROGRAMS SOURCE PACKAGE SCRATCH: the page of tools/make-explorer in Chromium: its values are those of
the files that lavaray writes, and docs/explorer.html opens, too. PACKAGE is the folder of the Python package. Exits with
77 (skipped) where that, numpy or Chromium is missing. SCRATCH is made anew."""
import importlib.util
import os
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import browser
from checks import check, demand, finish, make_anew, skip

programs, source, package, scratch = (pathlib.Path(argument).resolve() for argument in sys.argv[1:5])
READY = "document.body?.dataset.ready === 'yes'"
VIEWS = ("normal", "depth", "object", "shadow", "cost", "samples", "error")
WIDTH, ERROR = 90, 0.02

sys.path.insert(0, str(package))
if not browser.find() or not all(map(importlib.util.find_spec, ("numpy", "lavaray"))):
    skip("Chromium, numpy or the Python package is missing")
import lavaray


def make_page():
    command = [sys.executable, source / "tools/make-explorer", source / "scenes/showcase.txt", "-o", "page.html", "--width",
               str(WIDTH), "--target-error", str(ERROR), "--program", programs / "lavaray"]
    found = subprocess.run(command, cwd=scratch, capture_output=True, text=True,
                           env=os.environ | {"PYTHONPATH": str(package)})
    demand(found.returncode == 0, f"the page is made: {found.stderr}")
    layers = ("normal", "depth", "object", "samples", "error")
    subprocess.run([programs / "lavaray", source / "scenes/showcase.txt", "--width", str(WIDTH), "--target-error", str(ERROR),
                    "-q", "-o", "picture.exr", "--layers", ",".join(layers)], cwd=scratch, check=True)
    return {name: lavaray.read_image(str(scratch / f"picture.{name}.exr")) for name in layers}


def hover(x, y):
    page.mouse("mouseMoved", *page.value(f"""(() => {{ const box = canvas.getBoundingClientRect(), at = corner();
        return [box.x + at.x + ({x} + 0.5) * view.zoom, box.y + at.y + ({y} + 0.5) * view.zoom]; }})()"""))
    return page.value("""Object.fromEntries(Array.from(document.querySelectorAll('#values div'),
        (cell) => [cell.firstChild.textContent, cell.lastChild.textContent]))""")


def drawn(x, y):
    """What stands on the screen at a pixel."""
    return page.value(f"""(() => {{ const at = corner();
        return Array.from(context.getImageData(at.x + ({x} + 0.5) * view.zoom, at.y + ({y} + 0.5) * view.zoom, 1, 1).data
            .slice(0, 3)); }})()""")


def numbers(text):
    return [float(word) for word in text.replace(",", "").split()]


def compare_values(layers):
    for x, y in ((3, 4), (45, 30), (60, 25), (20, 55), (88, 58)):
        shown = hover(x, y)
        check(shown["x, y"] == f"{x}, {y}", f"the place under the mouse: {shown}")
        normal, depth = layers["normal"][y, x], layers["depth"][y, x, 0]
        off = max(abs(a - b) for a, b in zip(numbers(shown["normal"]), normal))
        check(off <= 0.0101, f"the normal at {x}, {y}: {shown['normal']}, {normal}")
        check(abs(numbers(shown["depth"])[0] / depth - 1) < 1e-3, f"the depth at {x}, {y}: {shown['depth']}, {depth}")
        check(shown["object"].split(",")[0] == f"{layers['object'][y, x, 0]:.0f}", f"the object at {x}, {y}: {shown['object']}")
        check(numbers(shown["samples"])[0] == layers["samples"][y, x, 0], f"the samples at {x}, {y}: {shown['samples']}")
        check(abs(numbers(shown["error"])[0] - layers["error"][y, x, 0]) <= 1e-4, f"the error at {x}, {y}: {shown['error']}")
        check(numbers(shown["cost"])[0] > 0 and 0 <= numbers(shown["shadow"])[0] <= 1, f"cost and shadow: {shown}")


def use(layers):
    check(page.value("Array.from(document.querySelectorAll('#views button'), (b) => b.textContent)") == list(VIEWS),
          "there is a button for each view")
    compare_values(layers)
    left, right = (5, 20), (80, 20)
    page.mouse("mouseMoved", 2, 2)
    color = [round(value) for value in page.value("valueAt('color', 5, 20)")]
    check(drawn(*left) == color, f"the picture is to the left of the line: {drawn(*left)}, {color}")
    seen = set()
    for number, name in enumerate(VIEWS, 1):
        page.key(str(number))
        check(page.value("document.querySelector('#views [aria-checked=true]').textContent") == name, f"{number} is {name}")
        check(drawn(*left) == color, "the picture stays")
        seen.add(tuple(drawn(*right)))
    check(len(seen) >= 5, f"views differ: {seen}")
    page.value("setSplit(0)")
    check(drawn(*left) != color, "the line moves")
    zoom = page.value("view.zoom")
    page.key("+")
    check(page.value("view.zoom") > zoom, "+ zooms")
    page.key("0")
    check(page.value("view.zoom") == zoom, "0 fits")


make_anew(scratch)
made = make_page()
with browser.Browser(browser.find(), scratch / "profile") as page:
    page.open((scratch / "page.html").as_uri(), READY)
    use(made)
    page.open((source / "docs/explorer.html").as_uri(), READY + " && document.title === 'still-life'")
    check(page.value("images.color.width") >= 600, "the page of the documents has a picture")
    check(page.messages == [], f"no script fails: {page.messages}")
    other = {request.split(":")[0] for request in page.requests} - {"file", "data"}
    check(not other, f"nothing is fetched: {other}")
check((source / "docs/explorer.html").stat().st_size <= 1_500_000, "the page is small")
finish()
