"""PFM."""
import math
import struct

from image_cases.common import HEIGHT, RANDOM, WIDTH, Case, Refused, rows


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


def pfm_refusals():
    body = b"\0" * 12
    for scale in (b"0", b"x", b"nan", b"inf", b"1e999", b"-0.0", b"2", b"-0.003922"):
        yield Refused(f"scale-{scale.decode()}.pfm", b"PF 1 1 %s\n" % scale + body, "its scale is .*; allowed are 1 and -1, since programs")
    yield Refused("alpha.pfm", b"PF4\n1 1\n-1\n" + body, "is no image that can be read")
    yield Refused("longer.pfm", b"PF 1 1 -1\n" + body + b"x", "1 bytes longer than its pixels")
