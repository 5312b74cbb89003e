"""PNG."""
import struct
import zlib

from image_cases.common import HEIGHT, RANDOM, WIDTH, Case, Refused, grey, packed_row, pixels, rows


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png_bytes(row, depth):
    if depth == 16:
        return b"".join(struct.pack(">H", v) for pixel in row for v in pixel)
    return packed_row([v for pixel in row for v in pixel], depth)


ADAM7 = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2))
COLOR_TYPES = {"grey": 0, "rgb": 2, "palette": 3, "grey-alpha": 4, "rgba": 6}


def png(values, kind, depth, interlaced=False, extra=b"", end=True):
    lines = rows(values)
    passes = ADAM7 if interlaced else ((0, 0, 1, 1),)
    data = b""
    for x0, y0, dx, dy in passes:
        for y in range(y0, HEIGHT, dy):
            row = lines[y][x0::dx]
            if row:
                data += b"\0" + png_bytes(row, depth)
    header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, depth, COLOR_TYPES[kind], 0, 0, interlaced)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra + chunk(b"IDAT", zlib.compress(data)) +
            (chunk(b"IEND", b"") if end else b""))


def png_values(values, kind, maximum):
    if kind == "grey":
        return grey(values, maximum)
    if kind == "grey-alpha":
        return [[(g, maximum)] * 3 + [(a, maximum)] for g, a in values]
    return [[(v, maximum) for v in pixel] for pixel in values]


def png_cases():
    for interlaced in (False, True):
        suffix = "-interlaced" if interlaced else ""
        for kind, channels, depths in (("grey", 1, (1, 2, 4, 8, 16)), ("rgb", 3, (8, 16)), ("grey-alpha", 2, (8, 16)),
                                       ("rgba", 4, (8, 16))):
            for depth in depths:
                maximum = 2 ** depth - 1
                values = pixels([maximum] * channels)
                yield Case(f"{kind}-{depth}{suffix}.png", png(values, kind, depth, interlaced),
                           png_values(values, kind, maximum), "PNG")
        for depth in (1, 2, 4, 8):
            palette = pixels([255] * 3, 2 ** depth)
            alphas = [RANDOM.randint(0, 255) for _ in range(2 ** depth - 1)]
            indices = pixels([2 ** depth - 1])
            colors = chunk(b"PLTE", bytes(v for color in palette for v in color))
            shown = [[(v, 255) for v in palette[i]] for i, in indices]
            yield Case(f"palette-{depth}{suffix}.png", png(indices, "palette", depth, interlaced, colors), shown, "PNG")
            with_alpha = [[*color, ((alphas + [255])[i], 255)] for color, (i,) in zip(shown, indices)]
            yield Case(f"palette-alpha-{depth}{suffix}.png",
                       png(indices, "palette", depth, interlaced, colors + chunk(b"tRNS", bytes(alphas))), with_alpha, "PNG")
        for kind, channels, depths in (("grey", 1, (1, 2, 4, 8, 16)), ("rgb", 3, (8, 16))):
            for depth in depths:
                maximum = 2 ** depth - 1
                values = pixels([maximum] * channels)
                # The transparent colour, and in 16 bits one that is the same in its upper byte.
                if depth == 16:
                    values[2] = [v ^ 1 for v in values[3]]
                key = chunk(b"tRNS", b"".join(struct.pack(">H", v) for v in values[3]))
                opaque = [(0, 1) if pixel == values[3] else (1, 1) for pixel in values]
                shown = [[*color, a] for color, a in zip(png_values(values, kind, maximum), opaque)]
                yield Case(f"{kind}-key-{depth}{suffix}.png", png(values, kind, depth, interlaced, key), shown, "PNG")
    values = pixels([65535] * 3)
    shown = png_values(values, "rgb", 65535)
    for name, extra in {
        "gamma-1": chunk(b"gAMA", struct.pack(">I", 100000)), "gamma-srgb": chunk(b"gAMA", struct.pack(">I", 45455)),
        "srgb": chunk(b"sRGB", b"\0"), "background": chunk(b"bKGD", struct.pack(">HHH", 1, 2, 3)),
        "significant-bits": chunk(b"sBIT", b"\x0c\x0c\x0c"),
        "white": chunk(b"cHRM", struct.pack(">8I", 31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000)),
        "text": chunk(b"tEXt", b"Title\0A picture"),
    }.items():
        yield Case(f"{name}.png", png(values, "rgb", 16, extra=extra), shown, "PNG")
    yield Case("png-called.bmp", png(values, "rgb", 16), shown, "PNG")
    yield Case("png-without-ending", png(values, "rgb", 16), shown, "PNG")


def png_refusals():
    palette = chunk(b"PLTE", bytes(6))
    beyond = [[3]] * (WIDTH * HEIGHT)
    for interlaced in (False, True):
        yield Refused(f"beyond-palette-{interlaced}.png", png(beyond, "palette", 2, interlaced, palette), "beyond its palette")
        yield Refused(f"beyond-palette-alpha-{interlaced}.png",
                      png(beyond, "palette", 2, interlaced, palette + chunk(b"tRNS", b"\1")), "beyond its palette")
    values = pixels([255] * 3)
    key = chunk(b"tRNS", b"\0\1\0\2\0\3")
    for name, data in {
        "no-palette": png(beyond, "palette", 2), "no-end": png(values, "rgb", 8, end=False),
        "key-too-short": png(values, "rgb", 8, extra=chunk(b"tRNS", b"\0\1")),
        "key-damaged": png(values, "rgb", 8, extra=key[:-1] + bytes((key[-1] ^ 1,))),
        "depth-3": png(beyond, "grey", 4).replace(struct.pack(">BBBBB", 4, 0, 0, 0, 0), struct.pack(">BBBBB", 3, 0, 0, 0, 0)),
    }.items():
        yield Refused(f"{name}.png", data, "is no PNG image or is damaged")
    text = png(values, "rgb", 8, extra=chunk(b"tEXt", b"Title\0A picture"))
    yield Refused("long-chunk.png", text.replace(b"\0\0\0\x0ftEXt", b"\x50\0\0\x0ftEXt"), "ends before all of its pixels")
    wide = struct.pack(">IIBBBBB", 900000, 900000, 8, 2, 0, 0, 0)
    yield Refused("huge.png", b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", wide) + chunk(b"IDAT", zlib.compress(b"\0")),
                  "ends before all of its pixels")
