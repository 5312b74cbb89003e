#!/usr/bin/env python3
"""diff_report_test.py PROGRAMS SCRATCH: what lavaray-diff writes as JSON and as a page, and how it makes pairs of two
folders. SCRATCH is made anew."""
import base64
import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import zlib

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, finish, make_anew
import image_cases

WIDTH, HEIGHT = image_cases.WIDTH, image_cases.HEIGHT
PIXELS = WIDTH * HEIGHT
UNREADABLE, DIFFERS = 3, 10

programs, scratch = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])


def diff(*arguments):
    return subprocess.run([programs / "lavaray-diff", *arguments], cwd=scratch, capture_output=True, text=True)


def write(name, data):
    (scratch / name).parent.mkdir(parents=True, exist_ok=True)
    (scratch / name).write_bytes(data)
    return name


def png(name, pixels, kind="rgb", bits=8):
    return write(name, image_cases.png(pixels, kind, bits))


def found_in(name="found.json"):
    return json.loads((scratch / name).read_text())["pairs"]


def pairs_of_page(name="page.html"):
    """The pairs in a page, each with its pictures by their names."""
    page = (scratch / name).read_text()
    pairs = [json.loads(text) for text in re.findall(r'<script type="application/json" class="pair">(.*?)</script>', page)]
    for pair in pairs:
        pair["pictures"] = {}
    for number, kind, text in re.findall(r'<script type="text/plain" id="(\d+)-([a-z-]+)">(.*?)</script>', page):
        pairs[int(number)]["pictures"][kind] = decoded(base64.b64decode(text, validate=True))
    return pairs


def decoded(data):
    """Width, height and RGB bytes of a PNG file of 8 bits, and the names of its chunks."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    chunks, at = [], 8
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        chunks.append((name, data[at + 8:at + 8 + length]))
        at += 12 + length
    width, height, bits, kind = struct.unpack(">IIBB", chunks[0][1][:10])
    assert (bits, kind) == (8, 2)
    raw = zlib.decompress(b"".join(content for name, content in chunks if name == b"IDAT"))
    rows, before, stride = [], bytearray(3 * width), 3 * width
    for y in range(height):
        filtered, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a, b, c = row[i - 3] if i >= 3 else 0, before[i], before[i - 3] if i >= 3 else 0
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth)[filtered]) % 256
        rows.append(bytes(row))
        before = row
    return width, height, b"".join(rows), {name for name, _ in chunks}


def triples(data):
    return [list(data[i:i + 3]) for i in range(0, len(data), 3)]


def one_pair():
    pixels = image_cases.pixels([255] * 3)
    other = [list(pixel) for pixel in pixels]
    changes = {(3, 0): 1, (9, 1): 2, (20, 2): 3, (21, 0): 90}
    for (pixel, channel), off in changes.items():
        other[pixel][channel] = (pixels[pixel][channel] + off) if pixels[pixel][channel] + off < 256 else pixels[pixel][channel] - off
    a, b = png("a.png", pixels), png("b.png", other)
    run = diff(a, b, "--json", "found.json", "--report", "page.html", "--name", "</script><b>&\"'é", "--driver", "a <driver>",
               "--tolerance", "1", "--max-differing", "2")
    check(run.returncode == DIFFERS, "the exit code is that of the comparison", run)
    (pair,) = found_in()
    difference = pair["difference"]
    check(pair["verdict"] == "differs" and pair["name"] == "</script><b>&\"'é" and pair["driver"] == "a <driver>", "names are kept")
    check(difference["pixels"] == PIXELS and difference["differing"] == 3, f"differing pixels: {difference}")
    check(pair["limits"] == {"tolerance": 1, "maxDiffering": 2, "maxRmse": None, "maxFlip": None}, "limits are told")
    rmse = math.sqrt(sum(off * off for off in changes.values()) / (3 * PIXELS)) / 255
    check(math.isclose(difference["rmse"], rmse, rel_tol=1e-5), "the RMSE")
    largest = difference["color"]
    check((largest["x"], largest["y"]) == (21 % WIDTH, 21 // WIDTH) and math.isclose(largest["largest"], 90, rel_tol=1e-5), "the largest")
    bins = {bin["upTo"]: bin["pixels"] for bin in difference["histogram"]}
    check(bins == {0: PIXELS - 4, 1: 1, 2: 1, 4: 1, 8: 0, 16: 0, 32: 0, 64: 0, 128: 1, None: 0}, f"the histogram: {bins}")

    page = (scratch / "page.html").read_text()
    check(page.count("<script") == page.count("</script>") == 6, "no name ends a script or begins one")
    check("<b>&" not in page, "no name is markup")
    check(not re.search(r"https?:|//[a-z]+\.|<link|<iframe|@import|\bfetch\b|XMLHttpRequest|\b(src|href)=", page), "the page is all there is")
    (of_page,) = pairs_of_page()
    pictures = of_page.pop("pictures")
    check(of_page == pair, "the page knows what the JSON says")
    check(set(pictures) == {"image", "reference", "difference", "flip"}, f"there are {set(pictures)}")
    for name, picture in pictures.items():
        check(picture[:2] == (WIDTH, HEIGHT) and picture[3] == {b"IHDR", b"IDAT", b"IEND"}, f"{name} has its size and plain chunks: {picture[3]}")
    check(triples(pictures["image"][2]) == pixels and triples(pictures["reference"][2]) == other, "the levels are the files'")
    check(triples(pictures["difference"][2])[21] == [255, 0, 0] and triples(pictures["difference"][2])[9] == [0, 5, 0], "the difference is scaled")

    run = diff(a, b, "--tolerance", "3", "--max-differing", "1", "--json", "found.json", "--report", "alike.html")
    check(run.returncode == 0 and found_in()[0]["verdict"] == "alike" and found_in()[0]["name"] == "a.png", "alike within limits", run)
    run = diff(a, a, "--report", "equal.html")
    check(run.returncode == 0 and set(pairs_of_page("equal.html")[0]["pictures"]) == {"image"}, "equal ones are shown once", run)
    run = diff(a, "absent.png", "--json", "found.json", "--report", "page.html")
    check(run.returncode == UNREADABLE and "absent.png: cannot be read" in run.stderr, "what cannot be read is an error", run)
    check(found_in()[0]["verdict"] == "unreadable" and "absent.png" in found_in()[0]["problem"], "and is in the JSON")
    check(set(pairs_of_page()[0]["pictures"]) == {"image"}, "the other one is on the page")


def values():
    """Floats and alpha, whose values 8 bits cannot show."""
    floats = [[image_cases.RANDOM.uniform(-1, 3) for _ in range(3)] for _ in range(PIXELS)]
    floats[5][0], floats[6] = math.inf, [math.nan] * 3
    write("a.pfm", image_cases.pfm(floats, 3, "<"))
    write("b.pfm", image_cases.pfm([[v + 0.25 for v in p] for p in floats], 3, "<"))
    check(diff("a.pfm", "b.pfm", "--report", "page.html").returncode == DIFFERS, "floats differ")
    pictures = pairs_of_page()[0]["pictures"]
    width, height, data, _ = pictures["image-values"]
    check((width, height) == (WIDTH, 4 * HEIGHT), "four bytes a float")
    size = 3 * PIXELS
    stored = [struct.unpack("<f", bytes(data[k * size + i] for k in range(4)))[0] for i in range(size)]
    expected = [image_cases.as_float32(v) for p in floats for v in p]
    check(all(a == b or (math.isnan(a) and math.isnan(b)) for a, b in zip(stored, expected)), "floats are kept to the bit")
    shown = triples(pictures["image"][2])
    check(shown[6] == [255, 0, 255] and shown[5][0] == 255, "NaN is magenta, infinity white")
    check(all(shown[i][k] == int(255 * min(max(expected[3 * i + k], 0), 1)) for i in range(20, PIXELS) for k in range(3)), "the rest is truncated")
    pixels = image_cases.pixels([255] * 4)
    a, b = png("alpha.png", pixels, "rgba"), png("opaque.png", [p[:3] for p in pixels])
    check(diff(a, b, "--report", "page.html", "--json", "found.json").returncode == DIFFERS, "alpha differs")
    width, height, data, _ = pairs_of_page()[0]["pictures"]["image-values"]
    stored = [struct.unpack("<f", bytes(data[(4 + k) * size + 3 * i] for k in range(4)))[0] for i in range(PIXELS)]
    check(height == 8 * HEIGHT and stored == [image_cases.as_float32((p[3], 255)) for p in pixels], "alpha is kept to the bit")
    check(found_in()[0]["difference"]["alpha"]["differing"] == sum(p[3] != 255 for p in pixels), "alpha has figures")


def folders():
    pixels = image_cases.pixels([255] * 3)
    other = [[255 - v for v in pixels[0]], *pixels[1:]]
    for name in ("same.png", "deep/down/same.png", "off.png", "only left.png", "twice.png", "twice.bmp.png"):
        png(f"left/{name}", pixels)
    for name in ("same.png", "deep/down/same.png", "only right.png", "twice.png"):
        png(f"right/{name}", pixels)
    png("right/off.png", other)
    write("left/ending.ppm", b"P6 %d %d 255\n" % (WIDTH, HEIGHT) + image_cases.pnm_raster(pixels, 255))
    png("right/ending.png", pixels)
    write("left/notes.txt", b"no picture")
    run = diff("left", "right", "--json", "found.json", "--report", "page.html")
    check(run.returncode == DIFFERS, "some differ", run)
    expected = {"deep/down/same.png": "alike", "ending.ppm": "alike", "off.png": "differs", "only left.png": "reference missing",
                "only right.png": "image missing", "same.png": "alike", "twice.bmp.png": "reference missing", "twice.png": "alike"}
    found = {pair["name"]: pair["verdict"] for pair in found_in()}
    check(found == expected, f"the pairs are {found}")
    check([pair["name"] for pair in pairs_of_page()] == sorted(expected), "the page has them in order")
    check(re.search(r"^missing +only left\.png: there is no reference$", run.stdout, re.M), "a missing partner is named", run)
    check(run.stdout.endswith("pairs        8: 4 alike, 1 different, 3 without a partner, 0 unreadable\n"), "they are counted", run)
    again = diff("--from", "found.json", "--json", "again.json", "--report", "again.html")
    check(again.returncode == DIFFERS and again.stdout == run.stdout, "a comparison can be repeated", again)
    check((scratch / "again.json").read_bytes() == (scratch / "found.json").read_bytes(), "it finds the same")
    check((scratch / "again.html").read_bytes() == (scratch / "page.html").read_bytes(), "it makes the same page")
    write("left/broken.png", b"P")
    png("right/broken.png", pixels)
    run = diff("left", "right", "--json", "found.json")
    check(run.returncode == UNREADABLE and len(found_in()) == 9 and "unreadable   broken.png: left/broken.png" in run.stdout,
          "what cannot be read is named, the others are compared", run)
    (scratch / "left/broken.png").unlink()
    (scratch / "right/broken.png").unlink()
    for name in ("off.png", "only left.png", "twice.bmp.png"):
        (scratch / "left" / name).unlink()
    for name in ("off.png", "only right.png"):
        (scratch / "right" / name).unlink()
    check(diff("left", "right").returncode == 0, "all alike")
    (scratch / "empty").mkdir()
    run = diff("empty", "empty")
    check(run.returncode == UNREADABLE and "hold no images" in run.stderr, "nothing to compare is an error", run)
    run = diff("left", "right/same.png")
    check(run.returncode == 2 and "only left is a folder" in run.stderr, "a folder and a picture are no pair", run)
    write("wrong.json", b'{"pairs": [{"name": 1}]}')
    for name, why in (("wrong.json", "is no comparison"), ("left/same.png", "is no JSON from byte 1 on"), ("absent.json", "cannot be read")):
        run = diff("--from", name)
        check(run.returncode == UNREADABLE and f"{name}: {why}" in run.stderr, f"{name} is refused", run)
    pairs = json.loads((scratch / "again.json").read_text())
    pairs["pairs"][0]["image"] = pairs["pairs"][0]["reference"] = None
    write("none.json", json.dumps(pairs).encode())
    run = diff("--from", "none.json")
    check(run.returncode == UNREADABLE, "a pair of nothing is refused", run)


make_anew(scratch)
for part in (one_pair, values, folders):
    part()
finish()
