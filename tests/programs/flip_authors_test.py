#!/usr/bin/env python3
"""flip_authors_test.py PROGRAMS SCENES SCRATCH: the mean FLIP of lavaray-diff against that of its authors.

Renders pairs of images, each different in another way, and compares what lavaray-diff prints with what the Python
package flip-evaluator computes. Exits with 77, which CTest takes for a skipped test, where that is not installed.
"""
import pathlib
import subprocess
import sys

TOLERANCE = 1e-4
SKIPPED = 77

try:
    import flip_evaluator
    import numpy
except ImportError as error:
    print(f"skipped: the Python package {error.name} is not installed (pip install flip-evaluator)")
    sys.exit(SKIPPED)

programs, scenes, scratch = (pathlib.Path(argument) for argument in sys.argv[1:4])
scratch.mkdir(parents=True, exist_ok=True)


def rendered(name, scene, *options):
    """Renders a scene and returns its pixels, 8 bits a channel."""
    file = scratch / f"{name}.ppm"
    subprocess.run([programs / "lavaray", scenes / scene, "--width", "320", *options, "-o", file], check=True)
    _, size, _, pixels = file.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    return numpy.frombuffer(pixels, numpy.uint8).reshape(height, width, 3)


def written(name, pixels):
    file = scratch / f"{name}.ppm"
    height, width, _ = pixels.shape
    file.write_bytes(b"P6\n%d %d\n255\n" % (width, height) + pixels.astype(numpy.uint8).tobytes())
    return file


def blurred(pixels):
    """The mean over squares of 7 pixels; at the sides the nearest pixel goes on."""
    padded = numpy.pad(pixels.astype(float), ((3, 3), (3, 3), (0, 0)), "edge")
    height, width, _ = pixels.shape
    return sum(padded[y : y + height, x : x + width] for y in range(7) for x in range(7)) / 49


def pairs():
    """Yields name, image and reference."""
    showcase = rendered("showcase", "showcase.txt", "--spp", "16")
    soft = rendered("soft", "extensions.txt", "--spp", "64")
    lights = rendered("lights", "lights.txt")
    yield "one sample a pixel", rendered("noisy", "extensions.txt", "--sampler", "random", "--spp", "2"), soft
    yield "shifted by two pixels", showcase[:, 2:], showcase[:, :-2]
    yield "blurred", blurred(showcase), showcase
    yield "other light", rendered("other-lights", "lights.txt", "--spp", "4", "--light-radius", "5"), lights
    yield "half the blue", showcase * [1, 1, 0.5], showcase
    yield "another picture", rendered("spheres", "thousand-spheres.txt")[:200, :300], showcase[:200, :300]
    yield "smaller than a filter", soft[100:105, 150:157], lights[100:105, 150:157]


def printed_flip(image, reference):
    program = [programs / "lavaray-diff", image, reference, "--max-flip", "1"]
    output = subprocess.run(program, check=True, capture_output=True, text=True).stdout
    return float(next(line for line in output.splitlines() if line.startswith("mean FLIP")).split()[-1])


def main():
    failures = 0
    for name, image, reference in pairs():
        image = image.astype(numpy.uint8)
        ours = printed_flip(written("image", image), written("reference", reference))
        as_floats = (numpy.ascontiguousarray(pixels, numpy.float32) / 255 for pixels in (reference, image))
        _, theirs, _ = flip_evaluator.evaluate(*as_floats, "LDR", applyMagma=False)
        agrees = abs(ours - theirs) <= TOLERANCE and theirs > 0
        failures += not agrees
        print(f"{'agrees' if agrees else 'FAILED'}: {name}: {ours:.6f}, the authors' {theirs:.6f}, "
              f"off by {abs(ours - theirs):.1e}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
