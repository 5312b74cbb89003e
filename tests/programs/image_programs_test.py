#!/usr/bin/env python3
"""image_programs_test.py IMAGE_VALUES SCRATCH: what the image readers make of the files of image_cases.py, against what
Pillow, ImageMagick, netpbm and OpenImageIO make of them, as far as these are installed; with fewer than two of them the
test is skipped (77). Where they are at odds with each other, a file fails if more of them agree on another picture than on
ours. A program that refuses a file, or has fewer bits than it, says nothing of it, or nothing
beyond its bits.
"""
from concurrent.futures import ThreadPoolExecutor
import pathlib
import re
import shutil
import struct
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import image_cases
from image_values import read

try:
    import PIL.Image
except ImportError:
    PIL = None

SKIPPED = 77

def pillow(file):
    """The pixels, with None for what the program cannot say, and the steps of its values."""
    image = PIL.Image.open(file)
    image.load()
    if image.mode in ("I;16", "I", "F"):
        data = image.tobytes()
        values = struct.unpack({"I;16": "<%dH", "I": "=%di", "F": "=%df"}[image.mode] % (image.width * image.height), data)
        scale = 1.0 if image.mode == "F" else 65535.0
        return [[value / scale] * 3 for value in values], 1e-6 if image.mode == "F" else 1 / 65535
    mode = "RGBA" if "A" in image.mode or "transparency" in image.info else "RGB"
    values = [value / 255 for value in image.convert(mode).tobytes()]
    return [values[i:i + len(mode)] for i in range(0, len(values), len(mode))], 1 / 255


def within(pixels):
    """Without what is 0 or 1 in a program that has nothing below and above."""
    return [[value if 0 < value < 1 else None for value in pixel[:3]] for pixel in pixels]


def image_magick(file):
    kind = FORMATS[file.name]
    # The format before the name counts, whatever the ending. A BMP file is read with 8 bits.
    data = output("convert", f"{kind}:{file}", "-depth", "16", "-endian", "LSB", "rgba:-")
    values = [value / 65535 for value in struct.unpack(f"<{len(data) // 2}H", data)]
    pixels = [values[i:i + 4] for i in range(0, len(values), 4)]
    return within(pixels) if kind == "PFM" else pixels, 1 / 255 if kind == "BMP" else 1 / 65535


def netpbm(file):
    kind = FORMATS[file.name]
    command = {"PNG": ["pngtopam", "-alphapam"], "BMP": ["bmptopnm"], "PFM": ["pfmtopam", "-maxval=65535"]}
    pixels, step = pam(output(*command.get(kind, ["pamtopam"]), file))
    return within(pixels) if kind == "PFM" else pixels, step


def pam(data):
    """The pixels of a PBM, PGM, PPM or PAM that netpbm writes."""
    if data[:2] == b"P7":
        header, data = data.split(b"ENDHDR\n", 1)
        words = dict(line.split(b" ", 1) for line in header.split(b"\n")[1:] if b" " in line)
        depth, maximum = int(words[b"DEPTH"]), int(words[b"MAXVAL"])
        count = int(words[b"WIDTH"]) * int(words[b"HEIGHT"])
    else:
        is_bitmap = data[:2] == b"P4"
        match = re.match(rb"P[456]\s(\d+) (\d+)\n" + (b"" if is_bitmap else rb"(\d+)\n"), data)
        width, count = int(match[1]), int(match[1]) * int(match[2])
        depth, maximum, data = 3 if data[:2] == b"P6" else 1, 1 if is_bitmap else int(match[3]), data[match.end():]
        if is_bitmap:
            row = (width + 7) // 8
            data = bytes(1 - (data[y * row + x // 8] >> (7 - x % 8) & 1) for y in range(count // width) for x in range(width))
    values = struct.unpack(f">{count * depth}{'H' if maximum > 255 else 'B'}", data)
    pixels = [[v / maximum for v in values[i:i + depth]] for i in range(0, len(values), depth)]
    return [pixel if depth > 2 else [pixel[0]] * 3 + pixel[1:] for pixel in pixels], 1 / maximum


def open_image_io(file):
    text = output("oiiotool", "--iconfig", "oiio:UnassociatedAlpha", "1", "--dumpdata", file).decode()
    pixels = []
    for line in re.findall(r"Pixel \(\d+, \d+\): (.*)", text):
        inside = re.search(r"\((.*)\)", line)
        pixels.append([float(word) for word in (inside[1] if inside else line).split()])
    if not pixels:
        raise ValueError("no pixels")
    channels, step = re.search(r"(\d+) channel, (\S+) ", text).groups()
    pixels = [pixel if len(pixel) > 2 else [pixel[0]] * 3 + pixel[1:] for pixel in pixels]
    return pixels, 1e-6 if step == "float" else 1 / 65535 if step.startswith("uint16") else 1 / 255


def output(*command):
    result = subprocess.run(command, capture_output=True, timeout=60)
    if result.returncode != 0 or not result.stdout:
        raise ValueError(result.stderr.decode(errors="replace").strip())
    return result.stdout


FORMATS = {}
PROGRAMS = {
    "Pillow": (pillow, PIL is not None), "ImageMagick": (image_magick, shutil.which("convert")),
    "netpbm": (netpbm, shutil.which("pngtopam") and shutil.which("bmptopnm") and shutil.which("pamtopam")),
    "OpenImageIO": (open_image_io, shutil.which("oiiotool")),
}


def agree(a, b, step):
    """Whether pixels are the same, to within a step; of an alpha that one side has not nothing is said."""
    def same(x, y):
        return x is None or y is None or x == y or (x != x and y != y) or abs(x - y) <= 1.01 * step * max(1, abs(x))
    padded = (list(pixel) + [None] * (4 - len(pixel)) for pixels in zip(a, b) for pixel in pixels)
    return len(a) == len(b) and all(same(x, y) for p, q in zip(padded, padded) for x, y in zip(p, q))


def leaves_masks_unread(reader, data):
    """netpbm takes no notice of the masks of a BMP file, OpenImageIO of those of 32 bits."""
    if data[:2] != b"BM" or data[30:34] not in (b"\3\0\0\0", b"\6\0\0\0"):
        return False
    return reader is netpbm or (reader is open_image_io and data[28] == 32)


def read_by(reader, file):
    if leaves_masks_unread(reader, file.read_bytes()):
        return None
    try:
        return reader(file)
    except (ValueError, OSError, SyntaxError, struct.error, TypeError, AttributeError, NotImplementedError):
        return None


def judge(name, ours, readings):
    """The programs that agree with us, and whether more agree on another picture."""
    agreeing = [program for program, (pixels, step) in readings.items() if agree(ours, pixels, step)]
    others = {program: reading for program, reading in readings.items() if program not in agreeing}
    most = max((sum(agree(a, b, s + t) for b, t in others.values()) for a, s in others.values()), default=0)
    if others:
        print(f"{name}: {', '.join(others)} {'has' if len(others) == 1 else 'have'} another picture"
              f"{', each its own' if most == 1 < len(others) else ''}; like ours: {', '.join(agreeing) or 'none'}")
    return agreeing, most > max(len(agreeing), 1)


def main():
    available = {name: reader for name, (reader, is_there) in PROGRAMS.items() if is_there}
    for name in PROGRAMS.keys() - available.keys():
        print(f"skipped: {name} is not installed")
    if len(available) < 2:
        return SKIPPED
    program, scratch = sys.argv[1], pathlib.Path(sys.argv[2])
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    cases = list(image_cases.cases())
    for case in cases:
        (scratch / case.name).write_bytes(case.data)
        FORMATS[case.name] = case.format
    results = read(program, [scratch / case.name for case in cases])
    with ThreadPoolExecutor() as pool:
        tasks = [{name: pool.submit(read_by, reader, scratch / case.name) for name, reader in available.items()} for case in cases]
    faults, counts = 0, [[] for _ in range(len(available) + 1)]
    for case, result, readers in zip(cases, results, tasks):
        readings = {name: task.result() for name, task in readers.items() if task.result()}
        agreeing, is_fault = judge(case.name, result[4], readings)
        counts[len(agreeing)].append(case.name)
        if is_fault:
            faults += 1
            print(f"FAILED: {case.name}")
    for count, names in enumerate(counts):
        print(f"{len(names)} files agree with {count} programs" + (": " + " ".join(names) if count < 2 else ""))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
