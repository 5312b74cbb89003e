"""BMP."""
import struct

from image_cases.common import HEIGHT, RANDOM, WIDTH, Case, Refused, packed_row, paired, pixels, rows


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
