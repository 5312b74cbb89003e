#!/usr/bin/env python3
"""gallery_test.py PROGRAMS SOURCE SCRATCH: whether each scene of the gallery renders to the picture that its page has, an
eighth as large. Exits with 77 (skipped) where numpy or djpeg is missing. SCRATCH is made anew."""
import importlib.util
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, finish, make_anew, skip

programs, source, scratch = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
# RMSE, in levels of 255. What is found is 0.8 to 2.3, of another scene's picture at least 50.
MOST, OTHER = 3, 30

if importlib.util.find_spec("numpy") is None or not shutil.which("djpeg"):
    skip("numpy or djpeg is missing")
import numpy as np

sys.path.append(str(source / "tools"))
from gallery.command import SCENES, scene_module


def pixels(ppm):
    """The image of a binary PPM file without comments."""
    magic, width, height, maximum, values = ppm.split(maxsplit=3)[:3] + ppm.split(maxsplit=3)[3].split(b"\n", 1)
    assert magic == b"P6" and maximum == b"255"
    return np.frombuffer(values, dtype=np.uint8).reshape(int(height), int(width), 3).astype(float)


def committed(name):
    """An eighth of its size by djpeg is the mean of each 8 x 8 pixels."""
    command = ["djpeg", "-scale", "1/8", "-ppm", source / f"docs/gallery/{name}.jpg"]
    return pixels(subprocess.run(command, check=True, capture_output=True).stdout)


def rendered(name):
    scene = scene_module(name).build().write(scratch, name)
    command = [programs / "lavaray", scene, "--width", "120", "--spp", "64", "-q", "-o", "-"]
    found = subprocess.run(command, capture_output=True)
    check(found.returncode == 0 and not found.stderr, f"{name} renders without a word: {found.stderr.decode()}")
    return pixels(found.stdout)


make_anew(scratch)
pictures = {name: committed(name) for name in SCENES}
for name in SCENES:
    image = rendered(name)
    distance = {other: np.sqrt(np.mean((image - picture) ** 2)) for other, picture in pictures.items()}
    own = distance.pop(name)
    print(f"{name}: {own:.2f} of 255, other pictures {min(distance.values()):.1f}")
    check(own <= MOST, f"{name} is its picture on the page: the RMSE is {own:.2f} of 255")
    check(min(distance.values()) >= OTHER, f"{name} is none of the others")
page = (source / "docs/gallery.md").read_text()
for name in SCENES:
    check(f"tools/make-gallery {name}\n" in page and f"(gallery/{name}.jpg)" in page, f"the page has {name}")
    check((source / f"docs/gallery/{name}.jpg").stat().st_size <= 150_000, f"the picture of {name} is small")
finish()
