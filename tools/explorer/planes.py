"""Numbers for each pixel as PNG files of grey bytes, in base64: the page's browser decodes them, bit for bit."""

import base64
import struct
import zlib

import numpy as np


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def filtered(rows):
    """Each row by that of PNG's filters whose differences are the smallest in sum."""
    rows = rows.astype(np.int16)
    left = np.pad(rows, ((0, 0), (1, 0)))[:, :-1]
    above = np.pad(rows, ((1, 0), (0, 0)))[:-1]
    corner = np.pad(rows, ((1, 0), (1, 0)))[:-1, :-1]
    guess = left + above - corner
    by_left, by_above, by_corner = abs(guess - left), abs(guess - above), abs(guess - corner)
    paeth = np.where((by_left <= by_above) & (by_left <= by_corner), left, np.where(by_above <= by_corner, above, corner))
    choices = np.stack([rows - other for other in (0 * rows, left, above, (left + above) // 2, paeth)]) & 255
    cost = np.minimum(choices, 256 - choices).sum(axis=2)
    best = cost.argmin(axis=0)
    bytes_ = choices[best, np.arange(len(rows))].astype(np.uint8)
    return np.concatenate([best[:, None].astype(np.uint8), bytes_], axis=1).tobytes()


def grey_png(plane):
    height, width = plane.shape
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(filtered(plane), 9)) +
            chunk(b"IEND", b""))


def encoded(values, least, most, size):
    """(height, width, channels) in [least, most], as whole numbers of `size` bytes: a plane below the other for each
    byte, the high one first, of each channel. Returns what the page knows of it."""
    steps = 256**size - 1
    scale = (most - least) / steps if most > least else 1.0
    whole = np.rint((np.asarray(values, dtype=float) - least) / scale).clip(0, steps).astype(np.uint32)
    planes = [(whole[..., channel] >> 8 * byte) & 255 for channel in range(whole.shape[2]) for byte in reversed(range(size))]
    return {"least": float(least), "step": float(scale), "bytes": size, "channels": whole.shape[2],
            "png": base64.b64encode(grey_png(np.concatenate(planes))).decode()}
