"""Image files of every kind and variant, written byte by byte, each with the values that it holds.

A case's values are pairs of integers, value and maximum, or floats; three or, with alpha, four a pixel, row by row from
the top.
"""
import dataclasses
import math
import random
import struct
import zlib

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


# PBM, PGM and PPM

def pnm_raster(values, maximum):
    return b"".join(struct.pack(">H" if maximum > 255 else "B", v) for pixel in values for v in pixel)


def pnm_text(values):
    return b"\n".join(b" ".join(b"%d" % v for v in pixel) for pixel in values) + b"\n"


def bitmap_raster(values):
    return b"".join(packed_row([pixel[0] for pixel in row], 1) for row in rows(values))


def packed_row(indices, bits):
    text = "".join(format(index, f"0{bits}b") for index in indices)
    text += "0" * (-len(text) % 8)
    return bytes(int(text[i:i + 8], 2) for i in range(0, len(text), 8))


def pnm_cases():
    size = b"%d %d" % (WIDTH, HEIGHT)
    for maximum in (1, 3, 15, 100, 200, 254, 255, 256, 1000, 1023, 4095, 65534, 65535):
        colors, greys = pixels([maximum] * 3), pixels([maximum])
        if maximum == 65535:
            # Bytes that look like white space or a comment, where the pixels begin.
            colors[0], greys[0] = [0x0A20, 0x2323, 0x0D0A], [0x2009]
        yield Case(f"p6-{maximum}.ppm", b"P6\n%s\n%d\n" % (size, maximum) + pnm_raster(colors, maximum),
                   paired(colors, [maximum] * 3), "PPM")
        yield Case(f"p5-{maximum}.pgm", b"P5\n%s\n%d\n" % (size, maximum) + pnm_raster(greys, maximum),
                   grey(greys, maximum), "PGM")
        yield Case(f"p3-{maximum}.ppm", b"P3\n%s\n%d\n" % (size, maximum) + pnm_text(colors),
                   paired(colors, [maximum] * 3), "PPM")
        yield Case(f"p2-{maximum}.pgm", b"P2\n%s\n%d\n" % (size, maximum) + pnm_text(greys), grey(greys, maximum), "PGM")
    bits = pixels([1])
    white = [[(1 - pixel[0], 1)] * 3 for pixel in bits]
    yield Case("p4.pbm", b"P4\n" + size + b"\n" + bitmap_raster(bits), white, "PBM")
    yield Case("p1.pbm", b"P1\n" + size + b"\n" + pnm_text(bits), white, "PBM")
    yield Case("p1-joined.pbm", b"P1\n" + size + b"\n" + b"".join(b"%d" % p[0] for p in bits), white, "PBM")
    colors = pixels([255] * 3)
    colors[0] = [10, 35, 32]
    raster, text, values = pnm_raster(colors, 255), pnm_text(colors), paired(colors, [255] * 3)
    for name, header in {
        "space-after-maximum": b"P6\n%s\n255 ", "one-line": b"P6 %s 255\n", "comment-after-first-word": b"P6 # a\n%s\n255\n",
        "comment-at-first-word": b"P6#a\n%s\n255\n", "comment-with-numbers": b"P6\n# 9 9 255\n%s\n# 1\n255\n",
        "comment-before-maximum": b"P6\n%s #w h\n#m\n255\n", "tabs": b"P6\t%s\t255\t", "crlf-inside": b"P6\r\n%s\r\n255\n",
        "zeros-in-front": b"P6\n%s\n00255\n", "comment-at-maximum": b"P6\n%s\n255#c\n", "blank-lines": b"P6\n\n\n%s\n\n255\n",
        "cr-only": b"P6\r# c\r%s\r255\r",
    }.items():
        yield Case(f"header-{name}.ppm", header % size + raster, values, "PPM")
    yield Case("line-end-behind.ppm", b"P6\n%s\n255\n" % size + pnm_raster([[1, 2, 3]] + colors[1:], 255) + b"\n",
               paired([[1, 2, 3]] + colors[1:], [255] * 3), "PPM")
    yield Case("p3-one-line.ppm", b"P3 %s 255 " % size + text.replace(b"\n", b" "), values, "PPM")
    yield Case("p3-comments.ppm", b"P3 %s 255\n" % size + text.replace(b"\n", b" # 7\n"), values, "PPM")
    yield Case("p3-crlf.ppm", b"P3\r\n%s\r\n255\r\n" % size + text.replace(b"\n", b"\r\n"), values, "PPM")
    yield Case("p3-no-end.ppm", b"P3\n%s\n255\n" % size + text.rstrip(), values, "PPM")
    yield Case("p6-called.pgm", b"P6\n%s\n255\n" % size + raster, values, "PPM")
    yield Case("p6-without-ending", b"P6\n%s\n255\n" % size + raster, values, "PPM")


# PFM

def pfm(values, channels, order, scale=None, header=None):
    body = b"".join(struct.pack(f"{order}f", v) for row in reversed(rows(values)) for p in row for v in p[:channels])
    scale = scale if scale is not None else (b"-1.0" if order == "<" else b"1.0")
    begin = header or b"P%s\n%d %d\n%s\n"
    return begin % (b"F" if channels == 3 else b"f", WIDTH, HEIGHT, scale) + body


def pfm_cases():
    colors = [[RANDOM.uniform(-2, 3) for _ in range(3)] for _ in range(WIDTH * HEIGHT)]
    colors[3] = [1e-42, 3e38, -3e38]
    greys = [[p[0]] * 3 for p in colors]
    for name, order in (("little", "<"), ("big", ">")):
        yield Case(f"{name}.pfm", pfm(colors, 3, order), colors, "PFM")
        yield Case(f"grey-{name}.pfm", pfm(greys, 1, order), greys, "PFM")
    for scale in (b"-1", b"-1.000000", b"-1e0"):
        yield Case(f"scale{scale.decode()}.pfm", pfm(colors, 3, "<", scale), colors, "PFM")
    yield Case("scale-plus.pfm", pfm(colors, 3, ">", b"+1"), colors, "PFM")
    yield Case("comment.pfm", pfm(colors, 3, "<", header=b"P%s\n# c\n%d %d\n%s\n"), colors, "PFM")
    yield Case("one-line.pfm", pfm(colors, 3, "<", header=b"P%s %d %d %s\n"), colors, "PFM")
    odd = [list(p) for p in colors]
    odd[2], odd[5] = [math.inf, -math.inf, 1], [math.nan, 0, 1]
    yield Case("not-finite.pfm", pfm(odd, 3, "<"), odd, "PFM")


# PNG

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


# BMP

def bmp(header_size, bits, body, *, width=WIDTH, height=HEIGHT, compression=0, palette=(), masks=(), used=None,
        top_down=False, gap=0, planes=1):
    """`masks` go into the header, or behind one of 40 bytes."""
    if header_size == 12:
        header = struct.pack("<IHHHH", 12, width, height, planes, bits)
        colors = b"".join(bytes((b, g, r)) for r, g, b in palette)
    else:
        header = struct.pack("<IiiHHIIiiII", header_size, width, -height if top_down else height, planes, bits, compression,
                             len(body), 2835, 2835, len(palette) if used is None else used, 0)
        words = struct.pack(f"<{len(masks)}I", *masks)
        header = (header + words).ljust(header_size, b"\0") if header_size > 40 else header[:header_size] + words
        colors = b"".join(bytes((b, g, r, 0)) for r, g, b in palette)
    at = 14 + len(header) + len(colors) + gap
    return b"BM" + struct.pack("<IHHI", at + len(body), 0, 0, at) + header + colors + b"\0" * gap + body


def bmp_rows(lines, top_down=False):
    padded = [line + b"\0" * (-len(line) % 4) for line in lines]
    return b"".join(padded if top_down else reversed(padded))


def masked(values, masks):
    """The pixels as integers, and the maximum of each mask."""
    shifts = [(mask & -mask).bit_length() - 1 for mask in masks]
    words = [sum(v << shift for v, shift in zip(pixel, shifts)) for pixel in values]
    return words


def maximum_of(mask):
    return mask // (mask & -mask)


def bmp_masked(name, header_size, bits, masks, compression=3, top_down=False, written_masks=None):
    values = pixels([maximum_of(mask) for mask in masks])
    code = "<H" if bits == 16 else "<I"
    words = masked(values, masks)
    lines = [b"".join(struct.pack(code, word) for word in row) for row in rows(words)]
    written = masks if written_masks is None else written_masks
    data = bmp(header_size, bits, bmp_rows(lines, top_down), compression=compression, masks=written, top_down=top_down)
    return Case(f"{name}.bmp", data, paired(values, [maximum_of(mask) for mask in masks]), "BMP")


def run_lengths(indices, bits, literal):
    """RLE8 or RLE4: runs of one pixel or of two by turns, or, where `literal`, pixels one by one."""
    data = b""
    for row in reversed(rows([i for i, in indices])):
        if literal:
            body = bytes(row) if bits == 8 else packed_row(row, 4)
            data += bytes((0, len(row))) + body + b"\0" * (len(body) % 2)
        else:
            at = 0
            while at < len(row):
                end = at + 1
                while end < len(row) and row[end] == row[at]:
                    end += 1
                data += bytes((end - at, row[at] if bits == 8 else row[at] * 17))
                at = end
        data += b"\0\0"
    return data + b"\0\1"


def bmp_cases():
    for bits in (1, 2, 4, 8):
        palette = pixels([255] * 3, 2 ** bits)
        indices = pixels([2 ** bits - 1])
        shown = [[(v, 255) for v in palette[i]] for i, in indices]
        for top_down in (False, True):
            lines = [packed_row([i for i, in row], bits) for row in rows(indices)]
            data = bmp(40, bits, bmp_rows(lines, top_down), palette=palette, top_down=top_down)
            yield Case(f"bmp-{bits}{'-top-down' if top_down else ''}.bmp", data, shown, "BMP")
        body = bmp_rows(lines)
        for size in (12, 16, 64, 108, 124):
            yield Case(f"bmp-{bits}-header-{size}.bmp", bmp(size, bits, body, palette=palette), shown, "BMP")
        yield Case(f"bmp-{bits}-unsaid.bmp", bmp(40, bits, body, palette=palette, used=0), shown, "BMP")
    few = pixels([255] * 3, 5)
    indices = pixels([4])
    shown = [[(v, 255) for v in few[i]] for i, in indices]
    body = bmp_rows([bytes(i for i, in row) for row in rows(indices)])
    yield Case("bmp-few-colors.bmp", bmp(40, 8, body, palette=few), shown, "BMP")
    yield Case("bmp-few-unsaid.bmp", bmp(40, 8, body, palette=few, used=0), shown, "BMP")
    yield Case("bmp-few-os2.bmp", bmp(12, 8, body, palette=few), shown, "BMP")
    for bits, compression in ((8, 1), (4, 2)):
        palette = pixels([255] * 3, 2 ** bits)
        indices = [[i] for row in range(HEIGHT) for i in [RANDOM.randrange(2 ** bits)] * 4 + [1, 2, 2]]
        shown = [[(v, 255) for v in palette[i]] for i, in indices]
        for literal in (False, True):
            data = bmp(40, bits, run_lengths(indices, bits, literal), compression=compression, palette=palette)
            yield Case(f"bmp-rle{bits}{'-literal' if literal else ''}.bmp", data, shown, "BMP")
    turns = [[(3, 9)[x % 2]] for _ in range(HEIGHT) for x in range(WIDTH)]
    palette = pixels([255] * 3, 16)
    yield Case("bmp-rle4-two-colors.bmp", bmp(40, 4, b"\x07\x39\0\0" * HEIGHT + b"\0\1", compression=2, palette=palette),
               [[(v, 255) for v in palette[i]] for i, in turns], "BMP")
    colors = pixels([255] * 3)
    lines = [b"".join(bytes(reversed(p)) for p in row) for row in rows(colors)]
    for top_down in (False, True):
        yield Case(f"bmp-24{'-top-down' if top_down else ''}.bmp",
                   bmp(40, 24, bmp_rows(lines, top_down), top_down=top_down), paired(colors, [255] * 3), "BMP")
    for size in (12, 16, 52, 56, 64, 108, 124):
        yield Case(f"bmp-24-header-{size}.bmp", bmp(size, 24, bmp_rows(lines)), paired(colors, [255] * 3), "BMP")
    yield Case("bmp-24-gap.bmp", bmp(40, 24, bmp_rows(lines), gap=22), paired(colors, [255] * 3), "BMP")
    yield Case("bmp-24-palette.bmp", bmp(40, 24, bmp_rows(lines), palette=few), paired(colors, [255] * 3), "BMP")
    lines = [b"".join(bytes(reversed(p)) + b"\x77" for p in row) for row in rows(colors)]
    yield Case("bmp-32.bmp", bmp(40, 32, bmp_rows(lines)), paired(colors, [255] * 3), "BMP")
    yield bmp_masked("bmp-16", 40, 16, (0x7C00, 0x3E0, 0x1F), 0, written_masks=())
    yield bmp_masked("bmp-16-os2", 64, 16, (0x7C00, 0x3E0, 0x1F), 0, written_masks=())
    yield bmp_masked("bmp-16-top-down", 40, 16, (0x7C00, 0x3E0, 0x1F), 0, True, ())
    for size in (40, 52, 56, 108, 124):
        yield bmp_masked(f"bmp-565-{size}", size, 16, (0xF800, 0x7E0, 0x1F))
        yield bmp_masked(f"bmp-bgr-{size}", size, 32, (0xFF, 0xFF00, 0xFF0000))
    yield bmp_masked("bmp-555-bgr", 40, 16, (0x1F, 0x3E0, 0x7C00))
    yield bmp_masked("bmp-uneven", 40, 16, (0x8000, 0x7FE0, 0x7))
    yield bmp_masked("bmp-101010", 40, 32, (0x3FF00000, 0xFFC00, 0x3FF))
    yield bmp_masked("bmp-111110", 40, 32, (0xFFE00000, 0x1FFC00, 0x3FF))
    yield bmp_masked("bmp-16-bits-of-red", 40, 32, (0xFFFF, 0xFF0000, 0xFF000000))
    for size in (56, 108, 124):
        yield bmp_masked(f"bmp-alpha-{size}", size, 32, (0xFF0000, 0xFF00, 0xFF, 0xFF000000))
        yield bmp_masked(f"bmp-4444-{size}", size, 16, (0xF00, 0xF0, 0xF, 0xF000))
    yield bmp_masked("bmp-5551", 124, 16, (0x7C00, 0x3E0, 0x1F, 0x8000))
    yield bmp_masked("bmp-alpha-fields", 40, 32, (0xFF0000, 0xFF00, 0xFF, 0xFF000000), 6)
    yield Case("bmp-called.png", bmp(40, 24, bmp_rows([b"\1\2\3" * WIDTH] * HEIGHT)),
               [[(3, 255), (2, 255), (1, 255)]] * (WIDTH * HEIGHT), "BMP")


def cases():
    yield from pnm_cases()
    yield from pfm_cases()
    yield from png_cases()
    yield from bmp_cases()


# What is refused

def pnm_refusals():
    size, body = b"%d %d" % (WIDTH, HEIGHT), b"\x80" * (3 * WIDTH * HEIGHT)
    yield Refused("maximum-0.ppm", b"P6\n%s\n0\n" % size + body, 'its maximum is "0"; allowed are the integers from 1 to 65535')
    yield Refused("maximum-65536.ppm", b"P6\n%s\n65536\n" % size + body * 2, 'its maximum is "65536"')
    yield Refused("maximum-word.ppm", b"P6\n%s\n255x\n" % size + body, 'its maximum is "255x"')
    yield Refused("width-negative.ppm", b"P6\n-7 5\n255\n" + body, 'its width is "-7"')
    yield Refused("width-0.ppm", b"P6\n0 5\n255\n", 'its width is "0"')
    yield Refused("too-wide.ppm", b"P6\n2000000 1\n255\n" + body, "2000000 x 1 pixels by its header; allowed are 1 to 1000000")
    yield Refused("above-maximum.ppm", b"P6\n%s\n100\n" % size + body, "a pixel is 128; its maximum allows 0 to 100")
    yield Refused("p3-above-maximum.ppm", b"P3 1 1 9 1 10 3", 'a pixel is "10"; allowed are the integers from 0 to 9')
    yield Refused("p3-word.ppm", b"P3 1 1 9 1 x 3", 'a pixel is "x"')
    yield Refused("p1-two.pbm", b"P1 2 1 02", 'a pixel is "2"; allowed are 0 and 1')
    yield Refused("two-images.ppm", b"P6 1 1 255\nabcP6 1 1 255\nabc", "14 bytes longer than its pixels; allowed are one image")
    yield Refused("blank-after-maximum.ppm", b"P6 1 1 255 \nabc", "1 bytes longer than its pixels")
    yield Refused("comment-after-maximum.ppm", b"P6 1 1 255 # a\nabc", "bytes longer than its pixels")
    yield Refused("crlf-after-maximum.ppm", b"P6 1 1 255\r\nabc", "1 bytes longer than its pixels")
    yield Refused("p3-two.ppm", b"P3 1 1 9 1 2 3 4", 'goes on with "4"')
    yield Refused("huge.ppm", b"P6 1000000 1000000 255\n", "ends before all of its pixels")
    yield Refused("huge-text.ppm", b"P3 1000000 1000000 255\n1 2", "ends before all of its pixels")
    yield Refused("pam.ppm", b"P7\nWIDTH 1\n", "is a PAM image, which is not read; allowed are BMP, PNG")


def pfm_refusals():
    body = b"\0" * 12
    for scale in (b"0", b"x", b"nan", b"inf", b"1e999", b"-0.0", b"2", b"-0.003922"):
        yield Refused(f"scale-{scale.decode()}.pfm", b"PF 1 1 %s\n" % scale + body, "its scale is .*; allowed are 1 and -1, since programs")
    yield Refused("alpha.pfm", b"PF4\n1 1\n-1\n" + body, "is no image that can be read")
    yield Refused("longer.pfm", b"PF 1 1 -1\n" + body + b"x", "1 bytes longer than its pixels")


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


def bmp_refusals():
    body = bytes(4 * WIDTH * HEIGHT)
    few = [[1, 2, 3]] * 3
    for name, arguments, message in (
        ("header-48", (48, 24, body), "whose header has 48 bytes; allowed are 12, 16, 40"),
        ("bits-3", (40, 3, body), "of 3 bits a pixel; allowed are 1, 2, 4"), ("bits-0", (40, 0, body), "of 0 bits"),
        ("bits-64", (40, 64, body * 2), "of 64 bits a pixel"), ("no-palette", (40, 8, body), "without a palette"),
    ):
        yield Refused(f"bmp-{name}.bmp", bmp(*arguments), message)
    for name, size, bits, options, message in (
        ("jpeg", 40, 24, {"compression": 4}, "with a JPEG image inside; allowed are no compression, run lengths"),
        ("png", 40, 24, {"compression": 5}, "with a PNG image inside"), ("cmyk", 40, 32, {"compression": 11}, "CMYK"),
        ("huffman", 64, 1, {"compression": 3, "palette": few[:2]}, "Huffman codes"),
        ("rle24", 64, 24, {"compression": 4}, "run lengths of 24 bits"), ("99", 40, 24, {"compression": 99}, "number 99"),
        ("rle8-of-24", 40, 24, {"compression": 1}, "does not go with its 24 bits"),
        ("fields-24", 40, 24, {"compression": 3, "masks": (1, 2, 4)}, "does not go with its 24 bits"),
        ("rle8-top-down", 40, 8, {"compression": 1, "palette": few, "top_down": True}, "from the top down"),
        ("planes", 40, 24, {"planes": 3}, "of 3 planes"),
        ("mask-holes", 40, 32, {"compression": 3, "masks": (0x550000, 0xFF00, 0xFF)}, "a mask that is not 1 to 16 neighbouring"),
        ("mask-wide", 40, 32, {"compression": 3, "masks": (0xFFFFF000, 0xF00, 0xF)}, "a mask that is not 1 to 16"),
        ("mask-outside", 40, 16, {"compression": 3, "masks": (0x1F0000, 0x7E0, 0x1F)}, "a mask that is not 1 to 16"),
        ("masks-overlap", 40, 16, {"compression": 3, "masks": (0xF800, 0xFE0, 0x1F)}, "bits in common"),
        ("mask-none", 40, 16, {"compression": 3, "masks": (0xF800, 0, 0x1F)}, "without a mask for each"),
        ("beyond-palette", 40, 8, {"palette": few[:0] or few, "used": 3}, "a pixel of colour 9; its palette has 0 to 2"),
    ):
        pixels_of = b"\x09" * len(body) if name == "beyond-palette" else body
        yield Refused(f"bmp-{name}.bmp", bmp(size, bits, pixels_of, **options), message)
    palette = [[1, 2, 3]] * 256
    row = b"\x07\x01\0\0"
    for name, data, message in (
        ("skips", b"\0\2\1\1" + row * HEIGHT + b"\0\1", "leave pixels out"), ("early-end", row * 2 + b"\0\1", "leave pixels out"),
        ("short-row", b"\x03\1\0\0" + row * HEIGHT + b"\0\1", "leave pixels out"),
        ("long-run", b"\x08\1\0\0" + row * HEIGHT + b"\0\1", "longer than the rest of its row"),
        # As programs write that count a row's padding as pixels.
        ("padded-rows", row[:2] + row * HEIGHT + b"\0\1", "longer than the rest of its row"),
        ("cut", row * (HEIGHT - 1), "ends before all of its pixels"),
    ):
        yield Refused(f"bmp-rle8-{name}.bmp", bmp(40, 8, data, compression=1, palette=palette), message)
    yield Refused("bmp-huge.bmp", bmp(40, 24, body, width=900000, height=900000), "ends before all of its pixels")
    yield Refused("bmp-huge-runs.bmp", bmp(40, 8, body, width=900000, height=900000, compression=1, palette=palette),
                  "ends before all of its pixels")
    yield Refused("bmp-negative-width.bmp", bmp(40, 24, body, width=-7), "has -7 x 5 pixels")
    yield Refused("bmp-lowest-height.bmp", bmp(40, 24, body, height=-2 ** 31), "by its header; allowed are 1 to")
    yield Refused("bmp-pixels-in-header.bmp", bmp(40, 24, body, gap=-9), "whose pixels begin inside its header")


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
