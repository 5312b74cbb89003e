"""Image files of every kind and variant, written byte by byte, each with the values that it holds.

A case's values are pairs of integers, value and maximum, or floats; three or, with alpha, four a pixel, row by row from
the top.
"""
from image_cases.bmp_files import bmp_cases, bmp_masked, bmp_refusals
from image_cases.common import HEIGHT, RANDOM, WIDTH, Refused, as_float32, pixels
from image_cases.pfm_files import pfm, pfm_cases, pfm_refusals
from image_cases.png_files import chunk, png, png_cases, png_refusals
from image_cases.pnm_files import pnm_cases, pnm_raster, pnm_refusals


def cases():
    yield from pnm_cases()
    yield from pfm_cases()
    yield from png_cases()
    yield from bmp_cases()


def other_refusals():
    for name, data, what in (
        ("a.jpg", b"\xff\xd8\xff\xe0" + bytes(20), "a JPEG image"), ("b.png", b"GIF89a" + bytes(20), "a GIF image"),
        ("c.tif", b"II*\0" + bytes(20), "a TIFF image"), ("d.webp", b"RIFF\0\0\0\0WEBPVP8 ", "a WebP image"),
        ("e.hdr", b"#?RADIANCE\n", "a Radiance image"), ("f.bmp", b"BA" + bytes(40), "an OS/2 array of bitmaps"),
        ("g.ppm.gz", b"\x1f\x8b\x08" + bytes(20), "a compressed file"), ("h.avif", b"\0\0\0\x1cftypavif", "an AVIF or HEIF"),
    ):
        yield Refused(name, data, f"is {what}.*, which is not read; allowed are BMP, PNG, PPM, PGM, PBM, PFM and EXR")
    yield Refused("text.ppm", b"P6 is how a PPM begins", "its width is \"is\"")
    yield Refused("other.txt", b"5\ncamera\n", "is no image that can be read; allowed are BMP")
    yield Refused("empty.png", b"", "is empty; allowed are BMP")


def refusals():
    yield from pnm_refusals()
    yield from pfm_refusals()
    yield from png_refusals()
    yield from bmp_refusals()
    yield from other_refusals()
