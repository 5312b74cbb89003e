"""PFM images, and how much two of them differ."""

import importlib.util
import math
import re
import sys
from array import array
from dataclasses import dataclass


@dataclass
class Image:
    width: int
    height: int
    values: array  # three floats per pixel, the bottom row first as in a PFM


def read_pfm(path):
    """Colour PFM as lavaray writes it. Raises ValueError naming the path if it is anything else."""
    data = path.read_bytes()
    try:
        kind, size, scale, pixels = data.split(b"\n", 3)
        width, height = (int(word) for word in size.split())
        big_endian = float(scale) > 0
    except ValueError as error:
        raise ValueError(f"{path}: not a PFM image") from error
    if kind.strip() != b"PF" or len(pixels) != 12 * width * height:
        raise ValueError(f"{path}: not a colour PFM image of {width} x {height} pixels")
    values = array("f", pixels)
    if big_endian != (sys.byteorder == "big"):
        values.byteswap()
    return Image(width, height, values)


def read_ppm(path):
    """Binary PPM with 16 bits per channel. Raises ValueError naming the path if it is anything else."""
    data = path.read_bytes()
    header = re.match(rb"P6\s+(?:#[^\n]*\n\s*)*(\d+)\s+(\d+)\s+65535\s", data)
    if not header:
        raise ValueError(f"{path}: not a PPM image of 16 bits a channel")
    width, height = (int(word) for word in header.groups())
    levels = array("H", data[header.end():])
    if len(levels) != 3 * width * height:
        raise ValueError(f"{path}: not a PPM image of {width} x {height} pixels")
    if sys.byteorder == "little":
        levels.byteswap()
    rows = [levels[start:start + 3 * width] for start in range(0, len(levels), 3 * width)]
    return Image(width, height, array("f", (level / 65535 for row in reversed(rows) for level in row)))


def write_pfm(path, image):
    if sys.byteorder == "big":
        raise NotImplementedError("this writes the machine's byte order, and says little-endian")
    header = f"PF\n{image.width} {image.height}\n-1.0\n".encode()
    path.write_bytes(header + image.values.tobytes())


def mean(a, b):
    return Image(a.width, a.height, array("f", ((x + y) / 2 for x, y in zip(a.values, b.values))))


def rmse(image, reference):
    require_same_size(image, reference)
    squares = math.fsum((x - y) ** 2 for x, y in zip(image.values, reference.values))
    return math.sqrt(squares / len(reference.values))


def rel_mse(image, reference, epsilon=1e-2):
    """Rousselle, Knaus, Zwicker, "Adaptive Sampling and Reconstruction using Greedy Error Minimization", 2011."""
    total = math.fsum((x - y) ** 2 / (y * y + epsilon) for x, y in zip(image.values, reference.values))
    return total / len(reference.values)


def max_error(image, reference):
    return max(abs(x - y) for x, y in zip(image.values, reference.values))


def require_same_size(image, reference):
    if (image.width, image.height) != (reference.width, reference.height):
        raise ValueError(
            f"an image of {image.width} x {image.height} pixels cannot be compared with one of "
            f"{reference.width} x {reference.height}"
        )


def flip_is_available():
    return importlib.util.find_spec("flip_evaluator") is not None


def mean_flip(image, reference):
    """Mean of the FLIP map (Andersson et al., 2020). The values are those of an 8-bit file, so they count as sRGB.

    Needs the package flip_evaluator.
    """
    import flip_evaluator
    import numpy

    shape = (reference.height, reference.width, 3)
    arrays = [numpy.frombuffer(i.values, dtype=numpy.float32).reshape(shape) for i in (reference, image)]
    return float(flip_evaluator.evaluate(*arrays, "LDR", inputsRGB=True)[1])


def errors(image, reference, with_flip):
    result = {
        "rmse": rmse(image, reference),
        "relmse": rel_mse(image, reference),
        "max": max_error(image, reference),
    }
    if with_flip:
        result["flip"] = mean_flip(image, reference)
    return result
