#!/usr/bin/env python3
"""diff_test.py PROGRAMS SCRATCH: what lavaray-diff says of images that hold infinity, NaN or alpha, of floats beside
integers, and of depths beside each other. Its figures are compared with those computed here. SCRATCH is made anew."""
import math
import pathlib
import re
import struct
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, finish, make_anew
import image_cases

WIDTH, HEIGHT = image_cases.WIDTH, image_cases.HEIGHT
PIXELS = WIDTH * HEIGHT
DIFFERS = 10
LIMITS = (["--tolerance", "255"], ["--max-differing", "1000"], ["--max-rmse", "1e30"], ["--max-flip", "1"],
          ["--tolerance", "255", "--max-differing", "1000", "--max-rmse", "1e30", "--max-flip", "1"])

programs, scratch = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])


def holds(what, condition):
    check(condition, what, diff.found)


def diff(image, reference, *options):
    """The exit code, and what is printed, by the words that its lines begin with."""
    result = subprocess.run([programs / "lavaray-diff", image, reference, *options], cwd=scratch, capture_output=True, text=True)
    diff.found = result
    holds("no number that is printed is NaN", not re.search(r"(?<![a-z])-?nan\b", result.stdout))
    return result.returncode, {line[:13].strip(): line[13:] for line in result.stdout.splitlines()}


def write(name, data):
    (scratch / name).write_bytes(data)
    return name


def pfm(name, pixels):
    return write(name, image_cases.pfm(pixels, 3, "<"))


def changed(pixels, changes):
    """A copy with other values: of pixel and channel."""
    result = [list(pixel) for pixel in pixels]
    for (pixel, channel), value in changes.items():
        result[pixel][channel] = value
    return result


def at(pixel):
    return f"{pixel % WIDTH},{pixel // WIDTH}"


def not_finite():
    grey = [[0.25, 0.5, 0.75] for _ in range(PIXELS)]
    odd = {(3, 0): math.nan, (9, 1): math.inf, (10, 2): -math.inf}
    plain, holes = pfm("plain.pfm", grey), pfm("holes.pfm", changed(grey, odd))
    code, said = diff(holes, holes)
    holds("a file is equal to itself", code == 0 and said["differing"] == f"0 of {PIXELS} pixels")
    holds("equal ones are counted", said["not finite"] == "0 pixels differ by infinity or NaN; 3 are the same in both")
    holds("an equal file has no error", said["RMSE"] == "0" and said["PSNR"] == "inf dB" and said["mean FLIP"] == "0")
    for options in LIMITS:
        holds("what is the same is within the limits", diff(holes, holes, *options)[0] == 0)
    code, said = diff(holes, plain, "-o", "picture.ppm")
    holds("NaN is no number", code == DIFFERS and said["differing"] == f"3 of {PIXELS} pixels")
    holds("they have a line", said["not finite"] ==
          f"3 pixels differ by infinity or NaN, the first at {at(3)}; 0 are the same in both")
    holds("figures are over the finite", said["finite"].startswith(f"{PIXELS - 3} pixels in both images") and
          said["RMSE"] == "0" and said["largest"].startswith("0 / 255"))
    magenta = [i for i in range(PIXELS) if (scratch / "picture.ppm").read_bytes()[-3 * PIXELS:][3 * i:3 * i + 3] == b"\xff\0\xff"]
    holds("they are seen in the picture", magenta == [3, 9, 10])
    for options in LIMITS:
        holds(f"each limit fails: {options}", diff(holes, plain, *options)[0] == DIFFERS)
        holds(f"each limit fails, the other way round: {options}", diff(plain, holes, *options)[0] == DIFFERS)
    for name, value, other, same in (
            ("+inf", math.inf, math.inf, True), ("-inf", -math.inf, -math.inf, True), ("NaN", math.nan, math.nan, True),
            ("infinities", math.inf, -math.inf, False), ("infinity and NaN", math.inf, math.nan, False)):
        code, said = diff(pfm("a.pfm", changed(grey, {(5, 1): value})), pfm("b.pfm", changed(grey, {(5, 1): other})))
        holds(f"{name}", (code == 0) == same and said["not finite"].startswith("0" if same else "1"))
    # Beside them, another pixel differs: the picture shows both.
    near = pfm("near.pfm", changed(grey, {(20, 0): 0.5, (21, 2): 0.625}))
    code, said = diff(holes, near, "-o", "picture.ppm")
    rmse = math.sqrt((0.25 ** 2 + 0.125 ** 2) / (3 * (PIXELS - 3)))
    holds("the finite ones are measured", math.isclose(float(said["RMSE"]), rmse, rel_tol=1e-5) and
          said["largest"] == f"63.75 / 255 at {at(20)}" and 0 < float(said["mean FLIP"]) < 1 and
          said["differing"] == f"5 of {PIXELS} pixels")
    picture = (scratch / "picture.ppm").read_bytes()[-3 * PIXELS:]
    holds("the picture has both", picture[60:66] == b"\xff\0\0\0\0\x7f" and picture[9:12] == b"\xff\0\xff")
    nothing = pfm("nothing.pfm", [[math.nan] * 3] * PIXELS)
    holds("no number at all is equal to itself", diff(nothing, nothing)[0] == 0)
    holds("no number at all is nothing else", diff(nothing, plain)[0] == DIFFERS)
    integers = write("holes.png", image_cases.png([[63, 127, 191]] * PIXELS, "rgb", 8))
    holds("an 8-bit image has neither", diff(holes, integers)[1]["not finite"].startswith("3 pixels differ"))
    large = pfm("large.pfm", changed(grey, {(0, 0): 3e38})), pfm("small.pfm", changed(grey, {(0, 0): -3e38}))
    code, said = diff(*large, "-o", "picture.ppm")
    holds("what a float cannot hold is a finite difference", code == DIFFERS and "inf" not in said["RMSE"])
    holds("and is seen", (scratch / "picture.ppm").read_bytes()[-3 * PIXELS:][:3] == b"\xff\0\0")


def alpha():
    pixels = image_cases.pixels([255] * 4)
    pixels[4][3], pixels[6] = 200, [10, 20, 30, 0]
    opaque = write("opaque.png", image_cases.png([p[:3] for p in pixels], "rgb", 8))
    image = write("alpha.png", image_cases.png(pixels, "rgba", 8))
    code, said = diff(image, image)
    holds("equal alpha is equal", code == 0 and said["alpha"] == "0 pixels differ, largest 0 / 255 at 0,0, RMSE 0")
    holds("without alpha nothing is said of it", "alpha" not in diff(opaque, opaque)[1])
    other = write("other.png", image_cases.png(changed(pixels, {(4, 3): 151}), "rgba", 8))
    code, said = diff(image, other, "-o", "picture.ppm")
    rmse = 49 / 255 / math.sqrt(PIXELS)
    match = re.fullmatch(r"1 pixels differ, largest 49 / 255 at 4,0, RMSE ([0-9.e-]+)", said["alpha"])
    holds("another alpha differs", code == DIFFERS and said["differing"].startswith("1 of ") and said["RMSE"] == "0")
    holds("its line says how", match and math.isclose(float(match[1]), rmse, rel_tol=1e-5))
    holds("it is grey in the picture", (scratch / "picture.ppm").read_bytes()[-3 * PIXELS:][12:15] == b"\xff" * 3)
    holds("FLIP sees it", float(said["mean FLIP"]) > 0)
    holds("its error has a limit", diff(image, other, "--max-rmse", str(rmse * 0.99))[0] == DIFFERS and
          diff(image, other, "--max-rmse", str(rmse * 1.01))[0] == 0)
    holds("its tolerance is that of colours", diff(image, other, "--tolerance", "48")[0] == DIFFERS and
          diff(image, other, "--tolerance", "49")[0] == 0)
    said = diff(image, opaque)[1]["alpha"]
    count = sum(p[3] != 255 for p in pixels)
    holds("no alpha is an alpha of 1", said.startswith(f"{count} pixels differ, largest 255 / 255 at 0,0") and
          said.endswith("; REFERENCE has none, which is 1"))
    holds("whichever has none", diff(opaque, image)[1]["alpha"].endswith("; IMAGE has none, which is 1"))
    full = write("full.png", image_cases.png([p[:3] + [255] for p in pixels], "rgba", 8))
    holds("an opaque alpha is as good as none", diff(full, opaque)[0] == 0)
    unseen = write("unseen.png", image_cases.png(changed(pixels, {(6, 0): 99}), "rgba", 8))
    code, said = diff(image, unseen)
    holds("a colour that nobody sees differs, but FLIP does not see it", code == DIFFERS and said["mean FLIP"] == "0")


def depths():
    deep = image_cases.pixels([65535] * 3)
    deep[12] = [1000, 2000, 3000]
    first = write("deep.png", image_cases.png(deep, "rgb", 16))
    for off in (1, 120):
        second = write("off.png", image_cases.png(changed(deep, {(12, 1): 2000 + off}), "rgb", 16))
        for options in ([], ["--tolerance", "0"]):
            code, said = diff(first, second, *options)
            holds(f"16 bits that differ by {off}", code == DIFFERS and said["differing"].startswith("1 of ") and
                  math.isclose(float(said["largest"].split()[0]), off / 257, rel_tol=1e-4))
    shallow = image_cases.pixels([255] * 3)
    eight = write("eight.ppm", b"P6 %d %d 255\n" % (WIDTH, HEIGHT) + image_cases.pnm_raster(shallow, 255))
    sixteen = [[257 * v for v in p] for p in shallow]
    wide = write("wide.ppm", b"P6 %d %d 65535\n" % (WIDTH, HEIGHT) + image_cases.pnm_raster(sixteen, 65535))
    holds("8 bits are equal to the same in 16", diff(eight, wide)[0] == 0)
    sixteen[8][0] = sixteen[8][0] - 1 if sixteen[8][0] else 1
    wide = write("wide.ppm", b"P6 %d %d 65535\n" % (WIDTH, HEIGHT) + image_cases.pnm_raster(sixteen, 65535))
    code, said = diff(eight, wide)
    holds("and to nothing beside it", code == DIFFERS and said["differing"].startswith("1 of ") and "compared as" not in said)
    for level in (1, 7, 100):
        other = changed(shallow, {(5, 2): (shallow[5][2] + level) % 256})
        off = abs(other[5][2] - shallow[5][2])
        name = write("levels.ppm", b"P6 %d %d 255\n" % (WIDTH, HEIGHT) + image_cases.pnm_raster(other, 255))
        holds("a difference of T levels is within T", diff(eight, name, "--tolerance", str(off))[0] == 0 and
              diff(eight, name, "--tolerance", str(off - 0.001))[0] == DIFFERS)


def floats():
    colors = [[image_cases.RANDOM.uniform(-0.2, 1.2) for _ in range(3)] for _ in range(PIXELS)]
    picture = pfm("picture.pfm", colors)
    stored = [[image_cases.as_float32(v) for v in p] for p in colors]
    for maximum in (255, 65535):
        values = [[int(maximum * min(max(v, 0.0), 1.0)) for v in p] for p in stored]
        name = write(f"{maximum}.ppm", b"P6 %d %d %d\n" % (WIDTH, HEIGHT, maximum) + image_cases.pnm_raster(values, maximum))
        code, said = diff(picture, name, "--tolerance", "0", "--max-flip", "0")
        holds(f"floats are equal to themselves in {maximum} levels", code == 0 and said["RMSE"] == "0")
        holds("it is said", said["compared as"] ==
              f"trunc({maximum} c): the floats c of IMAGE as a file like the other would hold them")
        code, said = diff(name, picture)
        holds("the other way round", code == 0 and "the floats c of REFERENCE" in said["compared as"])
        values[7][1] += 1 if values[7][1] < maximum else -1
        other = write("other.ppm", b"P6 %d %d %d\n" % (WIDTH, HEIGHT, maximum) + image_cases.pnm_raster(values, maximum))
        holds("a level off differs", diff(picture, other)[0] == DIFFERS)
    ramp = [[3 * i % 256, (3 * i + 1) % 256, (3 * i + 2) % 256] for i in range(PIXELS)]
    floats_of = pfm("ramp.pfm", [[image_cases.as_float32((v, 255)) for v in p] for p in ramp])
    holds("an 8-bit file made floats is equal to it", diff(floats_of, write("ramp.png", image_cases.png(ramp, "rgb", 8)))[0] == 0)
    mask = (0xF800, 0x7E0, 0x1F)
    case = image_cases.bmp_masked("a", 40, 16, mask)
    write("a.bmp", case.data)
    code, said = diff(pfm("a.pfm", [[image_cases.as_float32(v) for v in p] for p in case.values]), "a.bmp")
    holds("each channel has its levels", code == 0 and said["compared as"].startswith("trunc(31 c), trunc(63 c): "))
    holds("floats are compared with floats as they are", "compared as" not in diff(picture, picture)[1])


def notes():
    write("lies.bmp", image_cases.png([[5] * 3] * PIXELS, "rgb", 8))
    holds("an ending that lies is named", "IMAGE is read as the PNG image that it is, not as its ending says" ==
          diff("lies.bmp", "lies.bmp")[1].get("note", "").replace("REFERENCE", "IMAGE"))
    result = subprocess.run([programs / "lavaray-diff", "--info", "lies.bmp"], cwd=scratch, capture_output=True, text=True)
    for line in ("format +PNG", "values +0 to 255", "alpha +no", "note +is read as the PNG image that it is.*"):
        holds(f"--info says {line}", re.search(f"^{line}$", result.stdout, re.M))
    gamma = image_cases.chunk(b"gAMA", struct.pack(">I", 100000))
    write("gamma.png", image_cases.png([[5] * 3] * PIXELS, "rgb", 8, extra=gamma))
    code, said = diff("gamma.png", "lies.bmp")
    holds("numbers are compared, not what gamma makes of them", code == 0)
    result = subprocess.run([programs / "lavaray-diff", "/dev/stdin", "lies.bmp"], cwd=scratch, capture_output=True,
                            input=(scratch / "gamma.png").read_bytes())
    holds("an image may come through a pipe", result.returncode == 0)
    holds("gamma is named", b"IMAGE its gamma of 1 (gAMA) is not applied" in result.stdout)


make_anew(scratch)
diff.found = None
for part in (not_finite, alpha, depths, floats, notes):
    part()
finish()
