"""PBM, PGM and PPM."""
import struct

from image_cases.common import HEIGHT, WIDTH, Case, Refused, grey, packed_row, paired, pixels, rows


def pnm_raster(values, maximum):
    return b"".join(struct.pack(">H" if maximum > 255 else "B", v) for pixel in values for v in pixel)


def pnm_text(values):
    return b"\n".join(b" ".join(b"%d" % v for v in pixel) for pixel in values) + b"\n"


def bitmap_raster(values):
    return b"".join(packed_row([pixel[0] for pixel in row], 1) for row in rows(values))


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
