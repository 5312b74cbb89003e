#!/usr/bin/env python3
"""report_page_test.py PROGRAMS SCRATCH: the page of lavaray-diff --report in Chromium, opened from a file and used by
keys and mouse. Exits with 77 (skipped) where there is no Chromium. SCRATCH is made anew."""
import pathlib
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import browser
from checks import check, finish, make_anew, skip

WIDTH, HEIGHT = 60, 40
OFF = (41, 13)  # the pixel that differs
READY = "document.querySelector('.pane')?.dataset.ready === 'yes'"

programs, scratch = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()


def color(x, y):
    return [(4 * x) % 256, (6 * y) % 256, (x * y) % 256]


def write(name, width=WIDTH, changed=None):
    rows = bytearray(value for y in range(HEIGHT) for x in range(width) for value in color(x, y))
    if changed:
        rows[3 * (changed[1] * width + changed[0])] ^= 0x80
    (scratch / name).parent.mkdir(exist_ok=True)
    (scratch / name).write_bytes(b"P6 %d %d 255\n" % (width, HEIGHT) + rows)


def make_page():
    write("actual/one pixel.ppm", changed=OFF)
    write("actual/equal.ppm")
    write("actual/narrow.ppm", width=WIDTH - 1)
    for name in ("one pixel", "equal", "narrow", "only here"):
        write(f"reference/{name}.ppm")
    found = subprocess.run([programs / "lavaray-diff", "actual", "reference", "--report", "page.html"], cwd=scratch)
    check(found.returncode == 10, "the page is made")


def text(selector):
    return page.value(f"document.querySelector({selector!r}).innerText")


def names():
    return page.value("Array.from(document.querySelectorAll('#list .name'), (name) => name.textContent)")


def captions():
    return page.value("Array.from(document.querySelectorAll('.caption'), (caption) => caption.innerText.split(' ')[0])")


def place(pane, x, y):
    """Where the middle of a pixel of the picture is on the screen."""
    return page.value(f"""(() => {{ const box = surfaces[{pane}].canvas.getBoundingClientRect(), at = corner();
        return [box.x + at.x + ({x} + 0.5) * view.zoom, box.y + at.y + ({y} + 0.5) * view.zoom]; }})()""")


def drawn(pane, x, y, off=0.5):
    """What a pane shows at that part of a pixel."""
    return page.value(f"""(() => {{ const at = corner();
        return Array.from(surfaces[{pane}].context.getImageData(Math.floor(at.x + ({x} + {off}) * view.zoom),
            Math.floor(at.y + ({y} + {off}) * view.zoom), 1, 1).data.slice(0, 3)); }})()""")


def open_page():
    page.open((scratch / "page.html").as_uri() + "#one%20pixel.ppm", READY)
    check(text("h2") == "one pixel.ppm" and text("#verdict") == "differs", "the address names the pair")
    check(names() == ["narrow.ppm", "one pixel.ppm", "only here.ppm"], f"the list has what fails: {names()}")
    check(text("#summary").split("\n") == ["2 differ", "1 missing or unreadable", "1 alike"], f"it counts: {text('#summary')}")
    pictures = [request for request in page.requests if request.startswith("data:")]
    check(len(pictures) == 4, f"no picture is decoded but those that are seen: {len(pictures)}")
    check(captions() == ["actual", "reference", "difference"], f"three stand side by side: {captions()}")
    numbers = text("#numbers")
    check(f"1 of {WIDTH * HEIGHT:,}" in numbers and "128 / 255 at %d,%d" % OFF in numbers, f"the numbers: {numbers}")


def use_mouse_and_zoom():
    reference = color(*OFF)
    actual = [reference[0] ^ 0x80, *reference[1:]]
    for pane, expected in ((0, actual), (1, reference), (2, [255, 0, 0])):
        page.key("m") if pane == 0 else None  # the ring would be in the way
        check(drawn(pane, *OFF) == expected, f"pane {pane} shows {drawn(pane, *OFF)}")
    page.mouse("mouseMoved", *place(1, 20, 30))
    words = text("#readout").split()
    check(words[:4] == ["x,", "y", "20,", "30"], f"the place under the mouse: {words}")
    shown = " ".join(map(str, color(20, 30)))
    check(text("#readout").replace("  ", " ").count(shown) == 2, f"the values under the mouse: {text('#readout')}")
    before = page.value("view.zoom")
    at = place(0, *OFF)
    for _ in range(4):
        page.wheel(*at, -100)
    page.wait(f"view.zoom > {before}")
    check(page.value("Number.isInteger(view.zoom)"), "zooms are whole")
    check(max(abs(a - b) for a, b in zip(place(0, *OFF), at)) <= page.value("view.zoom"), "the pixel under the mouse stays there")
    for off in (0.1, 0.5, 0.9):
        check(drawn(0, *OFF, off) == actual and drawn(1, *OFF, off) == reference, "pixels are squares, at one place in all panes")
    start = place(0, *OFF)
    page.drag(start, (start[0] + 50, start[1] - 20))
    moved = place(2, *OFF)
    check(abs(moved[0] - place(0, *OFF)[0]) > 100 and abs(place(0, *OFF)[0] - start[0] - 50) <= 1, "dragging moves all")
    page.key("0")
    check(page.value("view.zoom") == before, "0 fits")
    page.key("g")
    check(page.value("view.zoom") >= 16, "g goes near")
    page.mouse("mouseMoved", 5, 5)
    check(text("#readout").split()[2:4] == [f"{OFF[0]},", str(OFF[1])], "g shows the largest difference's values")
    page.key("d")
    check(captions()[2] == "FLIP", "d shows FLIP")
    page.key("d")
    page.key("0")


def slide():
    page.key("2")
    check(captions() == ["actual", "reference"], f"the slider has both: {captions()}")
    reference = color(*OFF)
    actual = [reference[0] ^ 0x80, *reference[1:]]
    line = place(0, WIDTH / 2 - 0.5, 20)
    check(drawn(0, *OFF) == reference, "right of the line is the reference")
    page.drag(line, place(0, 55, 20))
    check(page.value("view.split") > 0.85 and drawn(0, *OFF) == actual, "the line is dragged; left of it is the actual picture")
    split = page.value("view.split")
    for _ in range(3):
        page.key(",")
    check(abs(page.value("view.split") - split + 0.06) < 1e-6, "a comma moves it")
    page.value("document.getElementById('split').focus()")
    page.key("ArrowLeft")
    check(abs(page.value("view.split") - split + 0.061) < 2e-3, "so does the slider's own key")
    page.value("document.getElementById('split').blur()")


def flicker():
    page.key("3")
    first = captions()
    page.wait(f"document.querySelector('.caption').innerText !== {first[0]!r}")
    page.key(" ")
    stopped = captions()
    time.sleep(1.5)
    check(captions() == stopped, "Space stops it")
    value = drawn(0, *OFF)
    page.key(" ")
    check(captions() != stopped and abs(drawn(0, *OFF)[0] - value[0]) == 128, "Space swaps them")
    page.key("Enter")
    swapped = captions()
    page.wait(f"document.querySelector('.caption').innerText !== {swapped[0]!r}")
    page.key("4")
    check(captions() == ["difference"], "4 shows the difference")
    page.key("5")
    check(captions() == ["FLIP"], "5 shows FLIP")
    page.key("1")


def go_through():
    page.key("k")
    page.wait("view.pictures === decoded.get(0) || document.querySelector('h2').innerText === 'narrow.ppm'")
    check(text("h2") == "narrow.ppm", "k goes back")
    page.wait("document.querySelectorAll('.message').length === 1")
    check("different size" in text(".message"), "sizes that differ are told")
    page.key("j")
    page.key("j")
    page.wait("document.querySelector('h2').innerText === 'only here.ppm'")
    page.wait("document.querySelectorAll('.message').length === 2")
    check(text(".message") == "There is no actual picture.", f"a missing one is told: {text('.message')}")
    page.key("?")
    check(page.value("document.getElementById('keys').open"), "? shows the keys")
    page.key("Escape")
    check(not page.value("document.getElementById('keys').open"), "Escape hides them")
    box = page.value("(() => { const box = document.getElementById('failing').getBoundingClientRect(); return [box.x + 5, box.y + 5]; })()")
    page.click(*box)
    check(len(names()) == 4 and names()[3] == "equal.ppm", "all can be listed")
    page.key("/")
    for letter in "eQu":
        page.key(letter)
    check(names() == ["equal.ppm"] and page.value("document.getElementById('filter').value") == "eQu", f"the filter: {names()}")
    page.key("Escape")
    page.key("j")
    page.wait("document.querySelector('h2').innerText === 'equal.ppm' && document.querySelectorAll('.message').length === 1")
    check(text(".message") == "The pictures are equal." and drawn(1, *OFF) == color(*OFF), "equal ones are shown")
    page.value("location.hash = '#one%20pixel.ppm'")
    page.wait("document.querySelector('h2').innerText === 'one pixel.ppm'")


program = browser.find()
if not program:
    skip("Chromium is missing")
make_anew(scratch)
make_page()
with browser.Browser(program, scratch / "profile") as page:
    for part in (open_page, use_mouse_and_zoom, slide, flicker, go_through):
        part()
    check(page.messages == [], f"no script fails: {page.messages}")
    other = {request.split(":")[0] for request in page.requests} - {"file", "data"}
    check(not other, f"nothing is fetched: {other}")
finish()
