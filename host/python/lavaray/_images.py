"""Pictures in files, and how two of them differ."""

from __future__ import annotations

import dataclasses
import os
from typing import Any

import numpy

from lavaray import _core
from lavaray._errors import Error
from lavaray._scene import Array, StrPath

Image = numpy.ndarray[Any, numpy.dtype[numpy.float32]]


@dataclasses.dataclass(frozen=True)
class Difference:
    """How two pictures differ."""

    pixels: int
    differing: int  # pixels with a channel that is off by more than the tolerance
    largest: float  # difference of a channel
    largest_at: tuple[int, int]  # x, y
    rmse: float
    flip: float  # mean FLIP, from 0 (they look the same) to 1


def read_image(file: StrPath) -> Image:
    """Reads BMP, PNG, PPM, PGM, PBM, PFM and EXR: (height, width, 3) float32, integers divided by their maximum."""
    return _core.read_image(os.fspath(file))


def write_image(image: Array, file: StrPath) -> None:
    """Writes (height, width, 3) colours; the ending says the format: .bmp, .png, .ppm, .pfm, .exr.

    The file appears whole or not at all.
    """
    _core.write_image(_image(image), os.fspath(file))


def compare(image: Array, reference: Array, tolerance: float = 0.0) -> Difference:
    """Compares two pictures of the same size."""
    return Difference(**_core.compare(_image(image), _image(reference), tolerance))


def flip_map(image: Array, reference: Array) -> Image:
    """FLIP of each pixel: (height, width) float32, from 0 (they look the same) to 1."""
    return _core.flip_map(_image(image), _image(reference))


def _image(values: Array) -> Image:
    array = numpy.ascontiguousarray(values, numpy.float32)
    if array.ndim != 3 or array.shape[2] != 3 or array.size == 0:
        raise Error(f"a picture has the shape {array.shape}, (height, width, 3) is needed", "usage")
    return array
