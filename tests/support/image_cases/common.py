"""What a case is, and what those of several formats are made of."""
import dataclasses
import random
import struct

WIDTH, HEIGHT = 7, 5  # rows of no full word in any depth
RANDOM = random.Random(20261128)


@dataclasses.dataclass
class Case:
    name: str  # its ending is the file's
    data: bytes
    values: list  # of pixels, each a list of (value, maximum) or floats
    format: str
    width: int = WIDTH
    height: int = HEIGHT


@dataclasses.dataclass
class Refused:
    name: str
    data: bytes
    message: str  # a regular expression


def as_float32(value):
    """The value rounded once, for a pair: so few bits in both leave no double rounding."""
    number = value[0] / value[1] if isinstance(value, tuple) else value
    return struct.unpack("f", struct.pack("f", number))[0]


def pixels(maxima, count=WIDTH * HEIGHT):
    """Integers for each channel, the ends of its range among them."""
    result = [[RANDOM.randint(0, maximum) for maximum in maxima] for _ in range(count)]
    result[0] = [0] * len(maxima)
    result[1] = list(maxima)
    return result


def paired(values, maxima):
    return [[(v, m) for v, m in zip(pixel, maxima)] for pixel in values]


def grey(values, maximum):
    return [[(pixel[0], maximum)] * 3 for pixel in values]


def rows(values, width=WIDTH):
    return [values[i:i + width] for i in range(0, len(values), width)]


def packed_row(indices, bits):
    text = "".join(format(index, f"0{bits}b") for index in indices)
    text += "0" * (-len(text) % 8)
    return bytes(int(text[i:i + 8], 2) for i in range(0, len(text), 8))
