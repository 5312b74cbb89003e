#!/usr/bin/env python3
"""exr_readers_test.py PROGRAMS SCRATCH: what other programs make of EXR files and layers, with those that are there.

A plane of the display value 128/255 is rendered; prints a table of what each program reads, and what it shows in 8 bits
where it converts to display values. Exits with 77, which CTest takes for a skipped test, where there is none of them.
"""
import importlib.util
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

SKIPPED = 77
GREY = 128
LIGHT = ((GREY / 255 + 0.055) / 1.055) ** 2.4
SCENE = f"""2
camera
pos: 0 0 0
fov: 60
f: 50
a: 1.5
plane
nor: 0 0 1
pos: 0 0 -5
amb: {GREY / 255} {GREY / 255} {GREY / 255}
dif: 0 0 0
spe: 0 0 0
shi: 1
"""
# Of the pixel that is read: the first one of the first row.
WIDTH, HEIGHT = 85, 57
RAY = (0.5 - WIDTH / 2, HEIGHT / 2 - 0.5, -50)
DEPTH = 5 * math.hypot(*RAY) / 50

programs, scratch = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
scratch.mkdir(parents=True, exist_ok=True)
os.environ["OPENCV_IO_ENABLE_OPENEXR"] = "1"


def output(*command):
    return subprocess.run(command, cwd=scratch, check=True, capture_output=True, text=True).stdout


def numbers(text):
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?", text)]


def oiiotool():
    """OpenImageIO"""
    version = output("oiiotool", "--version").split()[0]

    def pixel(name):
        line = next(line for line in output("oiiotool", "--dumpdata", name).splitlines() if "Pixel (0, 0)" in line)
        return numbers(line.split(":")[1])

    output("oiiotool", "grey.exr", "--colorconvert", "linear", "sRGB", "-d", "uint8", "-o", "shown.png")
    return version, pixel, pixel("shown.png")


def convert():
    """ImageMagick: it reads 16 bits, half floats among them, of what is in 0 to 1, so a depth is read as 1"""
    version = output("convert", "-version").split()[2]

    def pixel(name):
        text = output("convert", f"{name}[1x1+0+0]", "-format", "%[fx:p.r] %[fx:p.g] %[fx:p.b]", "info:")
        return numbers(text)

    if not version.startswith("6."):
        return version, pixel, None
    output("convert", "grey.exr", "PNG24:shown.png")
    return version, pixel, [255 * value for value in pixel("shown.png")]


def cv2():
    """OpenCV"""
    import cv2 as library

    def pixel(name):
        values = library.imread(str(scratch / name), library.IMREAD_UNCHANGED)[0, 0]
        return [float(value) for value in values.reshape(-1)[::-1]]  # blue first

    return library.__version__, pixel, None


def mitsuba():
    """Mitsuba"""
    import mitsuba as library
    import numpy

    def pixel(name):
        return [float(value) for value in numpy.array(library.Bitmap(str(scratch / name)))[0, 0].reshape(-1)]

    shown = library.Bitmap(str(scratch / "grey.exr")).convert(library.Bitmap.PixelFormat.RGB,
                                                               library.Struct.Type.UInt8, True)
    return library.__version__, pixel, [float(value) for value in numpy.array(shown)[0, 0]]


def bpy():
    """Blender"""
    import bpy as library
    scene = library.context.scene
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format = "PNG"

    def pixel(name):
        image = library.data.images.load(str(scratch / name))
        # Rows from the bottom, alpha in every pixel.
        values = list(image.pixels[:])
        first = len(values) - 4 * image.size[0]
        return values[first : first + 3]

    library.data.images.load(str(scratch / "grey.exr")).save_render(str(scratch / "shown.png"), scene=scene)
    library.data.images.load(str(scratch / "shown.png")).colorspace_settings.name = "Non-Color"
    image = library.data.images["shown.png"]
    return library.app.version_string, pixel, [255 * value for value in image.pixels[:3]]


def near(values, expected, tolerance):
    """Some repeat a grey value for each channel."""
    return len(values) >= len(expected) and all(abs(a - b) <= tolerance for a, b in zip(values, expected))


def main():
    (scratch / "grey.txt").write_text(SCENE)
    output(programs / "lavaray", "grey.txt", "--layers", "normal,depth,object,samples", "-o", "grey.exr")
    output(programs / "lavaray", "grey.txt", "--half", "-o", "half.exr")
    failures = 0
    there = 0
    print("program     version   float     half      shown  depth     object  normal")
    for reader in (oiiotool, convert, cv2, mitsuba, bpy):
        name = reader.__name__
        is_program = reader in (oiiotool, convert)
        if not (shutil.which(name) if is_program else importlib.util.find_spec(name)):
            print(f"{name:11} skipped: it is not installed")
            continue
        there += 1
        version, pixel, shown = reader()
        light, half, depth, number, normal = map(pixel, ("grey.exr", "half.exr", "grey.depth.exr", "grey.object.exr",
                                                         "grey.normal.exr"))
        limited = (lambda value: min(value, 1)) if reader is convert else (lambda value: value)
        good = [near(light, [LIGHT] * 3, 1e-4), near(half, [LIGHT] * 3, 1e-4),
                shown is None or near(shown, [GREY] * 3, 1.01 if reader is convert else 0.01), near(depth, [limited(DEPTH)], 1e-4),
                near(number, [1], 0), near(normal, [0, 0, 1], 0)]
        failures += good.count(False)
        print(f"{name:11} {version:9} {light[0]:.6f}  {half[0]:.6f}  {'-' if shown is None else round(shown[0]):>5}  "
              f"{depth[0]:.6f}  {number[0]:6g}  {' '.join(f'{value:g}' for value in normal[:3])}"
              f"{'' if all(good) else '   FAILED: expected are %f, %f and 0 0 1' % (LIGHT, DEPTH)}")
    if there == 0:
        return SKIPPED
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
