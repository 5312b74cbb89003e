#!/usr/bin/env python3
"""exr_test.py PROGRAMS SCENES SCRATCH: the EXR files of the programs, by a reader of its own.

A picture holds the linear light of what the PFM file holds, a crop that part of the whole, --half the same in 16 bits;
lavaray-diff takes it back to display values, and lavaray-merge writes the bits that lavaray does. The layers are the
numbers behind the views, which the PFM files of --view show.
"""
import math
import pathlib
import struct
import subprocess
import sys
import zlib

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, finish

programs, scenes, scratch = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
scratch.mkdir(parents=True, exist_ok=True)


def run(program, *arguments, code=0):
    result = subprocess.run([programs / program, *map(str, arguments)], cwd=scratch, capture_output=True, text=True)
    check(result.returncode == code, f"{program} {arguments} exits with {result.returncode}: {result.stderr}")
    return result.stdout + result.stderr


def unpacked(block, size):
    """A block of ZIP: bytes that were parted into the even and the odd ones and replaced by differences."""
    if len(block) == size:
        return block
    data = bytearray(zlib.decompress(block))
    for i in range(1, size):
        data[i] = (data[i - 1] + data[i] - 128) & 255
    result = bytearray(size)
    result[0::2] = data[: (size + 1) // 2]
    result[1::2] = data[(size + 1) // 2 :]
    return bytes(result)


def read_exr(name):
    """The channels, each row by row, the size, and the texts of a file of scan lines that ZIP compresses."""
    data = (scratch / name).read_bytes()
    assert data[:8] == b"\x76\x2f\x31\x01\x02\0\0\0", name
    at = 8
    attributes = {}

    def word():
        nonlocal at
        end = data.index(b"\0", at)
        text, at = data[at:end].decode(), end + 1
        return text

    while data[at]:
        key, kind = word(), word()
        (size,) = struct.unpack_from("<i", data, at)
        attributes[key] = (kind, data[at + 4 : at + 4 + size])
        at += 4 + size
    at += 1
    assert attributes["compression"][1] == b"\3" and attributes["lineOrder"][1] == b"\0", name
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"][1])
    assert (x0, y0) == (0, 0) and attributes["displayWindow"] == attributes["dataWindow"], name
    width, height = x1 + 1, y1 + 1
    kinds = {}
    described = attributes["channels"][1]
    while described[0]:
        channel, described = described.split(b"\0", 1)
        kinds[channel.decode()] = {1: "e", 2: "f"}[described[0]]
        described = described[16:]
    channels = {channel: [] for channel in kinds}
    sizes = {"e": 2, "f": 4}
    row = width * sum(sizes[kind] for kind in kinds.values())
    for (begin,) in struct.iter_unpack("<Q", data[at : at + 8 * math.ceil(height / 16)]):
        first, size = struct.unpack_from("<2i", data, begin)
        rows = min(16, height - first)
        pixels = unpacked(data[begin + 8 : begin + 8 + size], rows * row)
        place = 0
        for _ in range(rows):
            for channel, kind in kinds.items():
                channels[channel] += struct.unpack_from(f"<{width}{kind}", pixels, place)
                place += width * sizes[kind]
    texts = {key: value.decode() for key, (kind, value) in attributes.items() if kind == "string"}
    return channels, kinds, (width, height), texts


def read_pfm(name):
    """The values, three a pixel, row by row from the top, and the size."""
    kind, size, scale, data = (scratch / name).read_bytes().split(b"\n", 3)
    assert kind == b"PF" and float(scale) > 0, name
    width, height = map(int, size.split())
    values = struct.unpack(f">{3 * width * height}f", data)
    rows = [values[3 * width * y : 3 * width * (y + 1)] for y in range(height)]
    return [value for row in reversed(rows) for value in row], (width, height)


def light(color):
    """IEC 61966-2-1."""
    return color / 12.92 if color <= 0.04045 else ((color + 0.055) / 1.055) ** 2.4


def shown(name):
    """What lavaray-diff reads."""
    return run("lavaray-diff", name, name)


def colors(channels):
    return [value for pixel in zip(channels["R"], channels["G"], channels["B"]) for value in pixel]


def test_picture():
    options = [scenes / "showcase.txt", "--width", 151, "--spp", 4]
    for output in ("a.exr", "a.pfm", "a.png"):
        run("lavaray", *options, "-o", output)
    run("lavaray", *options, "--half", "-o", "half.exr")
    channels, kinds, size, texts = read_exr("a.exr")
    expected, pfm_size = read_pfm("a.pfm")
    check(kinds == {"B": "f", "G": "f", "R": "f"} and size == pfm_size, f"channels {kinds}, size {size}")
    off = max(abs(a - light(b)) for a, b in zip(colors(channels), expected, strict=True))
    check(off <= 2**-24, f"the light is off by {off}")
    info = run("lavaray-diff", "--info", "a.png")
    for keyword in ("Software", "Scene", "Size", "Seed", "Device"):
        line = next((line for line in info.splitlines() if line.startswith(keyword + " ")), "not there")
        check(keyword in texts, f"the text {keyword} is missing: {texts}")
        check(line[len(keyword) :].strip() == texts.get(keyword), f"{line}, in EXR {texts.get(keyword)}")
        check(keyword in run("lavaray-diff", "--info", "a.exr"), f"--info says nothing of {keyword}")

    halves, kinds, _, _ = read_exr("half.exr")
    check(set(kinds.values()) == {"e"}, f"--half has channels {kinds}")
    for a, b in zip(colors(halves), expected, strict=True):
        if abs(a - light(b)) > max(light(b) * 2**-11, 2**-25):
            check(False, f"{a} is not {light(b)} in 16 bits")
    run("lavaray-diff", "half.exr", "a.exr", "--tolerance", "0.06")

    output = run("lavaray-diff", "a.exr", "a.pfm", "--max-rmse", "1e-9")
    check("note         IMAGE holds linear light" in output, f"lavaray-diff says {output}")
    run("lavaray-diff", "a.exr", "a.png", "--tolerance", "1")
    run("lavaray-diff", "half.exr", "a.pfm", "-o", "difference.exr", code=10)
    values = colors(read_exr("difference.exr")[0])
    check(max(values) == 1.0, f"the largest difference is {max(values)}")


def test_crop_and_merge():
    options = [scenes / "extensions.txt", "--width", 90, "--height", 60, "--spp", 4]
    run("lavaray", *options, "-o", "whole.exr")
    whole = read_exr("whole.exr")[0]
    run("lavaray", *options, "--crop", "10,7,71,52", "-o", "crop.exr")
    crop, _, size, texts = read_exr("crop.exr")
    check(size == (61, 45), f"the crop has size {size}")
    check("pixels 10,7 to 71,52" in texts["Size"], f"the crop's size is {texts['Size']}")
    for channel, values in crop.items():
        part = [whole[channel][90 * y + x] for y in range(7, 52) for x in range(10, 71)]
        check(values == part, f"channel {channel} of the crop is not that of the whole")
    for i in range(3):
        run("lavaray", *options, "--crop", f"0,{20 * i},90,{20 * i + 20}", "-o", f"part-{i}.film")
    run("lavaray-merge", *(f"part-{i}.film" for i in range(3)), "-o", "merged.exr")
    check(read_exr("merged.exr")[0] == whole, "the merged picture is another one")
    run("lavaray-merge", *(f"part-{i}.film" for i in range(3)), "-o", "merged.exr", "--half")
    check(read_exr("merged.exr")[1]["R"] == "e", "lavaray-merge --half has another precision")


def layer(name, channels):
    data, kinds, size, texts = read_exr(name)
    check(list(kinds) == channels and set(kinds.values()) == {"f"}, f"{name} has channels {kinds}")
    check(texts.get("Layer") == name.split(".")[1], f"{name} is the layer {texts}")
    return data, size


def test_layers():
    options = [scenes / "spheres.txt", "--width", 80]
    for options, spp in ((options, []), (options + ["--crop", "11,5,70,41"], ["--spp", 9])):
        run("lavaray", *options, *spp, "--half", "--layers", "normal,depth,object,samples", "-o", "b.exr")
        views = {}
        for view in ("normal", "depth", "object"):
            run("lavaray", *options, "--view", view, "-o", f"{view}.pfm")
            views[view], view_size = read_pfm(f"{view}.pfm")
        normals, size = layer("b.normal.exr", ["B", "G", "R"])
        depths = layer("b.depth.exr", ["Y"])[0]["Y"]
        objects = layer("b.object.exr", ["Y"])[0]["Y"]
        samples = layer("b.samples.exr", ["Y"])[0]["Y"]
        check(size == view_size, f"the layers have size {size}, the views {view_size}")
        is_hit = [any(views["object"][3 * i : 3 * i + 3]) for i in range(len(depths))]
        check(0 < sum(is_hit) < len(is_hit), "the scene has no background, or nothing before it")
        # The view is in proportion to the largest depth of the whole picture.
        scale = next(depth / shown for depth, shown, hit in zip(depths, views["depth"][::3], is_hit) if hit)
        colors_of = {}
        for i, hit in enumerate(is_hit):
            normal = [normals[channel][i] for channel in "RGB"]
            if not hit:
                check(normal == [0, 0, 0] and depths[i] == math.inf and objects[i] == 0, f"background {i}")
                continue
            off = max(abs(n / 2 + 0.5 - shown) for n, shown in zip(normal, views["normal"][3 * i :]))
            check(off < 1e-6 and abs(math.hypot(*normal) - 1) < 1e-6, f"normal {i} is {normal}")
            check(math.isclose(depths[i], scale * views["depth"][3 * i], rel_tol=1e-6), f"depth {i} is {depths[i]}")
            colors_of.setdefault(objects[i], set()).add(tuple(views["object"][3 * i : 3 * i + 3]))
        check(all(number == int(number) and number >= 1 for number in colors_of), f"objects are {list(colors_of)}")
        check(all(len(each) == 1 for each in colors_of.values()), "an object has two colours in its view")
        check(len(set().union(*colors_of.values())) == len(colors_of) > 1, "two objects have one number")
        check(set(samples) == {9.0 if spp else 1.0}, f"samples are {set(samples)}")
        output = run("lavaray-diff", "b.depth.exr", "b.depth.exr")
        check("numbers of a layer, which are taken as they are; its one channel Y is grey" in output, f"lavaray-diff: {output}")


def test_estimates():
    """samples and error, which are those that the views show of the same render; --normalize renders the whole."""
    options = [scenes / "extensions.txt", "--width", 60, "--target-error", 0.02]
    for crop in ([], ["--normalize", "--crop", "10,7,51,32"]):
        run("lavaray", *options, *crop, "--layers", "samples,error", "-o", "c.EXR")
        samples = read_exr("c.samples.EXR")[0]["Y"]
        errors = read_exr("c.error.EXR")[0]["Y"]
        for view in ("samples", "error"):
            run("lavaray", *options, "--view", view, "-o", f"{view}.pfm")
        part = [(x, y) for y in range(7, 32) for x in range(10, 51)]
        width, height = read_pfm("error.pfm")[1]
        whole = [(x, y) for y in range(height) for x in range(width)]
        expected = {view: read_pfm(f"{view}.pfm")[0][::3] for view in ("samples", "error")}
        places = [width * y + x for x, y in (part if crop else whole)]
        check(errors == [expected["error"][place] for place in places], "the errors are not the view's")
        most = max(samples) / max(expected["samples"][place] for place in places)
        check(all(math.isclose(a, most * expected["samples"][place], rel_tol=1e-6)
                  for a, place in zip(samples, places, strict=True)), "the samples are not the view's")
        check(len(set(samples)) > 1 and all(sample >= 2 and sample == int(sample) for sample in samples),
              f"samples are {set(samples)}")


def test_files():
    """What cannot be written is found out before, and what is there stays."""
    (scratch / "d.exr").write_text("old")
    folder = scratch / "d.object.exr"
    folder.mkdir(exist_ok=True)
    (scratch / "d.depth.exr").write_text("old")
    output = run("lavaray", scenes / "spheres.txt", "--layers", "depth,object", "-o", "d.exr", code=5)
    check("d.object.exr: cannot be written" in output, output)
    check((scratch / "d.exr").read_text() == "old" == (scratch / "d.depth.exr").read_text(), "an old file is gone")
    check(not list(scratch.glob(".d.*")), "a temporary file is left")


for test in (test_picture, test_crop_and_merge, test_layers, test_estimates, test_files):
    test()
finish()
